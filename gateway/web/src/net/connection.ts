import { type GatewayMessage, parseMessage } from "../protocol/parse";
import { type BeliefGrid, parseBelief } from "../protocol/belief";

export type LinkPhase = "connecting" | "open" | "lost" | "refused" | "moved";

export type ConnectionEvents = {
  phase(phase: LinkPhase): void;
  message(message: GatewayMessage): void;
  belief(grid: BeliefGrid): void;
  roundTrip(ms: number): void;
};

const kPingEveryMs = 1000;
/** States come every second at least: silence for this long is a dead link, whatever the socket believes. */
const kSilenceMs = 3500;
const kRetryMs = [300, 1000, 2000];

/** The WebSocket to the gateway that hosts this page; opens itself again for ever. */
export class Connection {
  private socket: WebSocket | undefined;
  private tries = 0;
  private heardAt = 0;
  private ended = false;

  constructor(private readonly events: ConnectionEvents) {
    this.open();
    setInterval(() => this.beat(), kPingEveryMs);
    document.addEventListener("visibilitychange", () => {
      if (!document.hidden) this.beat();
    });
  }

  /** False, and nothing sent, while the link is down. */
  send(message: object): boolean {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify(message));
    return true;
  }

  private open(): void {
    this.events.phase(this.tries === 0 ? "connecting" : "lost");
    const socket = new WebSocket(`wss://${location.host}/ws`, "tandem.v1");
    socket.binaryType = "arraybuffer";
    let opened = false;
    socket.onopen = () => {
      opened = true;
      this.tries = 0;
      this.heardAt = performance.now();
      this.events.phase("open");
      this.beat();
    };
    socket.onmessage = ({ data }: MessageEvent<string | ArrayBuffer>) => this.hear(data);
    socket.onclose = ({ code }) => {
      if (this.socket !== socket) return;
      this.socket = undefined;
      if (code === 4001) {
        this.ended = true;
        this.events.phase("moved");
        return;
      }
      if (!opened && this.tries >= 3) this.events.phase("refused");
      this.retry();
    };
    this.socket = socket;
  }

  private retry(): void {
    if (this.ended) return;
    const wait = kRetryMs[Math.min(this.tries, kRetryMs.length - 1)] ?? 1000;
    this.tries += 1;
    if (this.tries < 4) this.events.phase("lost");
    setTimeout(() => this.open(), wait);
  }

  private beat(): void {
    if (this.socket?.readyState !== WebSocket.OPEN) return;
    if (performance.now() - this.heardAt > kSilenceMs) {
      const dead = this.socket;
      this.socket = undefined;
      dead.close();
      this.retry();
      return;
    }
    this.send({ type: "ping", sent_at_ms: performance.now() });
  }

  private hear(data: string | ArrayBuffer): void {
    this.heardAt = performance.now();
    if (typeof data !== "string") {
      const grid = parseBelief(data);
      if (grid.ok) this.events.belief(grid.value);
      return;
    }
    const message = parseMessage(data);
    if (!message.ok) {
      console.warn("message not understood:", message.reason);
      return;
    }
    if (message.value.type === "pong") {
      this.events.roundTrip(performance.now() - message.value.sent_at_ms);
    } else {
      this.events.message(message.value);
    }
  }
}
