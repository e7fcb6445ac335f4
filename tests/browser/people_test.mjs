// Two people with two phones and no robot: each sees where the other one said they are and go; the second is the control
// user, whose phone reminds of nothing. And an observer's phone, which may only look.
//
//   node people_test.mjs --build BUILD_FOLDER [--chromium FILE]
import { existsSync } from "node:fs";
import { parseArgs } from "node:util";
import * as phone from "./phone_page.mjs";
import { check, runAndExit, until } from "./processes.mjs";
import { fakeTeam } from "./systems.mjs";

const { values: options } = parseArgs({
  options: { build: { type: "string" }, chromium: { type: "string", default: "/usr/bin/chromium" } },
});

const partnerOf = async (page) => (await page.locator("canvas.map-canvas").getAttribute("data-partner")) ?? "";
const isAt = (told, { x, y }) => {
  const [px, py] = told.split(" ").map(Number);
  return Math.hypot(px - x, py - y) < 0.1;
};

async function seeEachOther(anna, berta, team) {
  const annas = { x: 4, y: 12 };
  const bertas = { x: 8, y: 13 };
  await phone.tapMap(anna, annas);
  const from = performance.now();
  await until("Berta sees Anna", async () => isAt(await partnerOf(berta), annas));
  check(`in ${Math.round(performance.now() - from)} ms, promised in 300 and what a loaded machine adds`,
    performance.now() - from < 1000);
  await phone.tapMap(berta, bertas);
  await until("Anna sees Berta", async () => isAt(await partnerOf(anna), bertas));
  const ink = () => phone.pixelsOf(anna, [0xcc, 0x79, 0xa7]);
  const before = await ink();
  await berta.locator('[data-tool="my_goal"]').tap();
  await phone.tapMap(berta, { x: 20, y: 13 });
  await until("Anna sees where Berta goes", async () => (await ink()) > before + 30);
  const poses = team.heard().filter((line) => line.human_message === 0);
  check("the recording gets both, each under their own name",
    poses.map((line) => line.agent).sort().join(" ") === "person1 person2");
}

async function simplified(page) {
  const gone = '[data-tool="replan"], [data-tool="robot_goal"], [data-tool="more"], button.stop, [data-name="robot"]';
  check("there is nothing for a robot", (await page.locator(gone).count()) === 0);
  check("no path is drawn", (await phone.pixelsOf(page, phone.kRobotPath)) < 50);
}

async function ownReminders(anna, berta) {
  await anna.locator(".badge").first().waitFor();
  check("each counts their own", (await anna.locator(".badge").allInnerTexts()).join(" ") === "1 0");
  check("the control user is reminded of nothing", (await berta.locator(".badge").count()) === 0);
}

async function observes(browser, team) {
  const { page } = await phone.openPhone(browser);
  await phone.join(page, await team.link("observer"));
  check("an observer has no tools", (await page.locator("[data-tool]").count()) === 0);
  const before = team.heard().length;
  await phone.tapMap(page, { x: 6, y: 12 });
  team.tell("session preparing human_robot none"); // answered by every page: what was tapped came before it
  await page.locator("button.stop").waitFor();
  check("and sends nothing", team.heard().length === before);
  await page.locator("button.stop").tap();
  await until("but stops the robot", () => team.heard().some((line) => line.stop_request));
}

async function run() {
  const team = await fakeTeam(options.build, {
    settings: [`mode = ""`, `partner = "person2"`, "reminder_threshold_s = 600.0"],
  });
  const browser = await phone.launch(options.chromium);
  try {
    team.tell("session running human_human counters");
    const { page: anna } = await phone.openPhone(browser);
    const { page: berta } = await phone.openPhone(browser);
    await phone.join(anna, await team.link("participant"));
    await phone.join(berta, await team.link("partner"));
    await anna.locator('.strip-row[hidden]').waitFor({ state: "attached" });
    await berta.locator('.strip-row[hidden]').waitFor({ state: "attached" });
    await simplified(anna);
    await seeEachOther(anna, berta, team);
    await ownReminders(anna, berta);
    await observes(browser, team);
  } finally {
    await browser.close();
  }
}

if (!existsSync(options.chromium)) {
  console.log("skipped: there is no chromium here");
  process.exit(77);
}
await runAndExit(run);
