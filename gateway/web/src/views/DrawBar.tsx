import * as store from "../store";
import { Choice } from "./Choice";

/** In place of the tools while something is drawn: how much, for whom, and send. */
export function DrawBar(props: { drawing: store.Drawing }) {
  const texts = store.t.value;
  const { edit, outline, strength, target } = props.drawing;
  const whom = { everybody: texts.everybody, robot: texts.forRobot, me: texts.forMe };
  const targets = store.targetsOf(edit);
  return (
    <section class="tools draw-bar" aria-label={texts[edit]}>
      <Choice
        legend={texts.strength}
        words={store.strengthsOf(edit)}
        chosen={strength}
        text={(word) => texts[word]}
        choose={(word) => store.setDrawing({ strength: word })}
      />
      {targets.length > 0 && (
        <Choice
          legend={texts.forWhom}
          words={targets}
          chosen={target}
          text={(word) => whom[word]}
          choose={(word) => store.setDrawing({ target: word })}
        />
      )}
      <div class="tool-row">
        <button type="button" class="second" onClick={store.cancelDrawing}>
          {texts.cancel}
        </button>
        <button
          type="button"
          class="replan"
          data-button="send"
          aria-disabled={outline.length === 0}
          onClick={store.sendDrawing}
        >
          {texts.send}
        </button>
      </div>
    </section>
  );
}
