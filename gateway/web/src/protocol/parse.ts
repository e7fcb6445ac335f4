import * as v from "valibot";
import { type Parsed, client, coordinate, count, duration, heading, parsed, point, positive, range } from "./fields";
import { seconds, sequence, share, text } from "./fields";

const hello = v.strictObject({
  type: v.literal("hello"),
  version: v.literal(1),
  epoch: text(1, 64),
  role: v.picklist(["observer", "participant", "operator"]),
  agent: text(0, 64),
  robot: text(0, 64),
});

const session = v.strictObject({
  type: v.literal("session"),
  phase: v.picklist(["none", "preparing", "running", "ended"]),
  mode: v.picklist(["human_robot", "human_human"]),
  reminder: v.strictObject({
    kind: v.picklist(["none", "toast", "popup", "multimodal", "counters"]),
    threshold_ms: range(1, 1e12),
    factor: share,
    floor_ms: range(1, 1e12),
  }),
});

const person = v.strictObject({
  x: coordinate,
  y: coordinate,
  heading,
  source: v.picklist(["laser", "message", "predicted"]),
  tracked: v.boolean(),
  age_s: seconds,
  goal: v.optional(point),
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
  person: v.optional(person),
  partner: v.optional(person),
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

const sources = v.strictObject({
  type: v.literal("sources"),
  sources: v.array(
    v.strictObject({
      id: text(1, 128),
      edit: v.picklist(["avoid", "pass_through", "go_to", "stay_behind"]),
      outline: v.array(point),
      radius_m: range(0, 1e5),
      targets: v.array(v.string()),
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

const gatewayMessage = v.variant("type", [hello, session, state, plan, sources, map, ack, event, pong]);
export type GatewayMessage = v.InferOutput<typeof gatewayMessage>;
export type Hello = v.InferOutput<typeof hello>;
export type Session = v.InferOutput<typeof session>;
export type ReminderRule = Session["reminder"];
export type Source = v.InferOutput<typeof sources>["sources"][number];
export type Person = v.InferOutput<typeof person>;
export type State = v.InferOutput<typeof state>;
export type Plan = v.InferOutput<typeof plan>;
export type MapMessage = v.InferOutput<typeof map>;
export type Ack = v.InferOutput<typeof ack>;

/** Parses one message of the gateway; whatever is not exactly one is an error value, never an exception. */
export function parseMessage(json: string): Parsed<GatewayMessage> {
  return parsed(gatewayMessage, json);
}
