import * as v from "valibot";

/** A value that was understood, or why not. Nothing here throws. */
export type Parsed<T> = { readonly ok: true; readonly value: T } | { readonly ok: false; readonly reason: string };

const kFar = 1e5;
const kLong = 1e12;
const text = (min: number, max: number) => v.pipe(v.string(), v.minLength(min), v.maxLength(max));
const range = (min: number, max: number) => v.pipe(v.number(), v.finite(), v.minValue(min), v.maxValue(max));
const count = (min: number, max: number) => v.pipe(v.number(), v.safeInteger(), v.minValue(min), v.maxValue(max));
const coordinate = range(-kFar, kFar);
const heading = range(-6.3, 6.3);
const seconds = range(0, kLong);
const duration = range(0, kLong);
const share = range(0, 1);
const sequence = count(0, Number.MAX_SAFE_INTEGER);
const positive = count(1, Number.MAX_SAFE_INTEGER);
const client = v.pipe(v.string(), v.regex(/^[0-9A-Za-z-]{8,64}$/));

const hello = v.strictObject({
  type: v.literal("hello"),
  version: v.literal(1),
  epoch: text(1, 64),
  role: v.picklist(["observer", "participant", "operator"]),
  agent: text(0, 64),
  robot: text(0, 64),
  mode: v.picklist(["human_robot", "human_human"]),
});

const state = v.strictObject({
  type: v.literal("state"),
  sequence,
  robot: v.optional(
    v.strictObject({
      x: coordinate,
      y: coordinate,
      heading,
      status: v.picklist(["ok", "uncertain", "lost"]),
      age_s: seconds,
    }),
  ),
  person: v.optional(
    v.strictObject({
      x: coordinate,
      y: coordinate,
      heading,
      source: v.picklist(["laser", "message", "predicted"]),
      tracked: v.boolean(),
      age_s: seconds,
    }),
  ),
  planner: v.strictObject({
    activity: v.picklist(["idle", "computing", "failed", "finished", "unknown"]),
    computing_s: seconds,
    progress: share,
    reason: text(0, 500),
  }),
  base: v.strictObject({
    connected: v.boolean(),
    moving: v.boolean(),
    blocked: v.boolean(),
    latched: v.boolean(),
    stop_reasons: v.array(v.string()),
    resume_in_s: seconds,
    battery_v: range(0, 1000),
    waits_for: text(0, 500),
  }),
  link: v.strictObject({
    quality: v.picklist(["good", "weak", "one_way", "lost", "unknown"]),
    round_trip_ms: duration,
  }),
  explored: share,
});

const plan = v.strictObject({
  type: v.literal("plan"),
  id: text(0, 128),
  state: v.picklist(["none", "proposed", "accepted", "rejected", "superseded"]),
  role: v.picklist(["none", "leader_follower", "peer_peer", "master_slave", "leader_leader"]),
  reason: text(0, 500),
  probability_found: share,
  paths: v.array(
    v.strictObject({
      agent: text(1, 64),
      goal: v.strictTuple([v.number(), v.number()]),
      goal_fixed: v.boolean(),
      points: v.array(v.strictTuple([v.number(), v.number(), v.number()])),
    }),
  ),
});

const map = v.pipe(
  v.strictObject({
    type: v.literal("map"),
    id: text(0, 128),
    resolution_m: range(0.001, 10),
    width: count(1, 20_000),
    height: count(1, 20_000),
    x: coordinate,
    y: coordinate,
    heading,
    runs: v.array(v.strictTuple([count(0, 100_000_000), count(0, 255)])),
  }),
  v.check(
    (one) => one.runs.reduce((cells, [length]) => cells + length, 0) === one.width * one.height,
    "the runs do not fill the map",
  ),
);

const ack = v.strictObject({
  type: v.literal("ack"),
  client,
  up_to: sequence,
  results: v.array(
    v.strictObject({ sequence: positive, outcome: v.picklist(["applied", "refused"]), reason: text(0, 500) }),
  ),
});

const event = v.strictObject({
  type: v.literal("event"),
  kind: v.picklist(["found", "error", "inform"]),
  text: text(0, 500),
  x: v.optional(coordinate),
  y: v.optional(coordinate),
  id: v.optional(text(1, 128)),
});

const pong = v.strictObject({ type: v.literal("pong"), sent_at_ms: duration });

const gatewayMessage = v.variant("type", [hello, state, plan, map, ack, event, pong]);
export type GatewayMessage = v.InferOutput<typeof gatewayMessage>;
export type Hello = v.InferOutput<typeof hello>;
export type State = v.InferOutput<typeof state>;
export type Plan = v.InferOutput<typeof plan>;
export type MapMessage = v.InferOutput<typeof map>;
export type Ack = v.InferOutput<typeof ack>;

const command = { type: v.literal("cmd"), client, sequence: positive, age_ms: duration };
const clientMessage = v.union([
  v.strictObject({
    ...command,
    kind: v.picklist(["my_pose", "robot_pose"]),
    x: coordinate,
    y: coordinate,
    heading: v.optional(range(-2 * Math.PI, 2 * Math.PI)),
  }),
  v.strictObject({ ...command, kind: v.picklist(["my_goal", "robot_goal", "found"]), x: coordinate, y: coordinate }),
  v.strictObject({ ...command, kind: v.picklist(["replan", "clear_my_goal", "clear_robot_goal", "stop"]) }),
  v.strictObject({ ...command, kind: v.literal("resume"), held_ms: range(0, 60_000) }),
  v.strictObject({ type: v.literal("seen"), sequence }),
  v.strictObject({
    type: v.literal("trig"),
    kind: v.picklist(["toast", "popup", "multimodal", "counters"]),
    fired_at_ms: duration,
    threshold_ms: duration,
    obeyed_after_ms: v.optional(duration),
  }),
  v.strictObject({ type: v.literal("got_it"), id: text(1, 128) }),
  v.strictObject({ type: v.literal("ping"), sent_at_ms: duration }),
]);
export type ClientMessage = v.InferOutput<typeof clientMessage>;

/** Keys that mean something to JavaScript itself are never ours. */
function refuseReserved(key: string, value: unknown): unknown {
  if (key === "__proto__" || key === "constructor" || key === "prototype") throw new SyntaxError(key);
  return value;
}

function parsed<Schema extends v.GenericSchema>(schema: Schema, json: string): Parsed<v.InferOutput<Schema>> {
  let value: unknown;
  try {
    value = JSON.parse(json, refuseReserved);
  } catch {
    return { ok: false, reason: "not JSON, or a reserved key" };
  }
  const result = v.safeParse(schema, value);
  return result.success
    ? { ok: true, value: result.output }
    : { ok: false, reason: result.issues[0]?.message ?? "not a message" };
}

/** Parses one message of the gateway; whatever is not exactly one is an error value, never an exception. */
export function parseMessage(json: string): Parsed<GatewayMessage> {
  return parsed(gatewayMessage, json);
}

/** Parses what a phone sends: for the tests that the gateway shares. */
export function parseClientMessage(json: string): Parsed<ClientMessage> {
  return parsed(clientMessage, json);
}

const outboxSchema = v.strictObject({
  client,
  next: positive,
  waiting: v.array(
    v.strictObject({
      sequence: positive,
      kind: v.picklist([
        "my_pose",
        "my_goal",
        "robot_goal",
        "robot_pose",
        "replan",
        "clear_my_goal",
        "clear_robot_goal",
        "found",
        "stop",
        "resume",
      ]),
      x: v.optional(coordinate),
      y: v.optional(coordinate),
      held_ms: v.optional(range(0, 60_000)),
      pressed_at: v.number(),
    }),
  ),
});
export type StoredOutbox = v.InferOutput<typeof outboxSchema>;
export type StoredCommand = StoredOutbox["waiting"][number];

/** Parses what an earlier visit left in the phone's storage. */
export function parseOutbox(json: string): Parsed<StoredOutbox> {
  return parsed(outboxSchema, json);
}
