// The link between phone and gateway when it is bad: a TCP proxy swallows, cuts and refuses, the page is reloaded, the
// gateway is killed. Every press arrives once and in order; what is old is not taken for new.
//
//   node link_test.mjs --build BUILD_FOLDER [--chromium FILE]
import { createHash } from "node:crypto";
import { existsSync } from "node:fs";
import { parseArgs } from "node:util";
import tls from "node:tls";
import * as phone from "./phone_page.mjs";
import { check, runAndExit, until } from "./processes.mjs";
import { Proxy } from "./proxy.mjs";
import { fakeTeam, freePort } from "./systems.mjs";

const { values: options } = parseArgs({
  options: { build: { type: "string" }, chromium: { type: "string", default: "/usr/bin/chromium" } },
});

/** The hash of the gateway's public key, as Chromium wants it. */
function publicKeyHash(port) {
  return new Promise((resolve, reject) => {
    const socket = tls.connect({ host: "127.0.0.1", port, rejectUnauthorized: false }, () => {
      const key = socket.getPeerX509Certificate().publicKey.export({ type: "spki", format: "der" });
      socket.end();
      resolve(createHash("sha256").update(key).digest("base64"));
    });
    socket.on("error", reject);
  });
}

const goals = (team) => team.heard().filter((line) => line.human_message === 1);
let sent = 0;

/** Places the next of a row of goals, each a step further to the right. */
async function placeGoal(page) {
  sent += 1;
  await page.locator('[data-tool="my_goal"]').tap();
  await phone.tapMap(page, { x: 2 + 0.5 * sent, y: 12 });
}

const isLinked = async (page) => (await page.locator(".strip:not(.unlinked)").count()) > 0;
const linked = (page) => until("the link is back", () => isLinked(page), 30);

/** Everything sent so far has arrived once, in order. */
async function allArrived(team, what) {
  await until(`all arrive: ${what}`, () => goals(team).length >= sent, 30);
  const xs = goals(team).map((line) => line.x);
  const wanted = Array.from({ length: sent }, (_, i) => 2 + 0.5 * (i + 1));
  check(`${what}: ${sent} goals sent, each arrived once and in order`,
    xs.length === sent && xs.every((x, i) => Math.abs(x - wanted[i]) < 0.1));
  check("no two under one name", new Set(goals(team).map((line) => line.id)).size === sent);
}

async function blackhole(page, team, proxy) {
  proxy.mode = "blackhole";
  const from = performance.now();
  await placeGoal(page);
  await until("the page knows that nobody hears it", async () => !(await isLinked(page)));
  check(`a black hole is noticed in ${((performance.now() - from) / 1000).toFixed(1)} s, within 6`,
    performance.now() - from < 6000);
  await placeGoal(page);
  check("and says that what is pressed waits", (await page.locator(".toast").innerText()).includes("waiting"));
  proxy.mode = "up";
  const back = performance.now();
  await linked(page);
  check(`it is back in ${((performance.now() - back) / 1000).toFixed(1)} s, within 5`, performance.now() - back < 5000);
  await allArrived(team, "a black hole");
}

async function resets(page, team, proxy) {
  for (let i = 0; i < 3; i += 1) {
    await placeGoal(page);
    proxy.reset();
    await placeGoal(page);
  }
  await linked(page);
  await allArrived(team, "three resets");
}

async function reload(page, team, proxy) {
  proxy.mode = "refuse";
  proxy.reset();
  await until("the link is gone", async () => !(await isLinked(page)));
  await placeGoal(page);
  await page.reload();
  await page.locator("button.primary").waitFor();
  check("the page opens without a link", true);
  proxy.mode = "up";
  await page.locator("button.primary").tap();
  await page.locator("canvas[data-view]").waitFor({ timeout: 30_000 });
  await linked(page);
  await allArrived(team, "a reload without a link");
}

async function killedTab(page, team) {
  await placeGoal(page);
  const context = page.context();
  await page.close();
  const next = await context.newPage();
  await next.goto(kOrigin.href);
  await next.locator("button.primary").tap();
  await next.locator("canvas[data-view]").waitFor();
  await linked(next);
  await placeGoal(next);
  await allArrived(team, "a closed page");
  return next;
}
let kOrigin;

async function restartedGateway(page, team) {
  await placeGoal(page);
  await team.restart();
  await placeGoal(page);
  await linked(page);
  await until("the map is there", async () => (await page.locator("canvas[data-robot]").count()) > 0);
  await placeGoal(page);
  await allArrived(team, "a gateway that is killed and started anew");
}

async function oldOnes(page, team, proxy) {
  proxy.mode = "refuse";
  proxy.reset();
  await until("the link is gone", async () => !(await isLinked(page)));
  await page.locator('[data-tool="my_pose"]').tap();
  await phone.tapMap(page, { x: 5, y: 12 });
  await page.locator('[data-tool="robot_goal"]').tap();
  await phone.tapMap(page, { x: 6, y: 12 });
  const stale = page.locator(".map-note.stale");
  await stale.waitFor();
  check(`old data says its age: ${await stale.innerText()}`, /\d+ s/.test(await stale.innerText()));
  await page.waitForTimeout(15_500); // a goal is old after fifteen seconds: only time makes it so
  proxy.mode = "up";
  await linked(page);
  const asks = page.locator(".toast").filter({ hasText: "Still want it?" });
  await asks.waitFor();
  check("an old goal asks again", (await asks.innerText()).includes("Robot goal"));
  const told = (kind) => team.heard().filter((line) => line.human_message === kind).length;
  check("neither it nor an old pose was taken", told(2) === 0 && told(0) === 0);
  await asks.locator("button").first().tap();
  await until("yes sends it anew", () => told(2) === 1);
  await until("the age is gone", async () => (await stale.count()) === 0);
}

async function offlineShell(page, proxy) {
  await page.evaluate(() => navigator.serviceWorker.ready.then(() => true));
  await page.reload();
  await page.locator("button.primary").waitFor();
  proxy.mode = "refuse";
  proxy.reset();
  await page.reload();
  await page.locator("button.primary").waitFor();
  check("without any link the page still opens", true);
  proxy.mode = "up";
  await page.locator("button.primary").tap();
}

/** A gateway that is started anew invites a phone, and knows the one before: the later one takes its place. */
async function anotherPhone(browser, page, team) {
  const before = await team.link("participant");
  await team.restart();
  await linked(page);
  const fresh = await until("there is a fresh link", async () => {
    const link = await team.link("participant");
    return link !== before && link;
  });
  const { page: other } = await phone.openPhone(browser, { ignoreHTTPSErrors: false });
  await phone.join(other, fresh);
  await page.locator(".welcome").filter({ hasText: "Another phone has taken over" }).waitFor();
  check("a later link takes the place over, and the first phone says so", true);
}

async function run() {
  const port = await freePort();
  const proxy = new Proxy(port);
  await proxy.listen();
  const team = await fakeTeam(options.build, { port });
  const link = await team.link("participant");
  kOrigin = new URL("/", link);
  const browser = await phone.launch(options.chromium, await publicKeyHash(port));
  try {
    const { page } = await phone.openPhone(browser, { ignoreHTTPSErrors: false });
    await phone.join(page, link);
    await page.evaluate(() => navigator.serviceWorker.ready.then(() => true));
    await blackhole(page, team, proxy);
    await resets(page, team, proxy);
    await reload(page, team, proxy);
    const next = await killedTab(page, team);
    await restartedGateway(next, team);
    await oldOnes(next, team, proxy);
    await offlineShell(next, proxy);
    await anotherPhone(browser, next, team);
  } finally {
    await browser.close();
    proxy.close();
  }
}

if (!existsSync(options.chromium)) {
  console.log("skipped: there is no chromium here");
  process.exit(77);
}
await runAndExit(run);
