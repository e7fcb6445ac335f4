// A phone in a real browser: pairs, places My pose, presses Replan, sees both paths, and STOP stops the wheels.
//
//   node phone_test.mjs --build BUILD_FOLDER [--simulate SCENARIO] [--chromium FILE] [--screenshots FOLDER]
//
// Without --simulate on the gateway with a fake team behind it, with it on everything that `tandem up` starts.
import { existsSync, mkdirSync } from "node:fs";
import { join } from "node:path";
import { parseArgs } from "node:util";
import * as phone from "./phone_page.mjs";
import { check, runAndExit, until } from "./processes.mjs";
import { fakeTeam, pairingLink, watchWheels, wholeSystem } from "./systems.mjs";

const { values: options } = parseArgs({
  options: {
    build: { type: "string" },
    chromium: { type: "string", default: "/usr/bin/chromium" },
    simulate: { type: "string" },
    screenshots: { type: "string" },
  },
});
const isFake = options.simulate === undefined;

/** STOP is promised to be with the robot within 0.3 s; then it brakes, from the speed it has by then. */
const kDelivery_s = 0.3;
const kDeceleration_mps2 = 0.6;
/** A control cycle of base and firmware, and what the truth's own rate of 20 Hz adds. */
const kCycles_s = 0.25;
const kStanding_mps = 0.005;

async function picture(page, name) {
  if (options.screenshots === undefined) return;
  mkdirSync(options.screenshots, { recursive: true });
  await page.screenshot({ path: join(options.screenshots, `${name}.png`) });
}

async function pairs(page, link) {
  await page.goto(link);
  await page.locator("button.primary").waitFor();
  check("the token is gone from the address bar", !page.url().includes("t="));
  await picture(page, "start");
  await page.locator("button.primary").tap();
  await until("the link is open", () => page.locator('.strip:not(.unlinked) [data-name="link"].good').count());
  await until("the map is drawn", async () => (await page.locator("canvas[data-view]").count()) > 0);
  await until("the robot is drawn", async () => (await phone.pixelsOf(page, phone.kRobotPath)) > 200);
  check("it pairs and shows the map", true);

  const box = await page.locator("button.stop").boundingBox();
  check("STOP is large", box.width >= 72 && box.height >= 72);
  const onTop = await page.evaluate(
    ([x, y]) => document.elementFromPoint(x, y).className,
    [box.x + box.width / 2, box.y + box.height / 2],
  );
  check("nothing covers STOP", onTop === "stop");
}

async function placesMyPose(page, heard) {
  const place = await phone.placeForAPerson(page, 2.0, 3.0);
  await phone.tapMap(page, place);
  const isThere = ({ x, y }) => Math.hypot(x - place.x, y - place.y) < 0.1;
  if (isFake) {
    const pose = await until("My pose arrives", () => heard().find((line) => line.human_message === 0));
    check("My pose arrives where it was placed", isThere(pose));
  } else {
    await until("the team believes the person to be there", async () => {
      const person = await phone.believed(page, "person");
      return person !== undefined && isThere(person);
    });
    check("the team believes the person where My pose was placed", true);
  }
}

async function replans(page, wheels) {
  await page.locator(".replan").tap();
  if (isFake) {
    await until("the page says that a plan is being computed", () => page.locator(".replan .spinner").count());
    await picture(page, "computing");
  }
  await until("both paths are drawn", async () => {
    const [person, robot] = [await phone.pixelsOf(page, phone.kPersonPath), await phone.pixelsOf(page, phone.kRobotPath)];
    return person > 1500 && robot > 1500;
  }, 60);
  check("it shows both paths", true);
  await until("the robot drives ahead", () => {
    const { left_mps: left, right_mps: right } = wheels.newest();
    return left > 0.15 && right > 0.15;
  }, 60);
  await until("the page says so", () => page.locator('[data-name="robot"].good').count());
  await picture(page, "searching");
}

async function placeGoal(page, tool) {
  const place = await phone.placeForAPerson(page, 3.0, 7.0);
  await page.locator(`[data-tool="${tool}"]`).tap();
  await phone.tapMap(page, place);
}

/** Who fixes whose goal makes the role (paper 6): a plan for each, and the chip says so. */
async function takesRoles(page) {
  const chip = page.locator('[data-name="role"]');
  const becomes = async (role) => {
    await page.locator(".replan").tap();
    await until(`the role is "${role}"`, async () => (await chip.innerText()) === role, 60);
    check(`role: ${role}`, true);
  };
  await until("without goals the robot leads", async () => (await chip.innerText()) === "Robot leads", 60);
  await placeGoal(page, "robot_goal");
  await becomes("Each leads");
  await placeGoal(page, "my_goal");
  await becomes("You lead");
  await placeGoal(page, "robot_goal");
  await page.locator(".toast button").filter({ hasText: "Undo" }).tap();
  await becomes("As peers");
}

/** The planner takes what is drawn on the map and what is said of the object, and gives back what it made of it. */
async function drawsAndSays(page) {
  const begin = async (edit) => {
    await page.locator('[data-tool="more"]').tap();
    await page.locator(`.sheet [data-edit="${edit}"]`).tap();
  };
  const settled = () => page.evaluate(() => JSON.parse(localStorage.getItem("tandem.outbox")).waiting.length === 0);
  for (const [edit, away_m] of [["likely_here", 4], ["pass_through", 2.5], ["avoid", 6]]) {
    const place = await phone.placeForAPerson(page, away_m, away_m + 4);
    await begin(edit);
    await phone.tapMap(page, place);
    await page.locator('[data-button="send"]').tap();
    await until(`the fate of ${edit} is known`, settled);
    const bad = await page.locator(".toast.bad").filter({ hasText: "Not done" }).allInnerTexts();
    check(`${edit} was not refused: ${bad.join()}`, bad.length === 0);
  }
  await begin("stay_behind");
  await until("the fate of stay_behind is known", settled);
  await page.locator('[data-tool="more"]').tap();
  await until("all that is drawn is listed", async () => (await page.locator(".drawn").count()) === 3);
  for (let left = 3; left > 0; left -= 1) {
    await page.locator(".drawn button").first().tap();
    await until("it is taken away", async () => (await page.locator(".drawn").count()) < left);
  }
  await page.locator(".sheet .close").tap();
  check("what is drawn is kept until it is taken away", true);
}

async function isTold(page, heard) {
  const gotIt = page.locator(".toast.inform button");
  await gotIt.waitFor();
  check("it shows what the robot tells", (await page.locator(".toast.inform").innerText()).includes("34 m²"));
  check("nobody has taken notice of it", heard().every((line) => line.got_it === undefined));
  await picture(page, "told");
  await gotIt.tap();
  await until("the planner knows that the person has got it", () => heard().some((line) => line.got_it));
  check("it is gone then", (await gotIt.count()) === 0);
}

/** When the page feels the next finger [Unix ms]: what the browser's driver takes to put it there is not the product's. */
async function nextTouch(page) {
  await page.evaluate(() => {
    globalThis.touched = undefined;
    addEventListener("pointerdown", () => (globalThis.touched = Date.now()), { capture: true, once: true });
  });
  return () => until("the page feels the finger", () => page.evaluate(() => globalThis.touched));
}

async function stops(page, wheels) {
  await until("the robot drives ahead", () => wheels.newest().left_mps > 0.15 && wheels.newest().right_mps > 0.15, 60);
  const touched = await nextTouch(page);
  await page.locator("button.stop").tap();
  const pressed = await touched();
  const stood = await until("the wheels stand", () => wheels.standingAfter(pressed, kStanding_mps), 5);
  const [took, fastest] = [(stood - pressed) / 1000, wheels.fastestSince(pressed)];
  const promised = kDelivery_s + fastest / kDeceleration_mps2 + kCycles_s;
  check(`STOP stops the wheels: from ${fastest.toFixed(2)} m/s in ${took.toFixed(2)} s, promised in ${promised.toFixed(2)} s`,
    took <= promised);
  await page.locator(".resume").waitFor();
  await until("the page says so", () => page.locator('[data-name="robot"].bad').count());
  await picture(page, "stopped");
  await until("three seconds are over", () => Date.now() > stood + 3000);
  check("and they stay so", wheels.fastestSince(stood) < kStanding_mps);
}

async function goesOn(page, wheels) {
  const bar = await page.locator(".resume").boundingBox();
  await page.mouse.move(bar.x + bar.width / 2, bar.y + bar.height / 2);
  await page.mouse.down();
  await until("the bar was held long enough", async () => (await page.locator(".resume").count()) === 0, 10);
  await page.mouse.up();
  await until("the wheels turn again", () => wheels.speed() > 0.05, 60);
  check("holding the bar lets it go on", true);
}

async function run() {
  const system = isFake ? await fakeTeam(options.build) : await wholeSystem(options.build, options.simulate);
  const wheels = watchWheels(options.build, system.domain);
  const link = await pairingLink(system);
  const browser = await phone.launch(options.chromium);
  try {
    const { page, complaints } = await phone.openPhone(browser);
    await pairs(page, link);
    await placesMyPose(page, system.heard);
    await replans(page, wheels);
    if (isFake) await isTold(page, system.heard);
    await takesRoles(page);
    await drawsAndSays(page);
    await stops(page, wheels);
    await goesOn(page, wheels);
    check(`the page complains about nothing: ${complaints.join("; ")}`, complaints.length === 0);
  } catch (error) {
    for (const page of browser.contexts().flatMap((context) => context.pages())) await picture(page, "failed");
    throw error;
  } finally {
    await browser.close();
  }
}

if (!existsSync(options.chromium)) {
  console.log("skipped: there is no chromium here");
  process.exit(77);
}
await runAndExit(run);
