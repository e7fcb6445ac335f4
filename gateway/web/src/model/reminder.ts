import type { ReminderRule } from "../protocol/parse";

/** What fires; counters only count. */
export type Firing = "toast" | "popup" | "multimodal";

/** How the reminding of My pose stands; kept over reloads. All times are of a clock that survives them [ms]. */
export type Reminding = {
  /** Since when the person has not said where they are, or since the last reminder. */
  readonly since: number;
  readonly threshold_ms: number;
  /** The first reminder that was not obeyed yet. */
  readonly fired: { readonly at: number; readonly threshold_ms: number; readonly kind: Firing } | undefined;
};

/** A record for the study. */
export type ReminderRecord = {
  readonly reminder: Firing;
  readonly threshold_ms: number;
  readonly obeyed_after_ms?: number;
};

export const firingOf = (rule: ReminderRule): Firing | undefined =>
  rule.kind === "none" || rule.kind === "counters" ? undefined : rule.kind;

/** From the first pose on, and again after every pose: the whole threshold. */
export const startedAt = (now: number, rule: ReminderRule): Reminding => ({
  since: now,
  threshold_ms: rule.threshold_ms,
  fired: undefined,
});

/** When the next reminder is due; a pop-up that is open needs no other. */
export function dueAt(state: Reminding, rule: ReminderRule): number | undefined {
  const kind = firingOf(rule);
  if (kind === undefined || (kind === "popup" && state.fired !== undefined)) return undefined;
  return state.since + state.threshold_ms;
}

/** A reminder fires at `now`: the next one comes sooner, as long as it is not obeyed. */
export function fire(state: Reminding, rule: ReminderRule, now: number): [Reminding, ReminderRecord] | undefined {
  const due = dueAt(state, rule);
  const kind = firingOf(rule);
  if (due === undefined || kind === undefined || now < due) return undefined;
  const next: Reminding = {
    since: now,
    threshold_ms: Math.min(state.threshold_ms, Math.max(rule.floor_ms, state.threshold_ms * rule.factor)),
    fired: state.fired ?? { at: now, threshold_ms: state.threshold_ms, kind },
  };
  return [next, { reminder: kind, threshold_ms: state.threshold_ms }];
}

/** The person says where they are at `now`: all begins anew, and what had fired was obeyed. */
export function obey(state: Reminding, rule: ReminderRule, now: number): [Reminding, ReminderRecord | undefined] {
  const { fired } = state;
  const record =
    fired === undefined
      ? undefined
      : { reminder: fired.kind, threshold_ms: fired.threshold_ms, obeyed_after_ms: Math.max(0, now - fired.at) };
  return [startedAt(now, rule), record];
}
