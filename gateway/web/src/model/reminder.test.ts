import { describe, expect, it } from "vitest";
import type { ReminderRule } from "../protocol/parse";
import { dueAt, fire, obey, startedAt } from "./reminder";

const rule: ReminderRule = { kind: "toast", threshold_ms: 10_000, factor: 0.75, floor_ms: 3000 };

/** The thresholds at which reminders fire that nobody obeys. */
function thresholds(one: ReminderRule, count: number): number[] {
  let state = startedAt(0, one);
  const fired: number[] = [];
  while (fired.length < count) {
    const due = dueAt(state, one);
    const next = due === undefined ? undefined : fire(state, one, due);
    if (next === undefined) break;
    state = next[0];
    fired.push(next[1].threshold_ms);
  }
  return fired;
}

describe("a reminder", () => {
  it("fires when the threshold has passed, not before", () => {
    const state = startedAt(1000, rule);
    expect(dueAt(state, rule)).toBe(11_000);
    expect(fire(state, rule, 10_999)).toBeUndefined();
    expect(fire(state, rule, 11_000)?.[1]).toEqual({ reminder: "toast", threshold_ms: 10_000 });
  });
  it("comes sooner each time it is not obeyed, down to the floor", () => {
    expect(thresholds(rule, 6)).toEqual([10_000, 7500, 5625, 4218.75, 3164.0625, 3000]);
    expect(thresholds({ ...rule, threshold_ms: 8320 }, 3)).toEqual([8320, 6240, 4680]);
  });
  it("never grows when the first threshold is below the floor", () => {
    expect(thresholds({ ...rule, threshold_ms: 2000 }, 3)).toEqual([2000, 2000, 2000]);
  });
  it("is obeyed by a pose, which brings the whole threshold back", () => {
    const fired = fire(startedAt(0, rule), rule, 10_000);
    const again = fired === undefined ? undefined : fire(fired[0], rule, 17_500);
    if (again === undefined) throw new Error("it did not fire");
    const [state, record] = obey(again[0], rule, 18_000);
    expect(record).toEqual({ reminder: "toast", threshold_ms: 10_000, obeyed_after_ms: 8000 });
    expect(dueAt(state, rule)).toBe(28_000);
    expect(obey(state, rule, 19_000)[1]).toBeUndefined();
  });
  it("does not open a pop-up that is open", () => {
    expect(thresholds({ ...rule, kind: "popup" }, 3)).toEqual([10_000]);
  });
  it("fires never without one, nor for counters", () => {
    expect(thresholds({ ...rule, kind: "none" }, 1)).toEqual([]);
    expect(thresholds({ ...rule, kind: "counters" }, 1)).toEqual([]);
  });
});
