import { signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import * as store from "../store";

/** The person has said that they will show it: the map is free for that, and for nothing else. */
const isPlacing = signal(false);

/** The pop-up reminder: nothing but STOP and the strip works until My pose is placed. It cannot be gone back from. */
export function PopUp() {
  const button = useRef<HTMLButtonElement>(null);
  useEffect(() => {
    isPlacing.value = false;
    button.current?.focus();
    const stay = () => history.pushState(undefined, "");
    stay();
    window.addEventListener("popstate", stay);
    return () => window.removeEventListener("popstate", stay);
  }, []);
  const texts = store.t.value;
  if (isPlacing.value) return <div class="popup-tools" role="alert">{texts.tapMyPose}</div>;
  return (
    <div class="veil" role="alertdialog" aria-modal="true" aria-labelledby="popup-title" aria-describedby="popup-hint">
      <div class="popup">
        <h2 id="popup-title">{texts.popupTitle}</h2>
        <p id="popup-hint">{store.isBetweenPeople.value ? texts.popupHintPeople : texts.popupHint}</p>
        <button ref={button} type="button" class="primary" onClick={() => (isPlacing.value = true)}>
          {texts.popupGo}
        </button>
      </div>
    </div>
  );
}
