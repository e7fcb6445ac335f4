// What a phone can talk to in a test: the gateway with a fake team behind it, or everything `tandem up` starts.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { createServer } from "node:net";
import { join } from "node:path";
import { folder, kill, start, until } from "./processes.mjs";

/** The JSON lines among what `started` has printed. */
const jsonOf = (started) => started.lines.filter((line) => line.startsWith("{")).map((line) => JSON.parse(line));

/** A port that nobody listens on. */
export function freePort() {
  return new Promise((resolve) => {
    const server = createServer().listen(0, "127.0.0.1", () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });
}

/**
 * tandem-gateway on a fake team that takes every message and says so in `heard()`, and does what `tell` says.
 *
 * `settings` are lines of gateway.toml; `restart` kills the gateway and starts it anew. With a `port` the gateway
 * listens on it at 127.0.0.2, and phones reach it through whatever listens at 127.0.0.1.
 */
export async function fakeTeam(build, { settings = [], port } = {}) {
  const fake = start(join(build, "tests/fake_team"));
  const heard = () => jsonOf(fake);
  const { domain } = await until("the fake team says its domain", () => heard().find((line) => "domain" in line));
  const config = join(folder, "config");
  const linkFile = join(folder, "participant_link");
  mkdirSync(config, { recursive: true });
  writeFileSync(join(config, "site.toml"), `host = "laptop1"\nrole = "laptop"\nhost_domain = ${domain}\n`);
  const lines = [
    port === undefined ? `address = "127.0.0.1"\nport = 0` : `address = "127.0.0.2"\nport = ${port}`,
    `link_host = "127.0.0.1"`,
    `print_qr_code = false`,
    `connections_per_address = 32`,
    `state_folder = "${join(folder, "state")}"`,
    `participant_link_file = "${linkFile}"`,
    `observer_link_file = "${join(folder, "observer_link")}"`,
    `operator_link_file = "${join(folder, "operator_link")}"`,
    `partner_link_file = "${join(folder, "partner_link")}"`,
    ...settings,
  ];
  writeFileSync(join(config, "gateway.toml"), `${lines.join("\n")}\n`);
  const gateway = () => start(join(build, "bin/tandem-gateway"), ["--config", config]);
  let running = gateway();
  return {
    linkFile,
    link: (slot) => pairingLink({ linkFile: join(folder, `${slot}_link`) }),
    domain,
    heard,
    tell: (line) => fake.child.stdin.write(`${line}\n`),
    /** A gateway that hears and says nothing, until it is thawed. */
    freeze: () => running.child.kill("SIGSTOP"),
    thaw: () => running.child.kill("SIGCONT"),
    restart: async () => {
      await kill(running);
      running = gateway();
    },
  };
}

/** The real processes of robot and laptop in a simulated world, a session running, a person wanted. */
export async function wholeSystem(build, scenario) {
  const output = join(folder, "search");
  const up = start(join(build, "bin/tandem"),
    ["up", "--simulate", scenario, "--play", "--headless", "--seed", "1", "--output", output]);
  const linkFile = join(output, "run.d/participant.link");
  await until("the session runs", () => up.lines.some((line) => /^\S+ searching /.test(line)), 60);
  const site = readFileSync(join(output, "run.d/robot/site.toml"), "utf8");
  return { linkFile, domain: Number(/^host_domain = (\d+)/m.exec(site)[1]) };
}

/** The pairing link, as soon as the gateway has written it. */
export async function pairingLink({ linkFile }) {
  await until("the pairing link is written", () => existsSync(linkFile));
  return readFileSync(linkFile, "utf8").trim();
}

/** The true wheels of the robot on `domain`. */
export function watchWheels(build, domain) {
  const watch = start(join(build, "tests/wheel_watch"), [String(domain)]);
  const turning = ({ left_mps: left, right_mps: right }) => Math.max(Math.abs(left), Math.abs(right));
  const all = () => watch.lines.map((line) => JSON.parse(line));
  return {
    newest: () => all().at(-1) ?? { unix_ms: 0, left_mps: 0, right_mps: 0 },
    speed() {
      return turning(this.newest());
    },
    /** The fastest since `unix_ms`, that at this moment included. */
    fastestSince(unix_ms) {
      const before = all().filter((line) => line.unix_ms <= unix_ms).at(-1);
      const after = all().filter((line) => line.unix_ms > unix_ms);
      return Math.max(0, ...[...(before === undefined ? [] : [before]), ...after].map(turning));
    },
    /** When they first stood after `unix_ms`; undefined while they have not. */
    standingAfter: (unix_ms, standing_mps) =>
      all().find((line) => line.unix_ms > unix_ms && turning(line) < standing_mps)?.unix_ms,
  };
}
