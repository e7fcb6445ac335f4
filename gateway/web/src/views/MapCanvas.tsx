import { effect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { pictureOfBelief, pictureOfMap } from "../draw/bitmaps";
import { kPalettes } from "../draw/palette";
import { drawScene } from "../draw/scene";
import { Gestures } from "../model/gestures";
import { panned, pinched, toMap } from "../model/map_view";
import * as store from "../store";
import { now } from "../store/clock";
import { type PointOnScreen, pixels, pointOnScreen, radians } from "../units";

/** More than twice the screen's pixels costs much and shows little. */
const kMaxRatio = 2;

export function MapCanvas() {
  const canvasRef = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const canvas = canvasRef.current;
    return canvas === null ? undefined : attach(canvas);
  }, []);
  return (
    <>
      <canvas
        ref={canvasRef}
        class="map-canvas"
        role="application"
        tabIndex={0}
        aria-label={`${store.t.value.map}: ${store.t.value.tapMap}`}
        aria-describedby="map-in-words"
      />
      <p class="hidden" id="map-in-words">
        {mapInWords()}
      </p>
    </>
  );
}

/** Who is where, for those who do not see the map. */
function mapInWords(): string {
  const texts = store.t.value;
  const since = store.dataAgeMs.value / 1000;
  const told = (name: string, at: { x: number; y: number; age_s: number } | undefined, more = "") => {
    if (at === undefined) return "";
    return `${name}: ${at.x.toFixed(1)} m, ${at.y.toFixed(1)} m${more}, ${Math.round(at.age_s + since)} s. `;
  };
  const { robot, person, partner } = store.state.value ?? {};
  const sources = { laser: texts.sourceLaser, message: texts.sourceMessage, predicted: texts.sourcePredicted };
  const doubt = person?.tracked === false ? `, ${texts.lostYou}` : "";
  return (
    told(texts.you, person, person === undefined ? "" : `, ${sources[person.source]}${doubt}`) +
    (store.isBetweenPeople.value ? told(texts.partner, partner) : told(texts.robot, robot))
  );
}

/** Draws whenever something shown changes, at most once a frame; listens to fingers. Gives its undoing. */
function attach(canvas: HTMLCanvasElement): () => void {
  let pictureFor: typeof store.map.value;
  let mapPicture: HTMLCanvasElement | undefined;
  let heatFor = "";
  let pictureTheme = store.theme.value;
  let beliefPicture: HTMLCanvasElement | undefined;
  let frame = 0;

  const draw = () => {
    frame = 0;
    const view = store.view.value;
    const context = canvas.getContext("2d");
    if (view === undefined || context === null) return;
    const theme = store.theme.value;
    const palette = kPalettes[theme];
    if (pictureFor !== store.map.value || pictureTheme !== theme) {
      pictureFor = store.map.value;
      pictureTheme = theme;
      mapPicture = pictureFor === undefined ? undefined : pictureOfMap(pictureFor, palette);
    }
    const people = store.isBetweenPeople.value;
    const layer = people ? "none" : store.layer.value;
    const grid = store.belief.value;
    const heat = `${grid?.revision} ${layer} ${theme}`;
    if (heat !== heatFor) {
      heatFor = heat;
      beliefPicture =
        grid === undefined || layer === "none" ? undefined : pictureOfBelief(grid, layer, theme === "dark");
    }
    drawScene(
      context,
      {
        view,
        map: pictureFor,
        mapPicture,
        belief: grid,
        beliefPicture,
        state: store.state.value,
        plan: people ? undefined : store.plan.value,
        robotName: store.hello.value?.robot ?? "",
        chosen: store.chosen.value,
        found: store.foundAt.value?.at,
        stale: store.isStale.value,
        since: Math.max(0, (now() - store.stateAt.value) / 1000),
        palette,
        sources: people ? [] : store.sources.value,
        drawing: store.drawing.value,
        betweenPeople: people,
        pulse: Math.floor(now() / 500) % 2,
        showsCrosshair: document.activeElement === canvas && canvas.matches(":focus-visible"),
        labels: labels(),
      },
      Math.min(kMaxRatio, devicePixelRatio),
    );
    // For the browser test: where the map and the team lie.
    canvas.dataset["view"] = [view.centre.x, view.centre.y, view.pixelsPerMetre, view.turn].join(" ");
    const { robot, person } = store.state.value ?? {};
    if (robot !== undefined) canvas.dataset["robot"] = `${robot.x} ${robot.y}`;
    if (person !== undefined) canvas.dataset["person"] = `${person.x} ${person.y}`;
    const partner = store.state.value?.partner;
    if (partner !== undefined) canvas.dataset["partner"] = `${partner.x} ${partner.y}`;
  };
  const stopDrawing = effect(() => {
    void [store.view.value, store.map.value, store.belief.value, store.layer.value, store.state.value];
    void [store.plan.value, store.chosen.value, store.foundAt.value, store.isStale.value, store.t.value];
    void [store.theme.value, store.sources.value, store.drawing.value, store.isBetweenPeople.value];
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

function labels() {
  const texts = store.t.value;
  return {
    you: texts.you,
    robot: texts.robot,
    partner: texts.partner,
    laser: texts.sourceLaser,
    message: texts.sourceMessage,
    predicted: texts.sourcePredicted,
  };
}

function listen(canvas: HTMLCanvasElement): () => void {
  const gestures = new Gestures({
    tap: (at) => tapped(at),
    drag: (from, to, isFirst) => {
      const view = store.view.value;
      if (view === undefined) return;
      if (store.drawing.value === undefined) return store.look(panned(view, from, to));
      if (isFirst) store.drawTo(toMap(view, from), true);
      store.drawTo(toMap(view, to), false);
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
  canvas.addEventListener("keydown", (event) => pressed(canvas, event), options);
  return () => end.abort();
}

function tapped(at: PointOnScreen): void {
  const view = store.view.value;
  if (view === undefined) return;
  if (store.drawing.value === undefined) store.place(toMap(view, at));
  else store.drawTo(toMap(view, at), true);
}

const kStepPixels = 40;
const kSteps: { readonly [Key in string]?: readonly [number, number] } = {
  ArrowLeft: [kStepPixels, 0],
  ArrowRight: [-kStepPixels, 0],
  ArrowUp: [0, kStepPixels],
  ArrowDown: [0, -kStepPixels],
};

/** What fingers do, for those who have a keyboard or a switch. */
function pressed(canvas: HTMLCanvasElement, event: KeyboardEvent): void {
  const view = store.view.value;
  if (view === undefined) return;
  const middle = pointOnScreen(canvas.clientWidth / 2, canvas.clientHeight / 2);
  const step = kSteps[event.key];
  if (step !== undefined) store.look(panned(view, middle, pointOnScreen(middle.x + step[0], middle.y + step[1])));
  else if (event.key === "+" || event.key === "=") store.look(pinched(view, middle, 1.25, radians(0)));
  else if (event.key === "-") store.look(pinched(view, middle, 0.8, radians(0)));
  else if (event.key === "Enter" || event.key === " ") tapped(middle);
  else return;
  event.preventDefault();
}
