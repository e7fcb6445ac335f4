import { Outbox } from "../model/outbox";
import type { PlaceKind, StoredCommand, Wish } from "../protocol/commands";
import type { TextKey } from "../texts";
import { type PointInMap, pointInMap } from "../units";
import { now } from "./clock";
import { kept } from "./kept";
import { posed } from "./reminding";
import { t } from "./settings";
import { askAgain, chosen, hello, layer, mayAct, say, tool, undo, waiting } from "./signals";
import type { Layer } from "./signals";

const kUndoMs = 5000;

export const outbox = new Outbox(kept("outbox"), () => crypto.randomUUID());
waiting.value = outbox.waiting.length;

type Transmit = (message: object) => boolean;
let transmit: Transmit = () => false;

/** How messages leave from now on. */
export function transmitBy(how: Transmit): void {
  transmit = how;
}

const send = (command: StoredCommand): boolean => transmit(outbox.message(command, now(), performance.now()));

/** Sends again whatever has no receipt yet. */
export function sendAgain(): void {
  for (const command of outbox.waiting) send(command);
}

/** How a wish is called. */
export function nameOf(wish: Wish): TextKey {
  switch (wish.kind) {
    case "my_pose":
      return "myPose";
    case "my_goal":
      return "myGoal";
    case "robot_goal":
      return "robotGoal";
    case "robot_pose":
      return "robotPose";
    case "found":
      return "foundIt";
    case "replan":
      return "replan";
    case "clear_my_goal":
    case "clear_robot_goal":
      return "undo";
    case "stop":
      return "stop";
    case "resume":
      return "resume";
    case "source_edit":
    case "belief_edit":
      return wish.edit;
    case "reminder":
    case "layer":
      return "record";
  }
}

/** Sends `wish`, or keeps it until the link is back and says so. */
export function ask(wish: Wish): StoredCommand {
  const command = outbox.add(wish, now());
  const sent = send(command);
  waiting.value = outbox.waiting.length;
  const isRecord = wish.kind === "reminder" || wish.kind === "layer";
  if (!sent && !isRecord) {
    say(wish.kind === "stop" ? t.value.stopNotSent : `${t.value[nameOf(wish)]}: ${t.value.queued}`, "bad");
  }
  return command;
}

/** The person tapped the map at `at`: what that means depends on the tool. */
export function place(at: PointInMap): void {
  if (!mayAct.value) return;
  const kind = tool.value;
  const command = ask({ kind, x: at.x, y: at.y });
  chosen.value = { ...chosen.value, [kind]: { at, settled: false, sequence: command.sequence } };
  if (kind === "my_pose") posed();
  if (kind === "my_goal") undo.value = { kind: "clear_my_goal", until: now() + kUndoMs };
  if (kind === "robot_goal") undo.value = { kind: "clear_robot_goal", until: now() + kUndoMs };
  tool.value = "my_pose"; // the most frequent act
}

export function forget(kind: PlaceKind): void {
  chosen.value = { ...chosen.value, [kind]: undefined };
}

export function undoGoal(): void {
  if (undo.value === undefined) return;
  ask({ kind: undo.value.kind });
  forget(undo.value.kind === "clear_my_goal" ? "my_goal" : "robot_goal");
  undo.value = undefined;
}

/** The person still wants what was too old, or not. */
export function answerAskAgain(wanted: boolean): void {
  const wish = askAgain.value;
  askAgain.value = undefined;
  if (!wanted || wish === undefined) return;
  const command = ask(wish);
  if ("x" in wish) {
    const at = pointInMap(wish.x, wish.y);
    chosen.value = { ...chosen.value, [wish.kind]: { at, settled: false, sequence: command.sequence } };
  }
}

export function replan(): void {
  ask({ kind: "replan" });
}
export function stop(): void {
  ask({ kind: "stop" });
}
export function resume(heldMs: number): void {
  ask({ kind: "resume", held_ms: Math.min(60_000, Math.round(heldMs)) });
}

const kLayers: readonly Layer[] = ["belief", "explored", "none"];

/** The next layer of the map; what is shown is recorded. */
export function nextLayer(): void {
  const before = layer.value;
  const after = kLayers[(kLayers.indexOf(before) + 1) % kLayers.length] ?? "none";
  layer.value = after;
  if (!mayAct.value) return;
  if (before !== "none") ask({ kind: "layer", layer: before, shown: false });
  if (after !== "none") ask({ kind: "layer", layer: after, shown: true });
}

/** The first layer is shown from the start: that is a record, too. */
export function recordFirstLayer(): void {
  if (hello.value !== undefined && mayAct.value && layer.value !== "none") {
    ask({ kind: "layer", layer: layer.value, shown: true });
  }
}
