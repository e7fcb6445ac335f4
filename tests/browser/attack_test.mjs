// Requests that must be refused, each with its answer: a table, played against the real gateway over real TLS.
//
//   node attack_test.mjs --build BUILD_FOLDER
import { spawn } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import https from "node:https";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import tls from "node:tls";
import { parseArgs } from "node:util";

const require = createRequire(new URL("../../gateway/web/package.json", import.meta.url));
const { WebSocket } = require("ws");

const { values: options } = parseArgs({ options: { build: { type: "string" } } });
const folder = mkdtempSync(join(tmpdir(), "tandem-attack-"));
const children = [];

/** A phone that may have any manners. `heard` holds what came, `closed` the code of the end. */
function openSocket(port, cookie) {
  const socket = new WebSocket(`wss://localhost:${port}/ws`, "tandem.v1",
    { rejectUnauthorized: false, origin: `https://localhost:${port}`, headers: { Cookie: cookie } });
  const phone = { socket, heard: [], closed: undefined };
  socket.on("message", (data, isBinary) => isBinary || phone.heard.push(JSON.parse(data)));
  socket.on("close", (code) => (phone.closed = code));
  socket.on("error", () => undefined);
  return phone;
}

const command = (sequence, kind, more = {}) =>
  JSON.stringify({ type: "cmd", client: "attacker-1", sequence, kind, age_ms: 0, ...more });

/** The fate of the command of this number. */
function fateOf(phone, sequence) {
  return until(`the fate of command ${sequence}`, () =>
    phone.heard.filter((one) => one.type === "ack").flatMap((one) => one.results)
      .find((one) => one.sequence === sequence));
}

function start(program, args) {
  const child = spawn(join(options.build, program), args, { stdio: ["ignore", "pipe", "ignore"] });
  children.push(child);
  return child;
}

async function until(what, condition, seconds = 20) {
  for (const end = Date.now() + 1000 * seconds; Date.now() < end; ) {
    const value = await condition();
    if (value) return value;
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  throw new Error(`never happened within ${seconds} s: ${what}`);
}

/** The status and headers of the answer; status 0 when the connection was cut. */
function ask({ port, method = "GET", path = "/", headers = {}, body, host }) {
  return new Promise((resolve) => {
    const request = https.request(
      { host: "127.0.0.1", port, method, path, rejectUnauthorized: false, agent: false,
        headers: { Host: host ?? `localhost:${port}`, ...headers } },
      (response) => {
        response.resume();
        response.on("end", () => resolve({ status: response.statusCode, headers: response.headers }));
      },
    );
    request.on("upgrade", (response, socket) => {
      socket.destroy();
      resolve({ status: response.statusCode, headers: response.headers });
    });
    request.on("error", () => resolve({ status: 0, headers: {} }));
    request.end(body);
  });
}

const kUpgrade = {
  Connection: "Upgrade",
  Upgrade: "websocket",
  "Sec-WebSocket-Version": "13",
  "Sec-WebSocket-Key": "dGhlIHNhbXBsZSBub25jZQ==",
  "Sec-WebSocket-Protocol": "tandem.v1",
};

let failures = 0;
function expect(what, actual, wanted) {
  const good = actual === wanted;
  if (!good) failures += 1;
  console.log(`${good ? "ok  " : "FAIL"} ${what}: ${actual}${good ? "" : `, not ${wanted}`}`);
}

/** What phones that are let in try: rights they have not, sizes, rates, repetitions, texts that are none. */
async function misbehave(port, participant, observer) {
  const looks = openSocket(port, observer);
  await until("the observer is let in", () => looks.heard.length > 0);
  let number = 0;
  const outline = [[1, 1]];
  for (const [kind, more] of [["my_pose", { x: 1, y: 1 }], ["my_goal", { x: 1, y: 1 }], ["robot_goal", { x: 1, y: 1 }],
    ["robot_pose", { x: 1, y: 1 }], ["replan"], ["clear_my_goal"], ["clear_robot_goal"], ["found", { x: 1, y: 1 }],
    ["resume", { held_ms: 2000 }], ["source_edit", { edit: "avoid", outline, strength: "very", target: "robot" }],
    ["belief_edit", { edit: "not_here", outline, strength: "very" }],
    ["reminder", { reminder: "toast", threshold_ms: 1 }], ["layer", { layer: "belief", shown: true }]]) {
    looks.socket.send(command((number += 1), kind, more));
    expect(`an observer's ${kind}`, (await fateOf(looks, number)).outcome, "refused");
  }
  looks.socket.close();

  const huge = openSocket(port, participant);
  await until("the participant is let in", () => huge.heard.length > 0);
  huge.socket.send("x".repeat(17 * 1024));
  await until("it is closed", () => huge.closed !== undefined);
  expect("a message of 17 kB", huge.closed, 1009);

  const binary = openSocket(port, participant);
  await until("the participant is let in", () => binary.heard.length > 0);
  binary.socket.send(Buffer.from([1, 2, 3]));
  await until("it is closed", () => binary.closed !== undefined);
  expect("a binary message", binary.closed, 1003);

  const rude = openSocket(port, participant);
  await until("the participant is let in", () => rude.heard.length > 0);
  for (const text of ["{", '{"type":"cmd","__proto__":1}', "[".repeat(3000)]) rude.socket.send(text);
  await until("it is closed", () => rude.closed !== undefined);
  expect("three texts that are no messages", rude.closed, 4002);

  const fast = openSocket(port, participant);
  await until("the participant is let in", () => fast.heard.length > 0);
  const sent = 80;
  const client = { client: "attacker-2" };
  for (let i = 1; i <= sent; i += 1) fast.socket.send(command(i, "my_pose", { x: 1e4, y: 1e4, ...client }));
  const late = await fateOf(fast, sent);
  expect("the eightieth command of a burst", late.outcome, "refused");
  expect("a held Resume that was not held", await (async () => {
    fast.socket.send(command(sent + 1, "resume", { held_ms: 10, ...client }));
    return (await fateOf(fast, sent + 1)).reason;
  })(), "hold for one second");
  expect("a command of an hour ago", await (async () => {
    fast.socket.send(command(sent + 2, "robot_goal", { x: 1, y: 1, ...client, age_ms: 3_600_000 }));
    return (await fateOf(fast, sent + 2)).reason;
  })(), "too old, it waited for the connection");
  fast.socket.send(command(sent + 9, "replan", client));
  const gap = await until("the gap is told", () => fast.heard.find((one) => one.type === "event"));
  expect("a number after a gap", gap.text, `a command before number ${sent + 9} is missing`);
  fast.heard.length = 0;
  fast.socket.send(command(sent + 2, "replan", client)); // the number of another command: that one's fate comes again
  expect("a number for the second time", (await fateOf(fast, sent + 2)).reason, "too old, it waited for the connection");
  fast.socket.close();
}

/** A head that never ends is waited for as long as the limit says. */
function slowHead(port) {
  return new Promise((resolve) => {
    const from = performance.now();
    const socket = tls.connect({ host: "127.0.0.1", port, rejectUnauthorized: false }, () => socket.write("GET / HT"));
    socket.on("close", () => resolve((performance.now() - from) / 1000));
    socket.on("error", () => undefined);
    socket.resume();
  });
}

async function run() {
  const fake = start("tests/fake_team", []);
  const first = await new Promise((resolve) => fake.stdout.once("data", (chunk) => resolve(String(chunk))));
  const { domain } = JSON.parse(first.split("\n")[0]);
  fake.kill("SIGTERM");
  const linkFile = join(folder, "participant_link");
  mkdirSync(join(folder, "config"));
  writeFileSync(join(folder, "config/site.toml"), `host = "laptop1"\nrole = "laptop"\nhost_domain = ${domain}\n`);
  writeFileSync(
    join(folder, "config/gateway.toml"),
    `address = "127.0.0.1"\nport = 0\nprint_qr_code = false\nstate_folder = "${folder}/state"\n` +
      `participant_link_file = "${linkFile}"\nconnections_per_address = 32\n` +
      `observer_link_file = "${join(folder, "observer_link")}"\n`,
  );
  start("bin/tandem-gateway", ["--config", join(folder, "config")]);
  await until("the link is written", () => existsSync(linkFile));
  const link = new URL(readFileSync(linkFile, "utf8").trim());
  const port = Number(link.port);
  const token = new URLSearchParams(link.hash.slice(1)).get("t");
  const origin = `https://localhost:${port}`;
  const json = { "Content-Type": "application/json", Origin: origin };
  const pair = (body, headers = json, host) => ask({ port, method: "POST", path: "/api/pair", headers, body, host });
  const good = JSON.stringify({ token });

  const page = await ask({ port });
  expect("the page", page.status, 200);
  const policy = page.headers["content-security-policy"] ?? "";
  expect("nothing may run but our own script", /default-src 'none'; script-src 'self';/.test(policy), true);
  expect("no other page may frame it", policy.includes("frame-ancestors 'none'"), true);
  expect("no type guessing", page.headers["x-content-type-options"], "nosniff");

  expect("a foreign Host (DNS rebinding)", (await ask({ port, host: `evil.org:${port}` })).status, 403);
  expect("a Host without port", (await ask({ port, host: "localhost" })).status, 403);
  for (const path of ["/../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/assets/", "/index.html%00.js", "/api/pair"]) {
    expect(`GET ${path}`, (await ask({ port, path })).status, 404);
  }
  expect("DELETE", (await ask({ port, method: "DELETE" })).status, 405);
  expect("a header of 9 kB", (await ask({ port, headers: { "X-Long": "x".repeat(9000) } })).status, 431);
  expect("a body of 17 kB", (await pair("x".repeat(17 * 1024))).status, 413);
  expect("pairing as text/plain", (await pair(good, { "Content-Type": "text/plain", Origin: origin })).status, 415);
  expect("pairing from another page", (await pair(good, { ...json, Origin: "https://evil.org" })).status, 403);
  expect("pairing without Origin", (await pair(good, { "Content-Type": "application/json" })).status, 403);
  expect("pairing with half a JSON", (await pair('{"token":')).status, 400);
  expect("a socket without cookie", (await ask({ port, path: "/ws", headers: { ...kUpgrade, Origin: origin } })).status, 401);

  const paired = await pair(good);
  expect("pairing with the link's token", paired.status, 200);
  const setCookie = paired.headers["set-cookie"]?.[0] ?? "";
  expect("the cookie's flags", /^__Host-sid=[0-9a-f]{64}; Path=\/; Secure; HttpOnly; SameSite=Strict/.test(setCookie), true);
  const cookie = { Cookie: setCookie.split(";")[0] };
  const socket = (headers, path = "/ws") => ask({ port, path, headers: { ...kUpgrade, ...cookie, ...headers } });
  expect("a socket with cookie and Origin", (await socket({ Origin: origin })).status, 101);
  expect("a socket from another page", (await socket({ Origin: "https://evil.org" })).status, 403);
  expect("a socket without Origin", (await socket({})).status, 403);
  expect("a socket with a made-up cookie", (await socket({ Origin: origin, Cookie: "__Host-sid=" + "0".repeat(64) })).status, 401);
  expect("a socket of another protocol", (await socket({ Origin: origin, "Sec-WebSocket-Protocol": "chat" })).status, 400);
  expect("a socket at another path", (await socket({ Origin: origin }, "/")).status, 400);

  const observerLink = new URL(readFileSync(join(folder, "observer_link"), "utf8").trim());
  const observerToken = new URLSearchParams(observerLink.hash.slice(1)).get("t");
  const observer = await pair(JSON.stringify({ token: observerToken }));
  await misbehave(port, cookie.Cookie, observer.headers["set-cookie"][0].split(";")[0]);
  const seconds = await slowHead(port);
  expect("a head that never ends is cut after 5 s", seconds > 4 && seconds < 12, true);

  expect("the token a second time", (await pair(good)).status, 403);
  const statuses = [];
  for (let i = 0; i < 5; ++i) statuses.push((await pair(JSON.stringify({ token: `guess${i}` }))).status);
  expect("five wrong tokens lock the address", statuses.join(" "), "403 403 403 403 429");

  const old = await new Promise((resolve) => {
    const connection = tls.connect({ host: "127.0.0.1", port, maxVersion: "TLSv1.1", minVersion: "TLSv1.1",
      ciphers: "DEFAULT:@SECLEVEL=0", rejectUnauthorized: false }, () => resolve("accepted"));
    connection.on("error", () => resolve("refused"));
  });
  expect("TLS 1.1", old, "refused");
}

let status = 0;
try {
  await run();
  status = failures === 0 ? 0 : 1;
} catch (error) {
  console.error(error);
  status = 1;
}
for (const child of children) child.kill("SIGTERM");
rmSync(folder, { recursive: true, force: true });
process.exit(status);
