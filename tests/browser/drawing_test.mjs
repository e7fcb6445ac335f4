// What a person draws and says on the map, and how the map is looked at: areas to keep out of, places to go, where the
// object is likely; layers, heading-up, keyboard, undo; the other hand.
//
//   node drawing_test.mjs --build BUILD_FOLDER [--chromium FILE]
import { existsSync } from "node:fs";
import { parseArgs } from "node:util";
import * as phone from "./phone_page.mjs";
import { check, runAndExit, until } from "./processes.mjs";
import { fakeTeam } from "./systems.mjs";

const { values: options } = parseArgs({
  options: { build: { type: "string" }, chromium: { type: "string", default: "/usr/bin/chromium" } },
});

const edits = (team, kind) => team.heard().filter((line) => line[kind] !== undefined);

/** A finger goes around the places on the map. */
async function drawAround(page, places) {
  const spots = [];
  for (const place of [...places, places[0]]) spots.push(await phone.onPage(page, place));
  await page.mouse.move(spots[0].x, spots[0].y);
  await page.mouse.down();
  for (const spot of spots.slice(1)) await page.mouse.move(spot.x, spot.y, { steps: 8 });
  await page.mouse.up();
}

async function begin(page, edit) {
  await page.locator('[data-tool="more"]').tap();
  await page.locator(`.sheet [data-edit="${edit}"]`).tap();
}

async function draws(page, team) {
  await begin(page, "avoid");
  const send = page.locator('[data-button="send"]');
  await send.tap({ force: true });
  check("nothing is sent before there is a place", edits(team, "source_edit").length === 0);
  await drawAround(page, [{ x: 10, y: 11 }, { x: 14, y: 11 }, { x: 14, y: 14 }, { x: 10, y: 14 }]);
  await page.locator('[data-word="very"]').tap();
  await page.locator('[data-word="robot"]').tap();
  await send.tap();
  const avoid = await until("the area arrives", () => edits(team, "source_edit")[0]);
  check(`to keep out of, ${avoid.corners} corners, very, for the robot`,
    avoid.source_edit === 1 && avoid.corners > 8 && avoid.strength === "very" && avoid.targets === 1);
  await until("the map shows it", async () => (await phone.pixelsOf(page, [0xc1, 0x12, 0x1f])) > 200);

  for (const [edit, kind] of [["pass_through", 2], ["go_to", 3]]) {
    await begin(page, edit);
    check("nobody sends both to one place", (await page.locator('[data-word="everybody"]').count()) === 0);
    await phone.tapMap(page, { x: 6, y: 12 });
    await send.tap();
    const one = await until(`${edit} arrives`, () => edits(team, "source_edit").find((line) => line.source_edit === kind));
    check("a tap is a place", one.corners === 1 && one.strength === "quite");
  }
  await begin(page, "stay_behind");
  await until("stay behind me arrives", () => edits(team, "source_edit").find((line) => line.source_edit === 4));

  await page.locator('[data-tool="more"]').tap();
  check("all four are listed", (await page.locator(".drawn").count()) === 4);
  await page.locator(".drawn button").first().tap();
  await until("one is taken away", () => edits(team, "source_edit").some((line) => line.source_edit === 0));
  await until("and is not listed any more", async () => (await page.locator(".drawn").count()) === 3);
  await page.keyboard.press("Escape");
  check("Escape closes the sheet", (await page.locator(".sheet").count()) === 0);
}

async function says(page, team) {
  const kinds = [["likely_here", "a_bit"], ["not_here", "quite"], ["searched", "roughly"], ["look_again", "very"]];
  for (const [kind, [edit, strength]] of kinds.entries()) {
    await begin(page, edit);
    await phone.tapMap(page, { x: 16, y: 12 });
    await page.locator(`[data-word="${strength}"]`).tap();
    await page.locator('[data-button="send"]').tap();
    const one = await until(`${edit} arrives`, () => edits(team, "belief_edit").find((line) => line.belief_edit === kind));
    check(`${edit}, ${one.strength}`, one.strength === strength.replace("_", " "));
  }
}

async function layers(page, team) {
  const button = page.locator('[data-button="layer"]');
  const answers = () => team.heard().filter((line) => line.question !== undefined).map((line) => `${line.question} ${line.answer}`);
  await until("the layer shown at first is recorded", () => answers().join() === "layer belief shown");
  await button.tap();
  await until("the other one, too", () => answers().slice(-2).join() === "layer belief hidden,layer explored shown");
  check("its button says so", (await button.getAttribute("data-layer")) === "explored");
  await button.tap();
  await until("and that there is none", () => answers().at(-1) === "layer explored hidden");
  await button.tap();
}

async function turns(page, team) {
  const turn = async () => Number((await page.locator("canvas.map-canvas").getAttribute("data-view")).split(" ")[3]);
  const button = page.locator('[data-button="turn"]');
  while (Math.abs(await turn()) > 0.01) {
    await button.tap();
    await until("the map is upright", async () => Math.abs(await turn()) < 0.01);
  }
  await phone.tapMap(page, { x: 6, y: 13 });
  await until("the person is known", () => phone.believed(page, "person"));
  await button.tap();
  await until("the map turns so that the person looks up", async () => Math.abs((await turn()) - Math.PI / 2) < 0.02);
  const person = await phone.onPage(page, await phone.believed(page, "person"));
  const box = await page.locator("canvas.map-canvas").boundingBox();
  check("and they are in its middle", Math.hypot(person.x - box.x - box.width / 2, person.y - box.y - box.height / 2) < 3);
  for (let i = 0; i < 3; i += 1) await page.mouse.wheel(0, -100);
  const place = { x: 7, y: 13.5 };
  const poses = () => team.heard().filter((line) => line.human_message === 0);
  const before = poses().length;
  await phone.tapMap(page, place);
  await until("a pose arrives", () => poses().length > before);
  const { x, y } = poses().at(-1);
  check(`turned and zoomed, a tap means the same place: ${x.toFixed(2)} ${y.toFixed(2)}`,
    Math.hypot(x - place.x, y - place.y) < 0.1);
  while (Math.abs(await turn()) > 0.01) await button.tap();
  await until("upright again", async () => Math.abs(await turn()) < 0.01);
  await page.locator('[data-button="recentre"]').tap();
}

async function keyboard(page, team) {
  const before = team.heard().filter((line) => line.human_message === 0).length;
  await page.locator("canvas.map-canvas").focus();
  await page.keyboard.press("+");
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Enter");
  await until("Enter taps the middle of the map", () => team.heard().filter((line) => line.human_message === 0).length > before);
  await page.locator('[data-button="recentre"]').tap();
}

async function undoes(page, team) {
  await page.locator('[data-tool="my_goal"]').tap();
  await phone.tapMap(page, { x: 8, y: 12 });
  check("after a goal the tool is My pose again",
    (await page.locator('[data-tool="my_pose"]').getAttribute("aria-pressed")) === "true");
  await page.locator(".toast button").tap();
  await until("undo takes the goal back", () => team.heard().some((line) => line.human_message === 4));
}

async function otherHand(page) {
  const left = async (tool) => (await page.locator(`[data-tool="${tool}"]`).boundingBox()).x;
  check("My pose is where the right thumb is", (await left("my_pose")) > (await left("more")));
  await page.locator('[data-button="settings"]').tap();
  await page.locator('.sheet [data-word="left"]').tap();
  await page.locator(".sheet .close").tap();
  check("or where the left one is", (await left("my_pose")) < (await left("more")));
  await page.reload();
  await page.locator("button.primary").tap();
  await page.locator('[data-tool="more"]').waitFor();
  check("and a reload does not forget it", (await left("my_pose")) < (await left("more")));
}

async function run() {
  const team = await fakeTeam(options.build);
  const browser = await phone.launch(options.chromium);
  try {
    const { page, complaints } = await phone.openPhone(browser);
    await phone.join(page, await team.link("participant"));
    await layers(page, team);
    await draws(page, team);
    await says(page, team);
    await turns(page, team);
    await keyboard(page, team);
    await undoes(page, team);
    await otherHand(page);
    check(`the page complains about nothing: ${complaints.join("; ")}`, complaints.length === 0);
  } finally {
    await browser.close();
  }
}

if (!existsSync(options.chromium)) {
  console.log("skipped: there is no chromium here");
  process.exit(77);
}
await runAndExit(run);
