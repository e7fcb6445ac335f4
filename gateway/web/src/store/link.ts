import { isCounted } from "../model/counters";
import { Connection } from "../net/connection";
import type { Wish } from "../protocol/commands";
import type { Ack, GatewayMessage } from "../protocol/parse";
import { reasonIn } from "../reasons";
import { pointInMap } from "../units";
import { now } from "./clock";
import { count, recordRemindersBy } from "./reminding";
import { language, t } from "./settings";
import * as its from "./signals";
import { ask, forget, nameOf, outbox, recordFirstLayer, sendAgain, transmitBy } from "./wishes";

const kInformMs = 30_000;
const kTooOld = "too old, it waited for the connection";

let connection: Connection | undefined;
/** The gateway has said hello on this connection: what waits goes first, and only then what is pressed. */
let isGreeted = false;

/** Opens the link; called once, after pairing. */
export function connect(): void {
  if (connection !== undefined) return;
  connection = new Connection({
    phase(phase) {
      its.link.value = phase;
      isGreeted = false;
      if (phase === "refused" && its.hello.value === undefined) its.screen.value = "no_link";
      if (phase === "moved") its.screen.value = "moved";
    },
    message: hear,
    belief: (grid) => (its.belief.value = grid),
    roundTrip: (ms) => (its.roundTripMs.value = ms),
  });
  transmitBy((message) => isGreeted && connection?.send(message) === true);
  recordRemindersBy((what) => ask({ kind: "reminder", ...what }));
  setInterval(tick, 500);
}

function tick(): void {
  its.clock.value = now();
  for (const passing of [its.toast, its.inform, its.undo] as const) {
    if (passing.value !== undefined && passing.value.until < its.clock.value) passing.value = undefined;
  }
}

function hear(message: GatewayMessage): void {
  switch (message.type) {
    case "hello": {
      const first = its.hello.value === undefined;
      its.hello.value = message;
      isGreeted = true;
      sendAgain();
      if (first) recordFirstLayer();
      break;
    }
    case "session":
      its.session.value = message;
      break;
    case "state":
      its.state.value = message;
      its.stateAt.value = now();
      its.clock.value = now();
      connection?.send({ type: "seen", sequence: message.sequence });
      break;
    case "plan":
      its.plan.value = message;
      break;
    case "sources":
      its.sources.value = message.sources;
      break;
    case "map":
      its.map.value = message;
      break;
    case "ack":
      settle(message);
      break;
    case "event":
      hearEvent(message);
      break;
    case "pong":
      break;
  }
}

function hearEvent(message: Extract<GatewayMessage, { type: "event" }>): void {
  if (message.kind === "found") {
    const at = message.x !== undefined && message.y !== undefined ? pointInMap(message.x, message.y) : undefined;
    its.foundAt.value = { by: message.text, at };
  } else if (message.kind === "inform" && message.id !== undefined) {
    its.inform.value = { id: message.id, text: message.text, until: now() + kInformMs };
  } else {
    its.say(reasonIn(language.value, message.text), message.kind === "error" ? "bad" : "plain");
  }
}

function settle(ack: Ack): void {
  if (ack.client !== outbox.client) return;
  for (const result of ack.results) {
    const wish = outbox.find(result.sequence)?.wish;
    if (wish === undefined) continue; // told before
    if (result.outcome === "applied") applied(wish, result.sequence);
    else refused(wish, result.sequence, result.reason);
  }
  outbox.acknowledge(ack.client, ack.up_to);
  its.waiting.value = outbox.waiting.length;
}

function applied(wish: Wish, sequence: number): void {
  if (isCounted(wish.kind)) count(wish.kind, sequence);
  if (!("x" in wish)) return;
  const mine = its.chosen.value[wish.kind];
  if (mine?.sequence !== sequence) return;
  its.chosen.value = { ...its.chosen.value, [wish.kind]: { ...mine, settled: true } };
}

let lastRefused = 0;

function refused(wish: Wish, sequence: number, reason: string): void {
  if ("x" in wish && its.chosen.value[wish.kind]?.sequence === sequence) forget(wish.kind);
  if (sequence <= lastRefused) return;
  lastRefused = sequence;
  const isPose = wish.kind === "my_pose" || wish.kind === "robot_pose" || wish.kind === "resume";
  if (reason === kTooOld && !isPose) its.askAgain.value = wish;
  else its.say(`${t.value[nameOf(wish)]} · ${t.value.refused}: ${reasonIn(language.value, reason)}`, "bad");
}

/** The person has taken notice of what the robot told them; without a link it goes on being shown. */
export function gotIt(): void {
  if (its.inform.value === undefined) return;
  if (connection?.send({ type: "got_it", id: its.inform.value.id }) === true) its.inform.value = undefined;
}
