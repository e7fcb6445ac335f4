import { signal } from "@preact/signals";
import { drawnOn, region } from "../model/outline";
import type { Wish } from "../protocol/commands";
import type { PointInMap } from "../units";
import { sheet } from "./signals";
import { ask } from "./wishes";

export const kSourceEdits = ["avoid", "pass_through", "go_to", "stay_behind"] as const;
export const kBeliefEdits = ["likely_here", "not_here", "searched", "look_again"] as const;
export type SourceEdit = (typeof kSourceEdits)[number];
export type BeliefEdit = (typeof kBeliefEdits)[number];
export type PlacedEdit = Exclude<SourceEdit, "stay_behind"> | BeliefEdit;
export type Strength = "a_bit" | "quite" | "very" | "roughly" | "well";
export type Target = "everybody" | "robot" | "me";

/** What is being drawn. */
export type Drawing = {
  readonly edit: PlacedEdit;
  readonly outline: readonly PointInMap[];
  readonly strength: Strength;
  readonly target: Target;
};

export const drawing = signal<Drawing | undefined>(undefined);

export const strengthsOf = (edit: PlacedEdit): readonly Strength[] =>
  edit === "searched" ? ["roughly", "well"] : ["a_bit", "quite", "very"];
/** Whom it can be for; none: it is no matter of somebody. A team of two is not sent to one place. */
export function targetsOf(edit: PlacedEdit): readonly Target[] {
  if (edit === "avoid") return ["everybody", "robot", "me"];
  return edit === "pass_through" || edit === "go_to" ? ["robot", "me"] : [];
}

export function beginDrawing(edit: PlacedEdit): void {
  sheet.value = undefined;
  drawing.value = {
    edit,
    outline: [],
    strength: edit === "searched" ? "well" : "quite",
    target: edit === "avoid" ? "everybody" : "robot",
  };
}

/** A finger draws on; `anew` where it came down. */
export function drawTo(at: PointInMap, anew: boolean): void {
  const one = drawing.value;
  if (one !== undefined) drawing.value = { ...one, outline: drawnOn(anew ? [] : one.outline, at) };
}

export function setDrawing(change: Partial<Pick<Drawing, "strength" | "target">>): void {
  if (drawing.value !== undefined) drawing.value = { ...drawing.value, ...change };
}

export function cancelDrawing(): void {
  drawing.value = undefined;
}

function wishOf({ edit, outline: corners, strength, target }: Drawing): Wish | undefined {
  const outline = region(corners);
  const graded = strength === "roughly" || strength === "well" ? "quite" : strength;
  switch (edit) {
    case "avoid":
      return { kind: "source_edit", edit, outline, strength: graded, target };
    case "pass_through":
    case "go_to":
      return { kind: "source_edit", edit, outline, strength: graded, target: target === "me" ? "me" : "robot" };
    case "searched":
      return { kind: "belief_edit", edit, outline, strength: strength === "roughly" ? "roughly" : "well" };
    default:
      return { kind: "belief_edit", edit, outline, strength: graded };
  }
}

export function sendDrawing(): void {
  const one = drawing.value;
  if (one === undefined || one.outline.length === 0) return;
  const wish = wishOf(one);
  if (wish !== undefined) ask(wish);
  drawing.value = undefined;
}

export function stayBehind(): void {
  sheet.value = undefined;
  ask({ kind: "source_edit", edit: "stay_behind" });
}

export function removeSource(source: string): void {
  ask({ kind: "source_edit", edit: "remove", source });
}
