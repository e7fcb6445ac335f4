import { reasonIn } from "../reasons";
import * as store from "../store";

const kHints = {
  my_pose: "tapMyPose",
  my_goal: "tapMyGoal",
  robot_goal: "tapRobotGoal",
  robot_pose: "tapRobotPose",
  found: "tapFoundIt",
} as const;

type Button = { readonly text: string; readonly press: () => void };
type Line = { readonly text: string; readonly tone: string; readonly buttons?: readonly Button[] };

/** The most urgent of what there is to say. */
function line(): Line {
  const texts = store.t.value;
  const inform = store.inform.value;
  const asked = store.askAgain.value;
  if (asked !== undefined) {
    return {
      text: `${texts[store.nameOf(asked)]}: ${texts.stillWanted}`,
      tone: "plain",
      buttons: [
        { text: texts.yes, press: () => store.answerAskAgain(true) },
        { text: texts.no, press: () => store.answerAskAgain(false) },
      ],
    };
  }
  if (store.toast.value !== undefined) return store.toast.value;
  if (store.undo.value !== undefined) {
    const goal = store.undo.value.kind === "clear_my_goal" ? texts.myGoal : texts.robotGoal;
    return { text: goal, tone: "plain", buttons: [{ text: `↶ ${texts.undo}`, press: store.undoGoal }] };
  }
  if (inform !== undefined) {
    const text = reasonIn(store.language.value, inform.text);
    const buttons = store.mayAct.value ? [{ text: texts.gotIt, press: store.gotIt }] : [];
    return { text, tone: "plain inform", buttons };
  }
  if (store.foundAt.value !== undefined) return { text: `★ ${texts.foundBy}`, tone: "good" };
  if (store.session.value?.phase === "ended") return { text: texts.searchOver, tone: "good" };
  if (!store.isConnected.value && store.waiting.value > 0) {
    return { text: `${store.waiting.value} × ${texts.queued}`, tone: "bad" };
  }
  if (store.link.value === "refused") return { text: texts.linkTrouble, tone: "bad" };
  if (store.drawing.value !== undefined) {
    return { text: `${texts[store.drawing.value.edit]}: ${texts.drawHint}`, tone: "hint" };
  }
  if (store.hasLostMe.value && store.tool.value === "my_pose") return { text: texts.lostYou, tone: "bad" };
  return { text: texts[kHints[store.tool.value]], tone: "hint" };
}

/** One line of its own between map and tools, so that no message ever covers a control. */
export function ToastStrip() {
  const { text, tone, buttons = [] } = line();
  return (
    <div class={`toast ${tone}`} role="status">
      <span>{text}</span>
      {buttons.map((button) => (
        <button type="button" key={button.text} onClick={button.press}>
          {button.text}
        </button>
      ))}
    </div>
  );
}
