import * as store from "../store";

const kHints = {
  my_pose: "tapMyPose",
  my_goal: "tapMyGoal",
  robot_goal: "tapRobotGoal",
  robot_pose: "tapRobotPose",
  found: "tapFoundIt",
} as const;

/** One line of its own between map and tools, so that no message ever covers a control. */
export function ToastStrip() {
  const texts = store.t.value;
  const toast = store.toast.value;
  const found = store.foundAt.value;
  const inform = store.inform.value;
  let text: string = texts[kHints[store.tool.value]];
  let tone = "hint";
  if (toast !== undefined) {
    text = toast.text;
    tone = toast.tone;
  } else if (inform !== undefined) {
    return (
      <div class="toast plain inform" role="status">
        <span>{inform.text}</span>
        {store.hello.value?.role !== "observer" && (
          <button type="button" onClick={store.gotIt}>
            {texts.gotIt}
          </button>
        )}
      </div>
    );
  } else if (found !== undefined) {
    text = `★ ${texts.foundBy}`;
    tone = "good";
  } else if (store.waiting.value > 0 && !store.isConnected.value) {
    text = `${store.waiting.value} × ${texts.queued}`;
    tone = "bad";
  } else if (store.hasLostMe.value && store.tool.value === "my_pose") {
    text = texts.lostYou;
    tone = "bad";
  }
  return (
    <p class={`toast ${tone}`} role="status">
      {text}
    </p>
  );
}
