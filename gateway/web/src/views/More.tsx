import type { Source } from "../protocol/parse";
import * as store from "../store";
import { Icon } from "./Icon";
import { Sheet } from "./Sheet";

/** Robot pose is for the start, for a robot that does not know where it is, and for operators. */
function wantsRobotPose(): boolean {
  const robot = store.state.value?.robot;
  const isBefore = store.session.value?.phase !== "running";
  return store.hello.value?.role === "operator" || isBefore || robot === undefined || robot.status === "lost";
}

/** What is drawn, what is said of the object, and what is drawn already. */
export function More() {
  const texts = store.t.value;
  return (
    <Sheet title={texts.more} name="more">
      <h3>{texts.drawTitle}</h3>
      <div class="edits">
        {store.kSourceEdits.map((edit) => (
          <button
            type="button"
            key={edit}
            data-edit={edit}
            onClick={() => (edit === "stay_behind" ? store.stayBehind() : store.beginDrawing(edit))}
          >
            {texts[edit]}
          </button>
        ))}
      </div>
      <h3>{texts.sayTitle}</h3>
      <div class="edits">
        {store.kBeliefEdits.map((edit) => (
          <button type="button" key={edit} data-edit={edit} onClick={() => store.beginDrawing(edit)}>
            {texts[edit]}
          </button>
        ))}
      </div>
      {wantsRobotPose() && (
        <div class="edits">
          <button
            type="button"
            data-tool="robot_pose"
            onClick={() => {
              store.tool.value = "robot_pose";
              store.sheet.value = undefined;
            }}
          >
            <Icon kind="robot_pose" /> {texts.robotPose}
          </button>
        </div>
      )}
      {store.sources.value.length > 0 && <h3>{texts.drawnTitle}</h3>}
      {store.sources.value.map((source) => (
        <Drawn key={source.id} source={source} />
      ))}
    </Sheet>
  );
}

function Drawn(props: { source: Source }) {
  const texts = store.t.value;
  const { id, edit, targets } = props.source;
  const names = targets.map((one) => (one === store.hello.value?.robot ? texts.robot : texts.you));
  const name = `${texts[edit]}${names.length === 0 ? "" : ` · ${names.join(", ")}`}`;
  return (
    <p class="drawn">
      <span>{name}</span>
      <button type="button" aria-label={`${texts.remove}: ${name}`} onClick={() => store.removeSource(id)}>
        {texts.remove}
      </button>
    </p>
  );
}
