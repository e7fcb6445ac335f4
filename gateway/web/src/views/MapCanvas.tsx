import { effect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { pictureOfBelief, pictureOfMap } from "../draw/bitmaps";
import { drawScene } from "../draw/scene";
import { Gestures } from "../model/gestures";
import { panned, pinched, toMap } from "../model/map_view";
import * as store from "../store";
import { type PointOnScreen, pixels, pointOnScreen, radians } from "../units";

/** More than twice the screen's pixels costs much and shows little. */
const kMaxRatio = 2;

export function MapCanvas() {
  const canvasRef = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const canvas = canvasRef.current;
    return canvas === null ? undefined : attach(canvas);
  }, []);
  return <canvas ref={canvasRef} class="map-canvas" role="img" aria-label={store.t.value.map} />;
}

/** Draws whenever something shown changes, at most once a frame; listens to fingers. Gives its undoing. */
function attach(canvas: HTMLCanvasElement): () => void {
  let pictureFor: typeof store.map.value;
  let mapPicture: HTMLCanvasElement | undefined;
  let heatFor: typeof store.belief.value;
  let beliefPicture: HTMLCanvasElement | undefined;
  let frame = 0;

  const draw = () => {
    frame = 0;
    const view = store.view.value;
    const context = canvas.getContext("2d");
    if (view === undefined || context === null) return;
    if (pictureFor !== store.map.value) {
      pictureFor = store.map.value;
      mapPicture = pictureFor === undefined ? undefined : pictureOfMap(pictureFor);
    }
    if (heatFor !== store.belief.value) {
      heatFor = store.belief.value;
      beliefPicture = heatFor === undefined ? undefined : pictureOfBelief(heatFor);
    }
    const since = Math.max(0, (store.now() - store.stateAt.value) / 1000);
    drawScene(
      context,
      {
        view,
        map: pictureFor,
        mapPicture,
        belief: store.showBelief.value ? heatFor : undefined,
        beliefPicture,
        state: store.state.value,
        plan: store.plan.value,
        robotName: store.hello.value?.robot ?? "",
        chosen: store.chosen.value,
        found: store.foundAt.value?.at,
        stale: store.isStale.value,
        since,
        labels: { you: store.t.value.you, robot: store.t.value.robot },
      },
      Math.min(kMaxRatio, devicePixelRatio),
    );
    // For the browser test: where the map and the team lie.
    canvas.dataset["view"] = [view.centre.x, view.centre.y, view.pixelsPerMetre, view.turn].join(" ");
    const { robot, person } = store.state.value ?? {};
    if (robot !== undefined) canvas.dataset["robot"] = `${robot.x} ${robot.y}`;
    if (person !== undefined) canvas.dataset["person"] = `${person.x} ${person.y}`;
  };
  const stopDrawing = effect(() => {
    void [store.view.value, store.map.value, store.belief.value, store.showBelief.value, store.state.value];
    void [store.plan.value, store.chosen.value, store.foundAt.value, store.isStale.value, store.t.value];
    if (store.isStale.value || store.hasLostMe.value) void store.clock.value; // ages are shown
    if (frame === 0) frame = requestAnimationFrame(draw);
  });

  const fit = () => {
    const { clientWidth, clientHeight } = canvas;
    const ratio = Math.min(kMaxRatio, devicePixelRatio);
    canvas.width = Math.round(clientWidth * ratio);
    canvas.height = Math.round(clientHeight * ratio);
    const view = store.view.value;
    if (view === undefined || store.showsEverything.value) store.showEverything(clientWidth, clientHeight, view);
    else store.view.value = { ...view, width: pixels(clientWidth), height: pixels(clientHeight) };
    if (frame === 0) frame = requestAnimationFrame(draw);
  };
  const observer = new ResizeObserver(fit);
  observer.observe(canvas);
  let shown = store.map.value?.id;
  const stopFitting = effect(() => {
    const id = store.map.value?.id;
    if (id === shown) return;
    shown = id;
    store.showEverything(canvas.clientWidth, canvas.clientHeight);
  });

  const stopListening = listen(canvas);
  return () => {
    stopDrawing();
    stopFitting();
    stopListening();
    observer.disconnect();
    cancelAnimationFrame(frame);
  };
}

function listen(canvas: HTMLCanvasElement): () => void {
  const gestures = new Gestures({
    tap: (at) => {
      const view = store.view.value;
      if (view !== undefined) store.place(toMap(view, at));
    },
    drag: (from, to) => {
      if (store.view.value !== undefined) store.look(panned(store.view.value, from, to));
    },
    pinch: (fixed, factor, turn) => {
      if (store.view.value !== undefined) store.look(pinched(store.view.value, fixed, factor, turn));
    },
  });
  const where = (event: PointerEvent | WheelEvent): PointOnScreen => {
    const box = canvas.getBoundingClientRect();
    return pointOnScreen(event.clientX - box.left, event.clientY - box.top);
  };
  const end = new AbortController();
  const options = { signal: end.signal };
  canvas.addEventListener(
    "pointerdown",
    (event) => {
      canvas.setPointerCapture(event.pointerId);
      gestures.down(event.pointerId, where(event));
    },
    options,
  );
  canvas.addEventListener("pointermove", (event) => gestures.move(event.pointerId, where(event)), options);
  canvas.addEventListener("pointerup", (event) => gestures.up(event.pointerId), options);
  canvas.addEventListener("pointercancel", (event) => gestures.cancel(event.pointerId), options);
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const view = store.view.value;
      if (view !== undefined) store.look(pinched(view, where(event), Math.exp(-event.deltaY / 400), radians(0)));
    },
    { ...options, passive: false },
  );
  return () => end.abort();
}
