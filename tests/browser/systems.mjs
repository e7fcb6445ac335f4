// What a phone can talk to in a test: the gateway with a fake team behind it, or everything `tandem up` starts.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { folder, start, until } from "./processes.mjs";

/** The JSON lines among what `started` has printed. */
const jsonOf = (started) => started.lines.filter((line) => line.startsWith("{")).map((line) => JSON.parse(line));

/** tandem-gateway on a fake team that takes every message and says so in `heard()`. */
export async function fakeTeam(build) {
  const fake = start(join(build, "tests/fake_team"));
  const heard = () => jsonOf(fake);
  const { domain } = await until("the fake team says its domain", () => heard().find((line) => "domain" in line));
  const config = join(folder, "config");
  const linkFile = join(folder, "participant_link");
  mkdirSync(config);
  writeFileSync(join(config, "site.toml"), `host = "laptop1"\nrole = "laptop"\nhost_domain = ${domain}\n`);
  writeFileSync(
    join(config, "gateway.toml"),
    `address = "127.0.0.1"\nport = 0\nlink_host = "127.0.0.1"\nprint_qr_code = false\n` +
      `state_folder = "${join(folder, "state")}"\nparticipant_link_file = "${linkFile}"\n`,
  );
  start(join(build, "bin/tandem-gateway"), ["--config", config]);
  return { linkFile, domain, heard };
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
  return {
    changes: () => watch.lines.length,
    newest: () => (watch.lines.length === 0 ? { left_mps: 0, right_mps: 0 } : JSON.parse(watch.lines.at(-1))),
    speed() {
      return turning(this.newest());
    },
    /** The fastest since `changes()` was `from`. */
    fastestSince: (from) => Math.max(0, ...watch.lines.slice(from).map((line) => turning(JSON.parse(line)))),
  };
}
