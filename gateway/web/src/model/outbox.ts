import { type StoredCommand, type StoredOutbox, type Wish, parseOutbox } from "../protocol/commands";

/** Where something survives a reload: localStorage, or a variable in tests. */
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
  find(sequence: number): StoredCommand | undefined {
    return this.stored.waiting.find((one) => one.sequence === sequence);
  }

  /** Adds `wish`, pressed at `now` [ms of a clock that survives a reload]. */
  add(wish: Wish, now: number): StoredCommand {
    const command: StoredCommand = { sequence: this.stored.next, pressed_at: now, wish };
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

  /** `command` as it goes on the wire at `now`, which is `sentAt` by the clock of pings. */
  message(command: StoredCommand, now: number, sentAt: number): object {
    const age = Math.max(0, Math.round(now - command.pressed_at));
    const { client } = this.stored;
    return { type: "cmd", client, sequence: command.sequence, age_ms: age, sent_at_ms: sentAt, ...command.wish };
  }

  private save(): void {
    this.storage.save(JSON.stringify(this.stored));
  }
}
