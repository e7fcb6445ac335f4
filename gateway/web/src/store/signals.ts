import { computed, signal } from "@preact/signals";
import type { MapView } from "../model/map_view";
import type { LinkPhase } from "../net/connection";
import type { BeliefGrid } from "../protocol/belief";
import type { PlaceKind, Wish } from "../protocol/commands";
import type { Hello, MapMessage, Plan, Session, Source, State } from "../protocol/parse";
import type { PointInMap } from "../units";
import { now } from "./clock";

const kStaleMs = 3000;
const kToastMs = 4000;

export type Screen = "pairing" | "no_link" | "refused" | "locked" | "unreachable" | "start" | "search" | "moved";
export type Toast = { readonly text: string; readonly tone: "plain" | "bad" | "remind"; readonly until: number };
/** What the robot thinks the person should know, until they have got it. */
export type Inform = { readonly id: string; readonly text: string; readonly until: number };
/** A place the person has chosen and that was not refused. */
export type Chosen = { readonly at: PointInMap; readonly settled: boolean; readonly sequence: number };
/** A grid over the map: where the object may be, what is searched, or nothing. */
export type Layer = "belief" | "explored" | "none";
export type Sheet = "settings" | "more";

export const screen = signal<Screen>("pairing");
export const link = signal<LinkPhase>("connecting");
export const roundTripMs = signal<number | undefined>(undefined);
export const hello = signal<Hello | undefined>(undefined);
export const session = signal<Session | undefined>(undefined);
export const state = signal<State | undefined>(undefined);
export const stateAt = signal(0);
export const plan = signal<Plan | undefined>(undefined);
export const sources = signal<readonly Source[]>([]);
export const map = signal<MapMessage | undefined>(undefined);
export const belief = signal<BeliefGrid | undefined>(undefined);
export const foundAt = signal<{ by: string; at: PointInMap | undefined } | undefined>(undefined);
export const view = signal<MapView | undefined>(undefined);
/** The view shows everything, and goes on to when the screen changes, until a finger moves it. */
export const showsEverything = signal(true);
/** The map turns so that the person looks up. */
export const headingUp = signal(false);
export const layer = signal<Layer>("belief");
export const tool = signal<PlaceKind>("my_pose");
export const sheet = signal<Sheet | undefined>(undefined);
export const toast = signal<Toast | undefined>(undefined);
export const inform = signal<Inform | undefined>(undefined);
export const chosen = signal<{ readonly [Kind in PlaceKind]?: Chosen | undefined }>({});
export const undo = signal<{ kind: "clear_my_goal" | "clear_robot_goal"; until: number } | undefined>(undefined);
/** What was too old when it arrived: is it still wanted? */
export const askAgain = signal<Wish | undefined>(undefined);
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
export const mayAct = computed(() => hello.value !== undefined && hello.value.role !== "observer");
/** Two people search without a robot. */
export const isBetweenPeople = computed(() => session.value?.mode === "human_human");
export const isOver = computed(() => session.value?.phase === "ended" || foundAt.value !== undefined);

export function say(text: string, tone: Toast["tone"] = "plain"): void {
  toast.value = { text, tone, until: now() + kToastMs };
}

/** For how long the planner has been computing; none while it does not. */
export const computingSeconds = computed(() => {
  const planner = state.value?.planner;
  if (planner?.activity !== "computing") return undefined;
  return Math.max(0, Math.round(planner.computing_s + dataAgeMs.value / 1000));
});
