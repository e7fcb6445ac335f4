import { type Pixels, type PointInMap, type PointOnScreen, pointInMap, pointOnScreen, radians } from "../units";
import type { Radians } from "../units";

/** How the map lies on the screen: which point is in the middle, how large, turned how far. */
export type MapView = {
  readonly centre: PointInMap;
  readonly pixelsPerMetre: number;
  /** Of the map on the screen, counter-clockwise. */
  readonly turn: Radians;
  readonly width: Pixels;
  readonly height: Pixels;
};

export const kMinScale = 4;
export const kMaxScale = 200;

export function toScreen(view: MapView, point: PointInMap): PointOnScreen {
  const dx = (point.x - view.centre.x) * view.pixelsPerMetre;
  const dy = (point.y - view.centre.y) * view.pixelsPerMetre;
  const c = Math.cos(view.turn);
  const s = Math.sin(view.turn);
  return pointOnScreen(view.width / 2 + c * dx - s * dy, view.height / 2 - (s * dx + c * dy));
}

export function toMap(view: MapView, point: PointOnScreen): PointInMap {
  const right = (point.x - view.width / 2) / view.pixelsPerMetre;
  const up = (view.height / 2 - point.y) / view.pixelsPerMetre;
  const c = Math.cos(view.turn);
  const s = Math.sin(view.turn);
  return pointInMap(view.centre.x + c * right + s * up, view.centre.y - s * right + c * up);
}

/** The view in which the place that was under `from` lies under `to`: what a dragging finger expects. */
export function panned(view: MapView, from: PointOnScreen, to: PointOnScreen): MapView {
  const before = toMap(view, from);
  const after = toMap(view, to);
  return { ...view, centre: pointInMap(view.centre.x + before.x - after.x, view.centre.y + before.y - after.y) };
}

/** Scaled by `factor` and turned by `turn` about the place under `fixed`. */
export function pinched(view: MapView, fixed: PointOnScreen, factor: number, turn: Radians): MapView {
  const scale = Math.min(kMaxScale, Math.max(kMinScale, view.pixelsPerMetre * factor));
  const changed = { ...view, pixelsPerMetre: scale, turn: radians(view.turn + turn) };
  const place = toMap(view, fixed);
  const now = toMap(changed, fixed);
  return {
    ...changed,
    centre: pointInMap(changed.centre.x + place.x - now.x, changed.centre.y + place.y - now.y),
  };
}

/** A quarter turn must show the map this much larger to be worth reading it sideways. */
const kWorthTurning = 1.3;

/**
 * The view that shows the rectangle from `low` to `high`, with a margin; turned a quarter if it is much larger so, or as
 * `before` was turned: a map that is read already does not turn by itself.
 */
export function fitted(
  low: PointInMap,
  high: PointInMap,
  width: Pixels,
  height: Pixels,
  before?: MapView | undefined,
): MapView {
  const along = Math.max(1, high.x - low.x);
  const across = Math.max(1, high.y - low.y);
  const upright = Math.min(width / along, height / across);
  const turned = Math.min(width / across, height / along);
  const turn = before === undefined ? turned > kWorthTurning * upright : before.turn > Math.PI / 4;
  return {
    centre: pointInMap((low.x + high.x) / 2, (low.y + high.y) / 2),
    pixelsPerMetre: Math.min(kMaxScale, Math.max(kMinScale, 0.94 * (turn ? turned : upright))),
    turn: radians(turn ? Math.PI / 2 : 0),
    width,
    height,
  };
}
