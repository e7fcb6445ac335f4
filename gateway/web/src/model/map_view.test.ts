import { describe, expect, it } from "vitest";
import { pixels, pointInMap, pointOnScreen, radians } from "../units";
import { type MapView, fitted, panned, pinched, toMap, toScreen } from "./map_view";

const view: MapView = {
  centre: pointInMap(10, 5),
  pixelsPerMetre: 20,
  turn: radians(0),
  width: pixels(400),
  height: pixels(600),
};

describe("a map view", () => {
  it("shows its centre in the middle, y upwards", () => {
    expect(toScreen(view, pointInMap(10, 5))).toEqual({ x: 200, y: 300 });
    expect(toScreen(view, pointInMap(11, 6))).toEqual({ x: 220, y: 280 });
  });
  it("is undone by its inverse, turned or not", () => {
    const turned = { ...view, turn: radians(0.7) };
    const there = toMap(turned, toScreen(turned, pointInMap(3, -4)));
    expect(there.x).toBeCloseTo(3);
    expect(there.y).toBeCloseTo(-4);
  });
  it("turns counter-clockwise", () => {
    const quarter = { ...view, turn: radians(Math.PI / 2) };
    const right = toScreen(quarter, pointInMap(11, 5));
    expect(right.x).toBeCloseTo(200);
    expect(right.y).toBeCloseTo(280);
  });
  it("keeps the place under the finger when dragged and pinched", () => {
    const from = pointOnScreen(100, 100);
    const to = pointOnScreen(150, 90);
    const place = toMap(view, from);
    expect(toScreen(panned(view, from, to), place).x).toBeCloseTo(150);
    const zoomed = pinched(view, from, 2, radians(Math.PI / 4));
    expect(zoomed.pixelsPerMetre).toBe(40);
    expect(toScreen(zoomed, place).x).toBeCloseTo(100);
    expect(toScreen(zoomed, place).y).toBeCloseTo(100);
  });
  it("fits a rectangle", () => {
    const all = fitted(pointInMap(0, 0), pointInMap(20, 10), pixels(400), pixels(600));
    expect(toScreen(all, pointInMap(0, 0)).x).toBeGreaterThanOrEqual(0);
    expect(toScreen(all, pointInMap(20, 10)).x).toBeLessThanOrEqual(400);
  });
  it("lays a wide map along a tall screen", () => {
    const wide = fitted(pointInMap(0, 0), pointInMap(40, 10), pixels(400), pixels(600));
    expect(wide.turn).toBeCloseTo(Math.PI / 2);
    expect(wide.pixelsPerMetre).toBeCloseTo(14.1); // 600 px / 40 m, less the margin
    const square = fitted(pointInMap(0, 0), pointInMap(10, 10), pixels(400), pixels(600));
    expect(square.turn).toBe(0);
  });
  it("does not turn a map that is read already", () => {
    const wide = fitted(pointInMap(0, 0), pointInMap(40, 10), pixels(400), pixels(600));
    const smaller = fitted(pointInMap(0, 0), pointInMap(40, 10), pixels(600), pixels(400), wide);
    expect(smaller.turn).toBe(wide.turn);
  });
});
