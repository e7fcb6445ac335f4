// A bad Wi-Fi between phone and gateway, for real: bytes that vanish, connections that are cut or refused.
import { createServer, connect } from "node:net";

/** Forwards 127.0.0.1:`port` to 127.0.0.2:`port` as long as it is "up". */
export class Proxy {
  #mode = "up";
  #pairs = new Set();
  #server;

  constructor(port) {
    this.port = port;
    this.#server = createServer((phone) => this.#accept(phone));
  }

  listen() {
    return new Promise((resolve) => this.#server.listen(this.port, "127.0.0.1", resolve));
  }

  /** "up"; "blackhole": whatever is sent vanishes, both ways; "refuse": nobody gets through. */
  set mode(mode) {
    this.#mode = mode;
    for (const [phone, gateway] of this.#pairs) {
      for (const socket of [phone, gateway]) mode === "blackhole" ? socket.pause() : socket.resume();
    }
  }

  /** Cuts every connection with a reset. */
  reset() {
    for (const [phone, gateway] of this.#pairs) {
      phone.resetAndDestroy();
      gateway.destroy();
    }
  }

  close() {
    this.reset();
    this.#server.close();
  }

  #accept(phone) {
    if (this.#mode === "refuse") return phone.resetAndDestroy();
    const gateway = connect({ host: "127.0.0.2", port: this.port });
    const pair = [phone, gateway];
    this.#pairs.add(pair);
    for (const [from, to] of [[phone, gateway], [gateway, phone]]) {
      from.on("data", (bytes) => to.write(bytes));
      from.on("error", () => undefined);
      from.on("close", () => {
        this.#pairs.delete(pair);
        to.destroy();
      });
      if (this.#mode === "blackhole") from.pause();
    }
    return undefined;
  }
}
