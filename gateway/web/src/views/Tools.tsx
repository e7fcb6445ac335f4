import { isCounted } from "../model/counters";
import type { PlaceKind } from "../protocol/commands";
import * as store from "../store";
import { DrawBar } from "./DrawBar";
import { Icon } from "./Icon";
import { ResumeBar } from "./StopButton";

const kLabels = {
  my_pose: "myPose",
  my_goal: "myGoal",
  robot_goal: "robotGoal",
  robot_pose: "robotPose",
  found: "foundIt",
} as const;

function Tool(props: { kind: PlaceKind }) {
  const { kind } = props;
  const counts = store.counts.value;
  const blinks = kind === "my_pose" && store.poseBlinks.value;
  return (
    <button
      type="button"
      class={`tool ${kind}${blinks ? " blinks" : ""}`}
      data-tool={kind}
      aria-pressed={store.tool.value === kind}
      onClick={() => (store.tool.value = kind)}
    >
      <Icon kind={kind} />
      <span>{store.t.value[kLabels[kind]]}</span>
      {counts !== undefined && isCounted(kind) && <span class="badge">{counts[kind]}</span>}
    </button>
  );
}

/** In reach of the thumb: what a tap on the map means, and Replan. */
export function Tools() {
  const texts = store.t.value;
  if (!store.mayAct.value) return null;
  if (store.drawing.value !== undefined) return <DrawBar drawing={store.drawing.value} />;
  const people = store.isBetweenPeople.value;
  return (
    <nav class="tools" aria-label={texts.tools}>
      <div class="tool-row">
        <Tool kind="my_pose" />
        <Tool kind="my_goal" />
        {!people && <Tool kind="robot_goal" />}
        {!people && (
          <button
            type="button"
            class="tool"
            data-tool="more"
            aria-expanded={store.sheet.value === "more"}
            onClick={() => (store.sheet.value = "more")}
          >
            <svg viewBox="0 0 24 24" aria-hidden="true">
              <circle cx="5" cy="12" r="2.5" />
              <circle cx="12" cy="12" r="2.5" />
              <circle cx="19" cy="12" r="2.5" />
            </svg>
            <span>{texts.more}</span>
          </button>
        )}
      </div>
      {store.isStopped.value && <ResumeBar />}
      <div class="tool-row">
        <Tool kind="found" />
        {!people && <Replan />}
      </div>
    </nav>
  );
}

function Replan() {
  const texts = store.t.value;
  const seconds = store.computingSeconds.value;
  return (
    <button type="button" class="replan" data-tool="replan" onClick={store.replan}>
      {seconds === undefined ? (
        texts.replan
      ) : (
        <>
          <span class="spinner" aria-hidden="true" /> {texts.computing} · {seconds} {texts.seconds}
        </>
      )}
    </button>
  );
}
