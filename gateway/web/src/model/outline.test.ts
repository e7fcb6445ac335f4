import { describe, expect, it } from "vitest";
import { type PointInMap, pointInMap } from "../units";
import { drawnOn, region } from "./outline";

const draw = (points: readonly [number, number][]) =>
  points.reduce<readonly PointInMap[]>((outline, [x, y]) => drawnOn(outline, pointInMap(x, y)), []);

describe("an outline", () => {
  it("keeps corners that are apart", () => {
    expect(draw([[0, 0], [0.1, 0], [1, 0]])).toEqual([pointInMap(0, 0), pointInMap(1, 0)]);
  });
  it("never has more corners than the gateway takes, and keeps its ends", () => {
    const long = draw(Array.from({ length: 1000 }, (_, i) => [i, 0]));
    expect(long.length).toBeLessThanOrEqual(200);
    expect(long[0]).toEqual(pointInMap(0, 0));
    expect(long.at(-1)).toEqual(pointInMap(999, 0));
  });
  it("is a place when it encloses nothing", () => {
    expect(region(draw([[1, 2]]))).toEqual([[1, 2]]);
    expect(region(draw([[1, 2], [2, 2]]))).toEqual([[1.5, 2]]);
    expect(region(draw([[0, 0], [1, 0], [1, 1]]))).toHaveLength(3);
  });
});
