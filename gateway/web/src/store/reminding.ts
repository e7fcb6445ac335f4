import { computed, effect, signal } from "@preact/signals";
import * as v from "valibot";
import { type CountedKind, counted, kNoCounts, parseCounters } from "../model/counters";
import { type ReminderRecord, type Reminding, dueAt, fire, firingOf, obey, startedAt } from "../model/reminder";
import { parsed } from "../protocol/fields";
import type { ReminderRule } from "../protocol/parse";
import { now } from "./clock";
import { kept } from "./kept";
import { t } from "./settings";
import { isBetweenPeople, isOver, isStopped, mayAct, say, session, tool } from "./signals";

const stored = kept("reminding");
const schema = v.strictObject({
  since: v.number(),
  threshold_ms: v.number(),
  fired: v.optional(
    v.strictObject({ at: v.number(), threshold_ms: v.number(), kind: v.picklist(["toast", "popup", "multimodal"]) }),
  ),
});

function loaded(): Reminding | undefined {
  const text = stored.load();
  const one = text === undefined ? undefined : parsed(schema, text);
  return one?.ok ? { fired: undefined, ...one.value } : undefined;
}

/** None before the first pose. */
const reminding = signal<Reminding | undefined>(loaded());
const countsKept = kept("counters");
const countsLoaded = countsKept.load();
const counters = signal(countsLoaded === undefined ? kNoCounts : parseCounters(countsLoaded));

effect(() => stored.save(JSON.stringify(reminding.value ?? {})));
effect(() => countsKept.save(JSON.stringify(counters.value)));

const rule = computed<ReminderRule | undefined>(() => session.value?.reminder);
/** Nobody is reminded before their first pose, while the robot is stopped, or after the end. */
const isPaused = computed(() => !mayAct.value || isOver.value || (isStopped.value && !isBetweenPeople.value));

/** The pop-up is open: nothing but STOP works until the person has placed My pose. */
export const popupIsOpen = computed(
  () => rule.value?.kind === "popup" && reminding.value?.fired?.kind === "popup" && !isPaused.value,
);
/** My pose blinks until it is placed. */
export const poseBlinks = computed(
  () => rule.value?.kind === "multimodal" && reminding.value?.fired?.kind === "multimodal" && !isPaused.value,
);
/** How often each message was accepted; none unless that is the reminder. */
export const counts = computed(() => (rule.value?.kind === "counters" ? counters.value.counts : undefined));

/** The phone has no vibrator that a page can use: the edge of the screen flashes instead. */
export const edgeFlashes = signal(false);

let record: (what: ReminderRecord) => void = () => undefined;
let timer: ReturnType<typeof setTimeout> | undefined;
let sound: AudioContext | undefined;

/** Where records of firing and obeying go. */
export function recordRemindersBy(how: (what: ReminderRecord) => void): void {
  record = how;
}

/** To be called in a tap: browsers let a page make sounds only then. */
export function allowSound(): void {
  sound ??= new AudioContext();
}

/** The person has said where they are, now. */
export function posed(): void {
  if (rule.value === undefined) return;
  const [next, obeyed] = reminding.value === undefined
    ? [startedAt(now(), rule.value), undefined]
    : obey(reminding.value, rule.value, now());
  reminding.value = next;
  if (obeyed !== undefined) record(obeyed);
}

export function count(kind: CountedKind, sequence: number): void {
  counters.value = counted(counters.value, kind, sequence);
}

// A new session counts and reminds anew.
effect(() => {
  if (session.value?.phase !== "preparing") return;
  reminding.value = undefined;
  counters.value = kNoCounts;
});

// A person who may go on gets the whole time again.
let wasStopped = false;
effect(() => {
  const before = reminding.peek();
  if (wasStopped && !isStopped.value && before !== undefined) reminding.value = { ...before, since: now() };
  wasStopped = isStopped.value;
});

effect(() => {
  const state = reminding.value;
  const one = rule.value;
  clearTimeout(timer);
  if (state === undefined || one === undefined || isPaused.value) return;
  const due = dueAt(state, one);
  if (due !== undefined) timer = setTimeout(remindIfDue, Math.max(0, due - now()));
});
// Timers stand still while the screen is off.
document.addEventListener("visibilitychange", () => {
  if (!document.hidden) remindIfDue();
});

function remindIfDue(): void {
  const state = reminding.value;
  const one = rule.value;
  if (state === undefined || one === undefined || isPaused.value) return;
  const fired = fire(state, one, now());
  if (fired === undefined) {
    const due = dueAt(state, one);
    clearTimeout(timer);
    if (due !== undefined) timer = setTimeout(remindIfDue, Math.max(1, due - now()));
    return; // a timer may be early by a little
  }
  reminding.value = fired[0];
  record(fired[1]);
  switch (firingOf(one)) {
    case "toast":
      say(t.value.remind, "remind");
      break;
    case "popup":
      tool.value = "my_pose";
      break;
    case "multimodal":
      shake();
      break;
    case undefined:
      break;
  }
}

const kPattern = [300, 150, 300];

function shake(): void {
  if ("vibrate" in navigator && navigator.vibrate(kPattern)) return;
  edgeFlashes.value = true;
  setTimeout(() => (edgeFlashes.value = false), 1500);
  if (sound === undefined) return;
  void sound.resume();
  const tone = sound.createOscillator();
  tone.frequency.value = 880;
  tone.connect(sound.destination);
  tone.start();
  tone.stop(sound.currentTime + 0.4);
}
