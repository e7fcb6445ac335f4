import * as v from "valibot";
import { parsed } from "../protocol/fields";

const kinds = ["my_pose", "my_goal", "robot_goal"] as const;
export type CountedKind = (typeof kinds)[number];
const whole = v.pipe(v.number(), v.safeInteger(), v.minValue(0));
const stored = v.strictObject({
  counts: v.strictObject({ my_pose: whole, my_goal: whole, robot_goal: whole }),
  seen: v.array(whole),
});

/** How often each message was accepted, and the numbers of those counted last: a receipt may come twice. */
export type Counters = v.InferOutput<typeof stored>;

export const kNoCounts: Counters = { counts: { my_pose: 0, my_goal: 0, robot_goal: 0 }, seen: [] };
const kRemembered = 200;

export const isCounted = (kind: string): kind is CountedKind => (kinds as readonly string[]).includes(kind);

export function counted(counters: Counters, kind: CountedKind, sequence: number): Counters {
  if (counters.seen.includes(sequence)) return counters;
  return {
    counts: { ...counters.counts, [kind]: counters.counts[kind] + 1 },
    seen: [...counters.seen, sequence].slice(-kRemembered),
  };
}

export function parseCounters(json: string): Counters {
  const one = parsed(stored, json);
  return one.ok ? one.value : kNoCounts;
}
