import { useEffect, useRef, useState } from "preact/hooks";
import * as store from "../store";

const kHoldMs = 1000;

/** Always there, above everything, and it takes the first touch: not the click that follows. */
export function StopButton() {
  const pressedAt = useRef(0);
  return (
    <button
      type="button"
      class="stop"
      aria-label={store.t.value.stopLabel}
      onPointerDown={() => {
        pressedAt.current = performance.now();
        store.stop();
      }}
      onClick={() => {
        if (performance.now() - pressedAt.current > 1500) store.stop(); // keyboard or screen reader: no touch before
      }}
    >
      {store.t.value.stop}
    </button>
  );
}

/** Shown while the robot is stopped: continues only after it was held for a second. */
export function ResumeBar() {
  const [heldSince, setHeldSince] = useState<number | undefined>(undefined);
  useEffect(() => {
    if (heldSince === undefined) return undefined;
    const timer = setTimeout(() => {
      store.resume(performance.now() - heldSince);
      setHeldSince(undefined);
    }, kHoldMs + 50);
    return () => clearTimeout(timer);
  }, [heldSince]);
  const begin = () => setHeldSince(performance.now());
  const end = () => setHeldSince(undefined);
  return (
    <button
      type="button"
      class={heldSince === undefined ? "resume" : "resume held"}
      onPointerDown={begin}
      onPointerUp={end}
      onPointerLeave={end}
      onPointerCancel={end}
      onKeyDown={(event) => {
        if (!event.repeat && (event.key === " " || event.key === "Enter")) begin();
      }}
      onKeyUp={end}
    >
      <strong>{store.t.value.stoppedBanner}.</strong> {store.t.value.resume}
    </button>
  );
}
