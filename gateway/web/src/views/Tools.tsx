import type { PlaceKind } from "../model/outbox";
import * as store from "../store";
import { ResumeBar } from "./StopButton";

const kLabels = {
  my_pose: "myPose",
  my_goal: "myGoal",
  robot_goal: "robotGoal",
  robot_pose: "robotPose",
  found: "foundIt",
} as const;

function Icon(props: { kind: PlaceKind }) {
  switch (props.kind) {
    case "my_pose":
      return (
        <svg viewBox="0 0 24 24" aria-hidden="true">
          <circle cx="12" cy="12" r="8" class="ink-person" />
        </svg>
      );
    case "my_goal":
      return (
        <svg viewBox="0 0 24 24" aria-hidden="true">
          <path d="M12 2l9 10-9 10-9-10z" class="ink-my-goal" />
        </svg>
      );
    case "robot_goal":
      return (
        <svg viewBox="0 0 24 24" aria-hidden="true">
          <rect x="3" y="3" width="18" height="18" class="ink-robot-goal" />
          <rect x="8" y="8" width="8" height="8" class="hole" />
        </svg>
      );
    case "robot_pose":
      return (
        <svg viewBox="0 0 24 24" aria-hidden="true">
          <rect x="3" y="4" width="18" height="16" class="ink-robot" />
          <path d="M9 8l8 4-8 4z" class="hole-filled" />
        </svg>
      );
    default:
      return (
        <svg viewBox="0 0 24 24" aria-hidden="true">
          <path d="M12 2l3 7 7 .6-5.3 4.7L18.3 22 12 18l-6.3 4 1.6-7.7L2 9.6 9 9z" class="ink-found" />
        </svg>
      );
  }
}

function Tool(props: { kind: PlaceKind }) {
  const selected = store.tool.value === props.kind;
  return (
    <button
      type="button"
      class={`tool ${props.kind}`}
      data-tool={props.kind}
      aria-pressed={selected}
      onClick={() => (store.tool.value = props.kind)}
    >
      <Icon kind={props.kind} />
      <span>{store.t.value[kLabels[props.kind]]}</span>
    </button>
  );
}

/** Robot pose is for the start, for a robot that does not know where it is, and for operators. */
function wantsRobotPose(): boolean {
  const robot = store.state.value?.robot;
  return store.hello.value?.role === "operator" || robot === undefined || robot.status === "lost";
}

/** In reach of the thumb: what a tap on the map means, and Replan. */
export function Tools() {
  const texts = store.t.value;
  if (store.hello.value?.role === "observer") return null;
  const computing = store.state.value?.planner.activity === "computing" ? store.state.value.planner : undefined;
  const seconds = (computing?.computing_s ?? 0) + store.dataAgeMs.value / 1000;
  return (
    <nav class="tools" aria-label={texts.tools}>
      <div class="tool-row">
        <Tool kind="my_pose" />
        <Tool kind="my_goal" />
        <Tool kind="robot_goal" />
        {wantsRobotPose() && <Tool kind="robot_pose" />}
        <Tool kind="found" />
      </div>
      {store.isStopped.value && <ResumeBar />}
      <button type="button" class="replan" data-tool="replan" onClick={store.replan}>
        {computing === undefined ? (
          texts.replan
        ) : (
          <>
            <span class="spinner" aria-hidden="true" /> {texts.computing} · {Math.max(0, Math.round(seconds))}{" "}
            {texts.seconds}
          </>
        )}
      </button>
    </nav>
  );
}
