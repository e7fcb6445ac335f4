import { type ClientMessage, type StoredCommand, type StoredOutbox, parseOutbox } from "../protocol/parse";
import type { PointInMap } from "../units";

export type PlaceKind = "my_pose" | "my_goal" | "robot_goal" | "robot_pose" | "found";
export type PlainKind = "replan" | "clear_my_goal" | "clear_robot_goal" | "stop";
/** What the person asks for. */
export type Wish =
  | { readonly kind: PlaceKind; readonly at: PointInMap }
  | { readonly kind: PlainKind }
  | { readonly kind: "resume"; readonly heldMs: number };

/** Where the outbox survives a reload: localStorage, or a Map in tests. */
export type Storage = { load(): string | undefined; save(text: string): void };

/**
 * Commands whose fate the gateway has not told, in order, numbered without gaps; kept over reloads.
 *
 * Everything in it is sent again after each reconnection; the gateway applies each once.
 */
export class Outbox {
  private stored: StoredOutbox;

  constructor(
    private readonly storage: Storage,
    newClient: () => string,
  ) {
    const left = storage.load();
    const parsed = left === undefined ? undefined : parseOutbox(left);
    this.stored = parsed?.ok ? parsed.value : { client: newClient(), next: 1, waiting: [] };
    this.save();
  }

  get client(): string {
    return this.stored.client;
  }
  get waiting(): readonly StoredCommand[] {
    return this.stored.waiting;
  }

  /** Adds `wish`, pressed at `now` [ms of a clock that survives a reload]. */
  add(wish: Wish, now: number): StoredCommand {
    const command: StoredCommand = {
      sequence: this.stored.next,
      kind: wish.kind,
      pressed_at: now,
      ...("at" in wish ? { x: wish.at.x, y: wish.at.y } : {}),
      ...(wish.kind === "resume" ? { held_ms: Math.min(60_000, Math.round(wish.heldMs)) } : {}),
    };
    this.stored = { ...this.stored, next: this.stored.next + 1, waiting: [...this.stored.waiting, command] };
    this.save();
    return command;
  }

  /** Forgets those whose fate is known: everything up to `upTo`. */
  acknowledge(client: string, upTo: number): void {
    if (client !== this.stored.client) return;
    const waiting = this.stored.waiting.filter((one) => one.sequence > upTo);
    if (waiting.length === this.stored.waiting.length) return;
    this.stored = { ...this.stored, waiting };
    this.save();
  }

  /** `command` as it goes on the wire at `now`. */
  message(command: StoredCommand, now: number): ClientMessage {
    const head = {
      type: "cmd" as const,
      client: this.stored.client,
      sequence: command.sequence,
      age_ms: Math.max(0, Math.round(now - command.pressed_at)),
    };
    const { kind, x = 0, y = 0 } = command;
    switch (kind) {
      case "my_pose":
      case "robot_pose":
        return { ...head, kind, x, y };
      case "my_goal":
      case "robot_goal":
      case "found":
        return { ...head, kind, x, y };
      case "resume":
        return { ...head, kind, held_ms: command.held_ms ?? 0 };
      default:
        return { ...head, kind };
    }
  }

  private save(): void {
    this.storage.save(JSON.stringify(this.stored));
  }
}
