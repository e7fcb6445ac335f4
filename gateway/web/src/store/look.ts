import { effect } from "@preact/signals";
import { fitted, panned } from "../model/map_view";
import type { MapView } from "../model/map_view";
import { pixels, pointInMap, pointOnScreen, radians } from "../units";
import { headingUp, map, showsEverything, state, view } from "./signals";

/** A finger moved the map. */
export function look(moved: MapView): void {
  showsEverything.value = false;
  headingUp.value = false;
  view.value = moved;
}

/** Height of the row of buttons along the lower edge of the map. */
const kButtonBand = 76;

/** Shows the whole map in a canvas of the given size, above the row of buttons; turned as `before` was. */
export function showEverything(width: number, height: number, before?: MapView): void {
  const one = map.value;
  if (one === undefined || height <= kButtonBand) return;
  showsEverything.value = true;
  headingUp.value = false;
  const low = pointInMap(one.x, one.y);
  const high = pointInMap(one.x + one.width * one.resolution_m, one.y + one.height * one.resolution_m);
  const fit = fitted(low, high, pixels(width), pixels(height - kButtonBand), before);
  view.value = panned({ ...fit, height: pixels(height) }, pointOnScreen(0, 0), pointOnScreen(0, -kButtonBand / 2));
}

/** A turned map is turned upright, an upright one with the person's heading. */
export function turnMap(): void {
  const before = view.value;
  if (before === undefined) return;
  if (headingUp.value || Math.abs(before.turn) > 0.01) look({ ...before, turn: radians(0) });
  else headingUp.value = true;
}

// While the person looks up, the map follows them.
effect(() => {
  const person = state.value?.person;
  if (!headingUp.value || person === undefined) return;
  const before = view.peek();
  if (before === undefined) return;
  showsEverything.value = false;
  view.value = {
    ...before,
    centre: pointInMap(person.x, person.y),
    turn: radians(Math.PI / 2 - person.heading),
  };
});
