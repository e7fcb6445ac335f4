import { computed, signal } from "@preact/signals";
import { fitted, panned } from "./model/map_view";
import type { MapView } from "./model/map_view";
import { Outbox, type PlaceKind, type Wish } from "./model/outbox";
import { Connection, type LinkPhase } from "./net/connection";
import type { BeliefGrid } from "./protocol/belief";
import type { Ack, GatewayMessage, Hello, MapMessage, Plan, State, StoredCommand } from "./protocol/parse";
import { type Language, languageFor, textsOf } from "./texts";
import { type PointInMap, pixels, pointInMap, pointOnScreen } from "./units";

/** Milliseconds that go on over a reload and do not follow a step of the wall clock while the page is open. */
export const now = (): number => performance.timeOrigin + performance.now();

const kUndoMs = 5000;
const kToastMs = 4000;
const kInformMs = 30_000;
const kStaleMs = 3000;

export type Screen = "pairing" | "no_link" | "refused" | "locked" | "unreachable" | "start" | "search" | "moved";
export type Toast = { readonly text: string; readonly tone: "plain" | "bad"; readonly until: number };
/** What the robot thinks the person should know, until they have got it. */
export type Inform = { readonly id: string; readonly text: string; readonly until: number };
/** A place the person has chosen and that was not refused. */
export type Chosen = { readonly at: PointInMap; readonly settled: boolean; readonly sequence: number };

export const screen = signal<Screen>("pairing");
export const language = signal<Language>(languageFor(navigator.languages));
export const t = computed(() => textsOf(language.value));
export const link = signal<LinkPhase>("connecting");
export const roundTripMs = signal<number | undefined>(undefined);
export const hello = signal<Hello | undefined>(undefined);
export const state = signal<State | undefined>(undefined);
export const stateAt = signal(0);
export const plan = signal<Plan | undefined>(undefined);
export const map = signal<MapMessage | undefined>(undefined);
export const belief = signal<BeliefGrid | undefined>(undefined);
export const foundAt = signal<{ by: string; at: PointInMap | undefined } | undefined>(undefined);
export const view = signal<MapView | undefined>(undefined);
/** The view shows everything, and goes on to when the screen changes, until a finger moves it. */
export const showsEverything = signal(true);
export const showBelief = signal(true);
export const tool = signal<PlaceKind>("my_pose");
export const toast = signal<Toast | undefined>(undefined);
export const inform = signal<Inform | undefined>(undefined);
export const chosen = signal<{ readonly [Kind in PlaceKind]?: Chosen | undefined }>({});
export const undo = signal<{ kind: "clear_my_goal" | "clear_robot_goal"; until: number } | undefined>(undefined);
export const waiting = signal(0);
/** Ticks twice a second, for whatever shows an age. */
export const clock = signal(now());

export const isConnected = computed(() => link.value === "open");
export const dataAgeMs = computed(() => (state.value === undefined ? 0 : Math.max(0, clock.value - stateAt.value)));
export const isStale = computed(() => state.value !== undefined && dataAgeMs.value > kStaleMs);
export const isStopped = computed(
  () => state.value?.base.latched === true || state.value?.base.stop_reasons.includes("requested") === true,
);
export const hasLostMe = computed(() => state.value?.person !== undefined && !state.value.person.tracked);

const outbox = new Outbox(
  {
    load: () => localStorage.getItem("tandem.outbox") ?? undefined,
    save: (text) => localStorage.setItem("tandem.outbox", text),
  },
  () => crypto.randomUUID(),
);
waiting.value = outbox.waiting.length;
let connection: Connection | undefined;

export function say(text: string, tone: Toast["tone"] = "plain"): void {
  toast.value = { text, tone, until: now() + kToastMs };
}

/** Opens the link; called once, after pairing. */
export function connect(): void {
  if (connection !== undefined) return;
  connection = new Connection({
    phase(phase) {
      link.value = phase;
      if (phase === "refused" && hello.value === undefined) screen.value = "no_link";
      if (phase === "moved") screen.value = "moved";
    },
    message: hear,
    belief: (grid) => (belief.value = grid),
    roundTrip: (ms) => (roundTripMs.value = ms),
  });
  setInterval(tick, 500);
}

function tick(): void {
  clock.value = now();
  if (toast.value !== undefined && toast.value.until < clock.value) toast.value = undefined;
  if (inform.value !== undefined && inform.value.until < clock.value) inform.value = undefined;
  if (undo.value !== undefined && undo.value.until < clock.value) undo.value = undefined;
}

function hear(message: GatewayMessage): void {
  switch (message.type) {
    case "hello":
      hello.value = message;
      for (const command of outbox.waiting) transmit(command);
      break;
    case "state":
      state.value = message;
      stateAt.value = now();
      clock.value = now();
      connection?.send({ type: "seen", sequence: message.sequence });
      break;
    case "plan":
      plan.value = message;
      break;
    case "map":
      map.value = message;
      break;
    case "ack":
      settle(message);
      break;
    case "event":
      if (message.kind === "found") {
        const at = message.x !== undefined && message.y !== undefined ? pointInMap(message.x, message.y) : undefined;
        foundAt.value = { by: message.text, at };
      } else if (message.kind === "inform" && message.id !== undefined) {
        inform.value = { id: message.id, text: message.text, until: now() + kInformMs };
      } else {
        say(message.text, message.kind === "error" ? "bad" : "plain");
      }
      break;
    case "pong":
      break;
  }
}

function settle(ack: Ack): void {
  outbox.acknowledge(ack.client, ack.up_to);
  waiting.value = outbox.waiting.length;
  if (ack.client !== outbox.client) return;
  for (const result of ack.results) {
    for (const kind of ["my_pose", "my_goal", "robot_goal", "robot_pose", "found"] as const) {
      const mine = chosen.value[kind];
      if (mine?.sequence !== result.sequence || mine.settled) continue;
      if (result.outcome === "applied") {
        chosen.value = { ...chosen.value, [kind]: { ...mine, settled: true } };
      } else {
        chosen.value = { ...chosen.value, [kind]: undefined };
      }
    }
    const fresh = result.sequence > shownRefusal;
    if (result.outcome === "refused" && fresh) {
      shownRefusal = result.sequence;
      say(`${t.value.refused}: ${result.reason}`, "bad");
    }
  }
}
let shownRefusal = 0;

function transmit(command: StoredCommand): boolean {
  return connection?.send(outbox.message(command, now())) ?? false;
}

/** Sends `wish`, or keeps it until the link is back and says so. */
function ask(wish: Wish): StoredCommand {
  const command = outbox.add(wish, now());
  const sent = transmit(command);
  waiting.value = outbox.waiting.length;
  if (!sent) say(wish.kind === "stop" ? t.value.stopNotSent : `${t.value[kNames[wish.kind]]}: ${t.value.queued}`, "bad");
  return command;
}

const kNames = {
  my_pose: "myPose",
  my_goal: "myGoal",
  robot_goal: "robotGoal",
  robot_pose: "robotPose",
  found: "foundIt",
  replan: "replan",
  clear_my_goal: "undo",
  clear_robot_goal: "undo",
  stop: "stop",
  resume: "resume",
} as const;

/** The person tapped the map at `at`: what that means depends on the tool. */
export function place(at: PointInMap): void {
  if (hello.value?.role === "observer") return;
  const kind = tool.value;
  const command = ask({ kind, at });
  chosen.value = { ...chosen.value, [kind]: { at, settled: false, sequence: command.sequence } };
  if (kind === "my_goal") undo.value = { kind: "clear_my_goal", until: now() + kUndoMs };
  if (kind === "robot_goal") undo.value = { kind: "clear_robot_goal", until: now() + kUndoMs };
  tool.value = "my_pose"; // the most frequent act
}

export function undoGoal(): void {
  if (undo.value === undefined) return;
  ask({ kind: undo.value.kind });
  const gone = undo.value.kind === "clear_my_goal" ? "my_goal" : "robot_goal";
  chosen.value = { ...chosen.value, [gone]: undefined };
  undo.value = undefined;
}

/** The person has taken notice of what the robot told them; without a link it goes on being shown. */
export function gotIt(): void {
  if (inform.value === undefined) return;
  if (connection?.send({ type: "got_it", id: inform.value.id }) === true) inform.value = undefined;
}

export function replan(): void {
  ask({ kind: "replan" });
}
export function stop(): void {
  ask({ kind: "stop" });
}
export function resume(heldMs: number): void {
  ask({ kind: "resume", heldMs });
}

/** A finger moved the map. */
export function look(moved: MapView): void {
  showsEverything.value = false;
  view.value = moved;
}

/** Height of the row of buttons along the lower edge of the map. */
const kButtonBand = 76;

/** Shows the whole map in a canvas of the given size, above the row of buttons; turned as `before` was. */
export function showEverything(width: number, height: number, before?: MapView): void {
  const one = map.value;
  if (one === undefined || height <= kButtonBand) return;
  showsEverything.value = true;
  const low = pointInMap(one.x, one.y);
  const high = pointInMap(one.x + one.width * one.resolution_m, one.y + one.height * one.resolution_m);
  const fit = fitted(low, high, pixels(width), pixels(height - kButtonBand), before);
  view.value = panned({ ...fit, height: pixels(height) }, pointOnScreen(0, 0), pointOnScreen(0, -kButtonBand / 2));
}
