import * as v from "valibot";
import { type Parsed, client, coordinate, duration, parsed, point, positive, range, sequence, text } from "./fields";

const head = { type: v.literal("cmd"), client, sequence: positive, age_ms: duration, sent_at_ms: v.optional(duration) };
const outline = v.pipe(v.array(point), v.minLength(1), v.maxLength(200));
const graded = v.picklist(["a_bit", "quite", "very"]);

/** What a command asks for, by its kind; the same on the wire and in the phone's storage. */
const wish = [
  v.strictObject({
    kind: v.picklist(["my_pose", "robot_pose"]),
    x: coordinate,
    y: coordinate,
    heading: v.optional(range(-2 * Math.PI, 2 * Math.PI)),
  }),
  v.strictObject({ kind: v.picklist(["my_goal", "robot_goal", "found"]), x: coordinate, y: coordinate }),
  v.strictObject({ kind: v.picklist(["replan", "clear_my_goal", "clear_robot_goal", "stop"]) }),
  v.strictObject({ kind: v.literal("resume"), held_ms: range(0, 60_000) }),
  v.strictObject({
    kind: v.literal("source_edit"),
    edit: v.literal("avoid"),
    outline,
    strength: graded,
    target: v.picklist(["everybody", "robot", "me"]),
  }),
  v.strictObject({
    kind: v.literal("source_edit"),
    edit: v.picklist(["pass_through", "go_to"]),
    outline,
    strength: graded,
    target: v.picklist(["robot", "me"]),
  }),
  v.strictObject({ kind: v.literal("source_edit"), edit: v.literal("stay_behind") }),
  v.strictObject({ kind: v.literal("source_edit"), edit: v.literal("remove"), source: text(1, 128) }),
  v.strictObject({
    kind: v.literal("belief_edit"),
    edit: v.picklist(["likely_here", "not_here", "look_again"]),
    outline,
    strength: graded,
  }),
  v.strictObject({
    kind: v.literal("belief_edit"),
    edit: v.literal("searched"),
    outline,
    strength: v.picklist(["roughly", "well"]),
  }),
  v.strictObject({
    kind: v.literal("reminder"),
    reminder: v.picklist(["toast", "popup", "multimodal"]),
    threshold_ms: duration,
    obeyed_after_ms: v.optional(duration),
  }),
  v.strictObject({ kind: v.literal("layer"), layer: v.picklist(["belief", "explored"]), shown: v.boolean() }),
] as const;
const anyWish = v.union(wish);
/** What the person, or the phone, asks for. */
export type Wish = v.InferOutput<typeof anyWish>;
export type PlaceKind = "my_pose" | "my_goal" | "robot_goal" | "robot_pose" | "found";

const onTheWire = v.union(wish.map((one) => v.strictObject({ ...head, ...one.entries })));
const clientMessage = v.union([
  onTheWire,
  v.strictObject({ type: v.literal("seen"), sequence }),
  v.strictObject({ type: v.literal("got_it"), id: text(1, 128) }),
  v.strictObject({ type: v.literal("ping"), sent_at_ms: duration }),
]);

/** Parses what a phone sends: for the tests that the gateway shares. */
export function parseClientMessage(json: string): Parsed<unknown> {
  return parsed(clientMessage, json);
}

const storedOutbox = v.strictObject({
  client,
  next: positive,
  waiting: v.array(v.strictObject({ sequence: positive, pressed_at: v.number(), wish: anyWish })),
});
export type StoredOutbox = v.InferOutput<typeof storedOutbox>;
export type StoredCommand = StoredOutbox["waiting"][number];

/** Parses what an earlier visit left in the phone's storage. */
export function parseOutbox(json: string): Parsed<StoredOutbox> {
  return parsed(storedOutbox, json);
}
