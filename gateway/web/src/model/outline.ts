import { type PointInMap, pointInMap } from "../units";

/** Corners nearer than this to the one before say nothing [m]. */
const kStep_m = 0.25;
const kMostCorners = 200;

/** `outline` with the finger gone on to `at`. */
export function drawnOn(outline: readonly PointInMap[], at: PointInMap): readonly PointInMap[] {
  const last = outline.at(-1);
  if (last !== undefined && Math.hypot(at.x - last.x, at.y - last.y) < kStep_m) return outline;
  const drawn = [...outline, at];
  if (drawn.length <= kMostCorners) return drawn;
  return drawn.filter((_, index) => index % 2 === 0 || index === drawn.length - 1);
}

/** What is sent of it: a line too short to enclose anything is a tap on its middle. */
export function region(outline: readonly PointInMap[]): [number, number][] {
  const round = (one: PointInMap): [number, number] => [Math.round(one.x * 100) / 100, Math.round(one.y * 100) / 100];
  if (outline.length >= 3) return outline.map(round);
  const x = outline.reduce((sum, one) => sum + one.x, 0) / Math.max(1, outline.length);
  const y = outline.reduce((sum, one) => sum + one.y, 0) / Math.max(1, outline.length);
  return [round(pointInMap(x, y))];
}
