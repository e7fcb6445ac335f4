// Reminders of My pose on a phone in a real browser, in real time: when they fire, what they look like, what ends them,
// and that every firing and obeying reaches the bus, over a lost Wi-Fi and a reload too.
//
//   node reminders_test.mjs --build BUILD_FOLDER [--chromium FILE]
import { existsSync } from "node:fs";
import { parseArgs } from "node:util";
import * as phone from "./phone_page.mjs";
import { check, runAndExit, until } from "./processes.mjs";
import { Proxy } from "./proxy.mjs";
import { fakeTeam, freePort } from "./systems.mjs";

const { values: options } = parseArgs({
  options: { build: { type: "string" }, chromium: { type: "string", default: "/usr/bin/chromium" } },
});

const kThreshold_s = 2.0;
const kFloor_s = 1.0;
/** A timer is never early, and late by what a busy machine makes of it; the gateway stamps at its beat of 50 ms. */
const kLate_s = 0.35;
const kBeat_s = 0.06;

const isDue = (seconds, wanted) => seconds > wanted - kBeat_s && seconds < wanted + kLate_s;
const records = (team) => team.heard().filter((line) => line.reminder !== undefined);
const fired = (team) => records(team).filter((line) => line.fired);
const obeyed = (team) => records(team).filter((line) => line.obeyed);
const kHere = { x: 5, y: 12 };

async function pose(page, team) {
  const before = team.heard().filter((line) => line.human_message === 0).length;
  await phone.tapMap(page, kHere);
  await until("My pose arrives", () => team.heard().filter((line) => line.human_message === 0).length > before);
}

/** Another session: it reminds of nothing before the first pose. */
async function begin(page, team, kind) {
  for (const phase of ["preparing", "running"]) {
    team.tell(`session ${phase} human_robot ${kind}`);
    await page.locator(`[data-session="${phase} human_robot ${kind}"]`).waitFor();
  }
}

async function toast(page, team) {
  await begin(page, team, "toast");
  const before = fired(team).length;
  await page.waitForTimeout(1000 * (kThreshold_s + 0.5)); // nothing may happen: only time can tell
  check("nobody is reminded before the first pose", fired(team).length === before);
  await pose(page, team);
  await page.locator(".toast.remind").waitFor();
  const strip = await page.locator(".toast.remind").boundingBox();
  for (const control of await page.locator("button:visible").all()) {
    const box = await control.boundingBox();
    const apart = box.y + box.height <= strip.y || box.y >= strip.y + strip.height;
    if (!apart) throw new Error("the toast covers a control");
  }
  check("the toast covers no control", true);
  await until("it comes again three times", () => fired(team).length === before + 4);
  const mine = fired(team).slice(before);
  check("each comes sooner, down to the floor: " + mine.map((one) => one.threshold_s).join(" "),
    mine.map((one) => one.threshold_s).join(" ") === "2 1.5 1.125 1");
  const gaps = mine.slice(1).map((one, i) => one.stamp_s - mine[i].stamp_s);
  check(`and when it is due: ${gaps.map((one) => one.toFixed(2)).join(" ")} s`,
    [1.5, 1.125, 1].every((wanted, i) => isDue(gaps[i], wanted)));
  await pose(page, team);
  await until("that it was obeyed is recorded", () => obeyed(team).length > 0);
  check("once, for the first that was not", obeyed(team).length === 1 && obeyed(team)[0].threshold_s === 2);
  const again = await until("the next comes", () => fired(team)[before + 4]);
  check("after the whole threshold", again.threshold_s === 2 && isDue(again.stamp_s - obeyed(team)[0].stamp_s, 2));
}

async function multimodal(page, team) {
  await page.evaluate(() => {
    window.vibrations = [];
    navigator.vibrate = (pattern) => window.vibrations.push(pattern) > 0;
  });
  await begin(page, team, "multimodal");
  await pose(page, team);
  await page.locator('[data-tool="my_pose"].blinks').waitFor();
  check("the phone shakes once", JSON.stringify(await page.evaluate(() => window.vibrations)) === "[[300,150,300]]");
  const seconds = await page.locator(".blinks").evaluate((one) => parseFloat(getComputedStyle(one).animationDuration));
  check("My pose blinks, less than three times a second", seconds >= 0.34);
  await pose(page, team);
  await until("it blinks no more", async () => (await page.locator(".blinks").count()) === 0);
  await page.evaluate(() => (navigator.vibrate = () => false));
  await page.locator(".edge").waitFor();
  check("a phone that cannot shake flashes its edge", true);
  await pose(page, team);
}

async function popUp(page, team) {
  await begin(page, team, "popup");
  await pose(page, team);
  await page.locator(".veil").waitFor();
  const before = team.heard().length;
  for (const control of await page.locator(".panel button, .map-buttons button").all()) {
    await control.tap({ force: true, timeout: 300 }).catch(() => undefined);
  }
  await page.touchscreen.tap(200, 300);
  await page.goBack({ timeout: 500 }).catch(() => undefined);
  await page.keyboard.press("Escape");
  await page.setViewportSize({ width: 915, height: 412 });
  await page.setViewportSize({ width: 412, height: 915 });
  check("nothing takes the pop-up away", (await page.locator(".veil").count()) === 1);
  const asked = team.heard().slice(before).filter((line) => line.reminder === undefined);
  check("and nothing else works", asked.length === 0);
  await page.reload();
  await page.locator("button.primary").tap();
  await page.locator(".veil").waitFor();
  check("nor does a reload", true);
  await page.locator("button.stop").tap();
  await until("STOP works", () => team.heard().some((line) => line.stop_request));
  await until("a robot that is stopped reminds of nothing", async () => (await page.locator(".veil").count()) === 0);
  const bar = await page.locator(".resume").boundingBox();
  await page.mouse.move(bar.x + bar.width / 2, bar.y + bar.height / 2);
  await page.mouse.down();
  await until("it may go on", () => team.heard().some((line) => line.resume_request));
  await page.mouse.up();
  await page.locator(".veil .primary").tap();
  await pose(page, team);
  await until("the pop-up is gone", async () => (await page.locator(".veil, .popup-tools").count()) === 0);
  check("only My pose takes it away", true);
}

async function counters(page, team) {
  check("nothing is counted otherwise", (await page.locator(".badge").count()) === 0);
  await begin(page, team, "counters");
  await pose(page, team);
  await pose(page, team);
  await page.locator('[data-tool="my_goal"]').tap();
  await phone.tapMap(page, { x: 8, y: 12 });
  const counts = async () => (await page.locator(".badge").allInnerTexts()).join(" ");
  await until("each is counted", async () => (await counts()) === "2 1 0");
  await page.locator('[data-tool="my_goal"]').tap();
  await page.touchscreen.tap(...Object.values(await offTheMap(page)));
  await page.locator(".toast.bad").waitFor();
  check("what is refused is not", (await counts()) === "2 1 0");
  await page.reload();
  await page.locator("button.primary").tap();
  await until("a reload forgets nothing", async () => (await counts()) === "2 1 0");
}

/** A place on the canvas where there is no map. */
async function offTheMap(page) {
  for (let i = 0; i < 6; i += 1) await page.mouse.wheel(0, 120);
  await page.locator("canvas.map-canvas").hover();
  await page.mouse.wheel(0, 600);
  const box = await page.locator("canvas.map-canvas").boundingBox();
  return { x: box.x + 12, y: box.y + 12 };
}

async function lostWifi(page, team, proxy) {
  await begin(page, team, "toast");
  await pose(page, team);
  const before = fired(team).length;
  proxy.mode = "blackhole";
  await page.locator(".toast.remind").waitFor();
  check("it reminds without a link", fired(team).length === before);
  await until("the page knows that there is no link", () => page.locator(".strip.unlinked").count());
  await page.waitForTimeout(500);
  proxy.mode = "up";
  await until("the records come with the link", () => fired(team).length >= before + 2, 30);
  const [first, second] = fired(team).slice(before);
  check("with the times at which it was", isDue(second.stamp_s - first.stamp_s, 1.5));
  await until("it is linked again", async () => (await page.locator(".strip.unlinked").count()) === 0);
  await pose(page, team);
}

async function ends(page, team) {
  team.tell("session ended human_robot toast");
  await page.locator(".toast.good").waitFor();
  const before = fired(team).length;
  await page.waitForTimeout(1000 * (kThreshold_s + 0.5));
  check("nobody is reminded after the end", fired(team).length === before);
}

async function lostTrack(page, team) {
  const ink = () => phone.pixelsOf(page, [0x11, 0x77, 0x33]);
  const red = () => phone.pixelsOf(page, [0xc1, 0x12, 0x1f]);
  await until("the person is green", async () => (await ink()) > 100);
  const lost = performance.now();
  team.tell("lose");
  await until("they are red", async () => (await red()) > 60);
  check(`within half a second of the bus, and what that takes: ${((performance.now() - lost) / 1000).toFixed(2)} s`,
    performance.now() - lost < 1000);
  await page.locator(".toast.bad").filter({ hasText: "lost you" }).waitFor();
  check("in words, too", true);
  team.tell("track");
  await until("green again", async () => (await ink()) > 100 && (await red()) < 60);
}

async function run() {
  const port = await freePort();
  const proxy = new Proxy(port);
  await proxy.listen();
  const team = await fakeTeam(options.build, {
    port,
    settings: [`reminder_threshold_s = ${kThreshold_s.toFixed(1)}`, `reminder_floor_s = ${kFloor_s.toFixed(1)}`],
  });
  const browser = await phone.launch(options.chromium);
  try {
    const { page } = await phone.openPhone(browser);
    await phone.join(page, await team.link("participant"));
    await toast(page, team);
    await begin(page, team, "none");
    await lostTrack(page, team);
    await multimodal(page, team);
    await popUp(page, team);
    await counters(page, team);
    await page.locator('[data-button="recentre"]').tap();
    await lostWifi(page, team, proxy);
    await ends(page, team);
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
