import { describe, expect, it } from "vitest";
import { counted, kNoCounts, parseCounters } from "./counters";

describe("counters", () => {
  it("count each accepted message once, however often its receipt comes", () => {
    const one = counted(counted(kNoCounts, "my_pose", 1), "my_pose", 1);
    expect(counted(one, "my_goal", 2).counts).toEqual({ my_pose: 1, my_goal: 1, robot_goal: 0 });
  });
  it("survive storage, and start anew when it is damaged", () => {
    const one = counted(kNoCounts, "robot_goal", 7);
    expect(parseCounters(JSON.stringify(one))).toEqual(one);
    expect(parseCounters("{")).toEqual(kNoCounts);
  });
});
