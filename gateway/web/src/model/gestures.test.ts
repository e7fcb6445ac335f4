import { describe, expect, it } from "vitest";
import { pointOnScreen as at } from "../units";
import { Gestures } from "./gestures";

function recorded() {
  const log: string[] = [];
  const gestures = new Gestures({
    tap: (point) => log.push(`tap ${point.x} ${point.y}`),
    drag: (from, to) => log.push(`drag ${to.x - from.x} ${to.y - from.y}`),
    pinch: (_, factor, turn) => log.push(`pinch ${factor.toFixed(2)} ${turn.toFixed(2)}`),
  });
  return { log, gestures };
}

describe("gestures", () => {
  it("take a still finger for a tap, when it leaves", () => {
    const { log, gestures } = recorded();
    gestures.down(1, at(10, 10));
    gestures.move(1, at(14, 12));
    expect(log).toEqual([]);
    gestures.up(1);
    expect(log).toEqual(["tap 10 10"]);
  });
  it("drag with the whole way from where the finger came down", () => {
    const { log, gestures } = recorded();
    gestures.down(1, at(0, 0));
    gestures.move(1, at(30, 0));
    gestures.move(1, at(40, 5));
    gestures.up(1);
    expect(log).toEqual(["drag 30 0", "drag 10 5"]);
  });
  it("pinch with two fingers, and send nothing", () => {
    const { log, gestures } = recorded();
    gestures.down(1, at(0, 0));
    gestures.down(2, at(100, 0));
    gestures.move(2, at(0, -200));
    gestures.up(2);
    gestures.up(1);
    expect(log).toEqual(["pinch 2.00 1.57"]);
  });
});
