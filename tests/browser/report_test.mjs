// The page of `tandem report` in a real browser, opened from the disk, offline: a scripted search gives the numbers its
// script says, the episode can be played and dragged, and the page of 21 episodes is small.
//
//   node report_test.mjs --build BUILD_FOLDER [--chromium FILE] [--screenshots FOLDER]
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, statSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { parseArgs } from "node:util";
import * as phone from "./phone_page.mjs";
import { check, folder, runAndExit, until } from "./processes.mjs";

const { values: options } = parseArgs({
  options: {
    build: { type: "string" },
    chromium: { type: "string", default: "/usr/bin/chromium" },
    screenshots: { type: "string" },
  },
});
const config = join(dirname(fileURLToPath(import.meta.url)), "../../config");
const tandem = (...words) => execFileSync(join(options.build, "bin/tandem"), words, { encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });

async function open(browser, file) {
  const { page, complaints } = await phone.openPhone(browser, { viewport: { width: 1000, height: 900 }, offline: true, isMobile: false, hasTouch: false, deviceScaleFactor: 1 });
  const asked = [];
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) asked.push(request.url());
  });
  await page.goto(pathToFileURL(file).href);
  await page.locator('#page[data-ready="true"]').waitFor();
  check("nothing is asked from the network", asked.length === 0);
  return { page, complaints };
}

async function picture(page, name) {
  if (options.screenshots === undefined) return;
  mkdirSync(options.screenshots, { recursive: true });
  await page.screenshot({ path: join(options.screenshots, `${name}.png`), fullPage: true });
}

const cellsOf = (page, table, row) => page.locator(`[data-name="${table}"] tbody tr`).nth(row).locator("td").allInnerTexts();

async function rowOf(page, table, head) {
  const rows = await page.locator(`[data-name="${table}"] tbody tr`).all();
  for (const row of rows) if ((await row.locator("th").innerText()).startsWith(head)) return row.locator("td").allInnerTexts();
  return [];
}

/** How many pixels of the stage differ from those of `before`. */
const stageOf = (page) => page.locator("canvas.stage").evaluate((canvas) => canvas.toDataURL());

async function scripted(browser) {
  const recording = join(folder, "scripted.mcap");
  execFileSync(join(options.build, "tests/scripted_search"), [recording]);
  const file = join(folder, "scripted.html");
  tandem("report", recording, "-o", file);
  const { page, complaints } = await open(browser, file);

  check("one episode, found, 120 s", (await page.locator('[data-name="summary"]').innerText()).startsWith("1 episode, found in 1; 120.0 s"));
  const rates = await cellsOf(page, "my_pose", 0);
  check(`messages a minute: ${rates.join(", ")}`, rates.join() === "7.00 (0.00),4.67 (0.00),4.00 (0.00),4.00 (0.00)");
  const within = await cellsOf(page, "my_pose", 1);
  check(`within 10 s: ${within.join(", ")}`, within.join() === "85.71 %,85.71 %,75.00 %,75.00 %");
  for (const [head, value] of [["Explored at the end", "80.0 %"], ["by the robot", "50.0 %"], ["Plans", "3.00"], ["Plans rejected", "1.00"], ["Stops", "2.00"], ["Mean distance to the teammate", "1.00"]]) {
    const [cell] = await rowOf(page, "measures", head);
    check(`${head}: ${cell}`, cell?.startsWith(value));
  }
  const roles = await page.locator(".strip rect title").allTextContents();
  check("the roles in their order", roles.slice(0, 3).join() === "Robot leads, person follows,Peers,Person commands, robot obeys");
  const widths = await page.locator(".strip rect").evaluateAll((all) => all.slice(0, 3).map((rect) => Number(rect.getAttribute("width"))));
  check(`for 50, 30 and 40 of 120 s: ${widths.join(", ")}`, widths.every((width, i) => Math.abs(width - (1000 * [50, 30, 40][i]) / 120) < 1));

  const moment = page.locator(".moment");
  const atBegin = await stageOf(page);
  await page.locator(".controls input").fill("62");
  check(`dragged to 62 s it says so: ${await moment.innerText()}`, /^62\.0 s · explored 40 % · plan proposed: Peers · stopped: /.test(await moment.innerText()));
  check("and shows something else", (await stageOf(page)) !== atBegin);
  await picture(page, "scripted");
  await page.locator(".play").click();
  await until("it plays", async () => Number(await page.locator(".controls input").inputValue()) > 64);
  await page.locator(".play").click();
  await page.locator(".controls input").fill("118");
  await page.locator(".play").click();
  await until("it ends by itself", async () => (await page.locator(".play").innerText()) === "Play");
  check("it says who found it", (await moment.innerText()).endsWith("found by human1"));
  check(`the page complains about nothing: ${complaints.join("; ")}`, complaints.length === 0);
}

async function study(browser) {
  const results = join(folder, "study");
  tandem("study", "--config", config, "--scenario", "brl", "--rollouts", "20", "--episodes", "21", "--record", "--output", results);
  const file = join(folder, "study.html");
  tandem("report", join(results, "recordings"), "-o", file);
  const size = statSync(file).size;
  check(`21 episodes are ${(size / 1e6).toFixed(2)} MB`, size <= 1e6);
  const { page, complaints } = await open(browser, file);
  const told = JSON.parse(readFileSync(join(results, "study.json"), "utf8"));
  const found = told.episodes.filter((episode) => episode.found).length;
  const mean = told.episodes.reduce((sum, episode) => sum + episode.time_s, 0) / told.episodes.length;
  check("the study's own numbers", (await page.locator('[data-name="summary"]').innerText()).startsWith(`21 episodes, found in ${found}; ${mean.toFixed(1)} s`));
  check("all are listed", (await page.locator('[data-name="episodes"] tbody tr').count()) === 21);
  await page.locator('[data-name="episodes"] button.link').nth(7).click();
  const name = await page.locator('[data-name="episodes"] button.link').nth(7).innerText();
  check("the one that was pressed is shown", (await page.locator('[data-name="episode"] h3').innerText()) === name);
  await picture(page, "study");
  check(`the page complains about nothing: ${complaints.join("; ")}`, complaints.length === 0);
}

async function run() {
  const browser = await phone.launch(options.chromium);
  try {
    await scripted(browser);
    await study(browser);
  } finally {
    await browser.close();
  }
}

if (!existsSync(options.chromium)) {
  console.log("skipped: there is no chromium here");
  process.exit(77);
}
await runAndExit(run);
