// A phone in a real browser: pairs, places My pose, presses Replan, sees both paths, and STOP stops the wheels.
//
//   node phone_test.mjs --build BUILD_FOLDER [--chromium FILE] [--screenshots FOLDER]
//       starts tandem-gateway and a fake team of its own.
//   node phone_test.mjs --build BUILD_FOLDER --link-file FILE --domain N [...]
//       joins a system that runs: FILE holds a pairing link for a participant, N is the laptop's host domain.
import { spawn } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { parseArgs } from "node:util";

const require = createRequire(new URL("../../gateway/web/package.json", import.meta.url));
const { chromium } = require("playwright-core");

const { values: options } = parseArgs({
  options: {
    build: { type: "string" },
    chromium: { type: "string", default: "/usr/bin/chromium" },
    "link-file": { type: "string" },
    domain: { type: "string" },
    screenshots: { type: "string" },
  },
});

const children = [];
const folder = mkdtempSync(join(tmpdir(), "tandem-browser-"));

/** Starts a helper; its JSON lines are collected in `lines`. */
function start(program, args = []) {
  const child = spawn(join(options.build, program), args, { stdio: ["ignore", "pipe", "inherit"] });
  const lines = [];
  let rest = "";
  child.stdout.on("data", (chunk) => {
    rest += chunk;
    const parts = rest.split("\n");
    rest = parts.pop();
    for (const line of parts) if (line.startsWith("{")) lines.push(JSON.parse(line));
  });
  children.push(child);
  return lines;
}

async function until(what, condition, seconds = 20) {
  const end = Date.now() + 1000 * seconds;
  for (;;) {
    const value = await condition();
    if (value) return value;
    if (Date.now() > end) throw new Error(`never happened within ${seconds} s: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
}

function check(what, holds) {
  if (!holds) throw new Error(`does not hold: ${what}`);
  console.log(`ok   ${what}`);
}

/** The system to test: where the link is, and on which domain the wheels are seen. */
async function system() {
  if (options["link-file"] !== undefined) return { linkFile: options["link-file"], domain: options.domain, heard: [] };
  const heard = start("tests/fake_team");
  const domain = (await until("the fake team says its domain", () => heard.find((line) => "domain" in line))).domain;
  const config = join(folder, "config");
  const linkFile = join(folder, "participant_link");
  mkdirSync(config);
  writeFileSync(join(config, "site.toml"), `host = "laptop1"\nrole = "laptop"\nhost_domain = ${domain}\n`);
  writeFileSync(
    join(config, "gateway.toml"),
    `address = "127.0.0.1"\nport = 0\nlink_host = "127.0.0.1"\nprint_qr_code = false\n` +
      `state_folder = "${join(folder, "state")}"\nparticipant_link_file = "${linkFile}"\n`,
  );
  start("bin/tandem-gateway", ["--config", config]);
  return { linkFile, domain, heard };
}

async function openPhone(browser) {
  const context = await browser.newContext({
    viewport: { width: 412, height: 915 },
    deviceScaleFactor: 2,
    hasTouch: true,
    isMobile: true,
    ignoreHTTPSErrors: true,
    locale: "en-GB",
  });
  const page = await context.newPage();
  const complaints = [];
  page.on("console", (message) => {
    if (message.type() === "error") complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(error.message));
  return { page, complaints };
}

/** Where the map's point lies on the page, from what the canvas says of its view. */
async function onPage(page, x, y) {
  const canvas = page.locator("canvas.map-canvas");
  const box = await canvas.boundingBox();
  const [cx, cy, scale, turn] = (await canvas.getAttribute("data-view")).split(" ").map(Number);
  const [dx, dy] = [(x - cx) * scale, (y - cy) * scale];
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  return { x: box.x + box.width / 2 + c * dx - s * dy, y: box.y + box.height / 2 - (s * dx + c * dy) };
}

/** A place where a person can stand, near where the team believes the person or the robot is, and not under a button. */
async function placeForAPerson(page) {
  const canvas = page.locator("canvas.map-canvas");
  const told = (await canvas.getAttribute("data-person")) ?? (await canvas.getAttribute("data-robot"));
  const [x, y] = told.split(" ").map(Number);
  for (const [dx, dy] of [[0, -0.5], [0, 0.8], [1, 0], [-1, 0], [2, 1], [2, -1], [-2, 0], [0, 2], [0, 3]]) {
    const { x: left, y: top } = await onPage(page, x + dx, y + dy);
    const free = await page.evaluate(
      ([px, py]) =>  // a finger is wide: a button near it would take the touch
        [[0, 0], [30, 0], [-30, 0], [0, 30], [0, -30]].every(
          ([ax, ay]) => document.elementFromPoint(px + ax, py + ay)?.className === "map-canvas",
        ),
      [left, top],
    );
    if (free) return { x: x + dx, y: y + dy };
  }
  throw new Error("no place near the team can be touched");
}

/** How many pixels of the map have this colour, within a tolerance. */
async function pixelsOf(page, [red, green, blue]) {
  return page.locator("canvas.map-canvas").evaluate(
    (canvas, [r, g, b]) => {
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      let count = 0;
      for (let i = 0; i < data.length; i += 4) {
        if (Math.abs(data[i] - r) + Math.abs(data[i + 1] - g) + Math.abs(data[i + 2] - b) < 12) count += 1;
      }
      return count;
    },
    [red, green, blue],
  );
}

const kPersonPath = [0xd5, 0x5e, 0x00];
const kRobotPath = [0x00, 0x72, 0xb2];

async function picture(page, name) {
  if (options.screenshots === undefined) return;
  mkdirSync(options.screenshots, { recursive: true });
  await page.screenshot({ path: join(options.screenshots, `${name}.png`) });
}

async function run() {
  const { linkFile, domain, heard } = await system();
  const wheels = start("tests/wheel_watch", [String(domain)]);
  const speed = () => Math.max(0, ...wheels.slice(-1).map((one) => Math.max(Math.abs(one.left_mps), Math.abs(one.right_mps))));
  await until("the pairing link is written", () => existsSync(linkFile));
  const link = readFileSync(linkFile, "utf8").trim();

  const browser = await chromium.launch({
    executablePath: options.chromium,
    args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
      "--disable-component-update", "--disable-sync"],
  });
  try {
    const { page, complaints } = await openPhone(browser);
    await page.goto(link);
    await page.locator("button.primary").waitFor();
    check("the token is gone from the address bar", !page.url().includes("t="));
    await picture(page, "start");
    await page.locator("button.primary").tap();
    await until("the link is open", () => page.locator('.strip:not(.unlinked) [data-name="link"].good').count());
    await until("the map is drawn", async () => (await page.locator("canvas[data-view]").count()) > 0);
    await until("the robot is drawn", async () => (await pixelsOf(page, kRobotPath)) > 200);
    check("it pairs and shows the map", true);

    const stopBox = await page.locator("button.stop").boundingBox();
    check("STOP is large", stopBox.width >= 72 && stopBox.height >= 72);
    const onTop = await page.evaluate(
      ([x, y]) => document.elementFromPoint(x, y).className,
      [stopBox.x + stopBox.width / 2, stopBox.y + stopBox.height / 2],
    );
    check("nothing covers STOP", onTop === "stop");

    const at = await placeForAPerson(page);
    const tap = await onPage(page, at.x, at.y);
    await page.touchscreen.tap(tap.x, tap.y);
    if (options["link-file"] === undefined) {
      const pose = await until("My pose arrives", () => heard.find((line) => line.human_message === 0));
      check("My pose arrives where it was placed", Math.hypot(pose.x - at.x, pose.y - at.y) < 0.1);
    }

    await page.locator(".replan").tap();
    if (options["link-file"] === undefined) {
      await until("the page says that a plan is being computed", () => page.locator(".replan .spinner").count());
      await picture(page, "computing");
    }
    await until("both paths are drawn", async () => {
      const [person, robot] = [await pixelsOf(page, kPersonPath), await pixelsOf(page, kRobotPath)];
      return person > 1500 && robot > 1500;
    }, 60);
    check("it shows both paths", true);
    await until("the wheels turn", () => speed() > 0.05, 60);
    await until("the page says so", () => page.locator('[data-name="robot"].good').count());
    await new Promise((resolve) => setTimeout(resolve, 1500));
    await picture(page, "searching");

    const pressed = Date.now();
    await page.locator("button.stop").tap();
    await until("the wheels stand", () => speed() < 0.01, 5);
    check(`STOP stops the wheels (after ${Date.now() - pressed} ms)`, true);
    await page.locator(".resume").waitFor();
    await picture(page, "stopped");

    const bar = await page.locator(".resume").boundingBox();
    await page.mouse.move(bar.x + bar.width / 2, bar.y + bar.height / 2);
    await page.mouse.down();
    await new Promise((resolve) => setTimeout(resolve, 1400));
    await page.mouse.up();
    await until("the wheels turn again", () => speed() > 0.05, 30);
    check("holding the bar lets it go on", true);

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
let status = 0;
try {
  await run();
  console.log("passed");
} catch (error) {
  console.error(error);
  status = 1;
}
for (const child of children) child.kill("SIGTERM");
rmSync(folder, { recursive: true, force: true });
process.exit(status);
