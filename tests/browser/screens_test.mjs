// Every state of the phone's screen in three languages, light and dark, on a small phone, a phone and a tablet: no
// finding of axe, nothing cut off, every control large enough for a thumb, none over another, STOP on top.
//
//   node screens_test.mjs --build BUILD_FOLDER [--chromium FILE] [--screenshots FOLDER]
import { existsSync, mkdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { parseArgs } from "node:util";
import * as phone from "./phone_page.mjs";
import { check, runAndExit, until } from "./processes.mjs";
import { fakeTeam } from "./systems.mjs";

const require = createRequire(new URL("../../gateway/web/package.json", import.meta.url));
const { source: axe } = require("axe-core");

const { values: options } = parseArgs({
  options: {
    build: { type: "string" },
    chromium: { type: "string", default: "/usr/bin/chromium" },
    screenshots: { type: "string" },
  },
});

const kSizes = [[320, 568], [412, 915], [820, 1180]];
const kThemes = ["light", "dark"];
const kLanguages = ["en", "es", "ca"];
const kLeastTarget = 56; // the row of buttons on the map; tools are held to 64 below
const kLeastTool = 64;

/** What is wrong with the layout, in words. */
function layoutFaults(page) {
  return page.evaluate(
    ([leastTarget, leastTool]) => {
      const shown = (one) => {
        const box = one.getBoundingClientRect();
        const style = getComputedStyle(one);
        return box.width > 0 && style.visibility !== "hidden" && one.closest("[inert]") === null;
      };
      const top = document.querySelector('[role="alertdialog"], .sheet') ?? document;
      const buttons = [...top.querySelectorAll("button"), ...document.querySelectorAll("button.stop")].filter(shown);
      const boxes = buttons.map((one) => ({
        one,
        box: one.getBoundingClientRect(),
        name: `${one.className}/${one.textContent || one.getAttribute("aria-label")}`,
      }));
      const faults = [];
      for (const { one, box, name } of boxes) {
        const least = one.closest(".map-buttons") === null ? leastTool : leastTarget;
        if (box.width < least || box.height < least) faults.push(`${name} is ${box.width} x ${box.height}`);
        if (one.scrollWidth > one.clientWidth + 1 || one.scrollHeight > one.clientHeight + 1) faults.push(`${name} is cut off`);
        if (one.closest(".sheet-body") === null && (box.left < 0 || box.right > innerWidth || box.bottom > innerHeight + 1)) {
          faults.push(`${name} is off the screen`);
        }
      }
      for (const a of boxes) {
        for (const b of boxes) {
          if (a.one >= b.one || a.one === b.one || a.one.closest(".sheet-body") !== b.one.closest(".sheet-body")) continue;
          const wide = Math.min(a.box.right, b.box.right) - Math.max(a.box.left, b.box.left);
          const high = Math.min(a.box.bottom, b.box.bottom) - Math.max(a.box.top, b.box.top);
          if (wide > 0.5 && high > 0.5) faults.push(`${a.name} and ${b.name} overlap`);
        }
      }
      for (const one of document.querySelectorAll(".strip *, .toast span, .sheet h2, .sheet h3, .popup *")) {
        if (shown(one) && !one.classList.contains("hidden") && one.scrollWidth > one.clientWidth + 1 && getComputedStyle(one).display !== "inline") {
          faults.push(`"${one.textContent}" is cut off`);
        }
      }
      if (document.documentElement.scrollWidth > innerWidth) faults.push("the page is wider than the screen");
      const stop = document.querySelector("button.stop")?.getBoundingClientRect();
      if (stop !== undefined) {
        const onTop = document.elementFromPoint(stop.x + stop.width / 2, stop.y + stop.height / 2);
        if (onTop?.className !== "stop") faults.push(`STOP is under ${onTop?.className}`);
      }
      return faults;
    },
    [kLeastTarget, kLeastTool],
  );
}

/** What axe finds: rules of WCAG 2.2 A and AA, and its best practices. */
async function axeFindings(page) {
  await page.evaluate(axe);
  const found = await page.evaluate(() => axe.run(document, { resultTypes: ["violations"] }));
  return found.violations.map(({ id, nodes }) => `${id}: ${nodes.map((one) => one.target.join(" ")).join(", ")}`);
}

const faultsFound = [];

/** Says what was found in the state `name`; all states are looked at before the test fails. */
function report(name) {
  const mine = faultsFound.filter((fault) => fault.startsWith(`${name} `));
  console.log(mine.length === 0 ? `ok   ${name}` : mine.map((fault) => `FAIL ${fault}`).join("\n"));
}

/** Looks at the state `name` on every size, in the dress that the page wears. */
async function lookAt(page, name, dress) {
  for (const [width, height] of kSizes) {
    await page.setViewportSize({ width, height });
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    const faults = [...(await layoutFaults(page)), ...(await axeFindings(page))];
    for (const fault of faults) faultsFound.push(`${name} ${dress} ${width}: ${fault}`);
    if (options.screenshots === undefined) continue;
    mkdirSync(options.screenshots, { recursive: true });
    await page.screenshot({ path: join(options.screenshots, `${name}-${dress}-${width}.png`) });
  }
}

async function wear(page, language, theme) {
  if ((await page.locator(".sheet .close").count()) > 0) await page.locator(".sheet .close").click();
  await page.locator('[data-button="settings"]').click();
  await page.locator(`.sheet [data-word="${language}"]`).click();
  await page.locator(`.sheet [data-word="${theme}"]`).click();
  await page.locator(".sheet .close").click();
}

/** Looks at a state in every dress; `enter` brings it about again after the page has changed its dress. */
async function everyDress(page, name, enter = async () => undefined) {
  for (const theme of kThemes) {
    for (const language of kLanguages) {
      await page.setViewportSize({ width: 412, height: 915 });
      await wear(page, language, theme);
      await enter();
      await lookAt(page, name, `${language}-${theme}`);
    }
  }
  await page.setViewportSize({ width: 412, height: 915 });
  report(name);
}

async function welcome(browser, link) {
  const { page } = await phone.openPhone(browser);
  await page.goto(new URL("/", link).href);
  await page.locator(".welcome").waitFor();
  await until("it says that a link is needed", async () => (await page.locator(".welcome").innerText()).includes("QR"), 30);
  for (const language of kLanguages) {
    await page.locator(`[data-word="${language}"]`).click();
    await lookAt(page, "no-link", language);
  }
  report("no-link");
  await page.context().close();
}

async function states(page, team) {
  await everyDress(page, "ready");
  await everyDress(page, "settings", () => page.locator('[data-button="settings"]').click());
  await page.locator(".sheet .close").click();
  await page.locator('[data-tool="my_pose"]').tap();
  await phone.tapMap(page, { x: 4, y: 12 });
  await page.locator('[data-tool="replan"]').tap();
  await page.locator(".spinner").waitFor();
  await lookAt(page, "computing", "ca-dark");
  await page.locator(".toast.inform button").waitFor();
  await lookAt(page, "told", "ca-dark");
  await page.setViewportSize({ width: 412, height: 915 });
  await page.locator(".toast.inform button").tap();
  await everyDress(page, "searching");
  await everyDress(page, "more", () => page.locator('[data-tool="more"]').click());
  await page.locator('[data-edit="avoid"]').tap();
  await phone.tapMap(page, { x: 12, y: 12 });
  await page.locator('[data-button="send"]').tap();
  await until("it is drawn", () => team.heard().some((line) => line.source_edit !== undefined));
  await everyDress(page, "drawing", async () => {
    if ((await page.locator(".draw-bar").count()) > 0) return;
    await page.locator('[data-tool="more"]').click();
    await page.locator('[data-edit="pass_through"]').click();
  });
  await page.locator(".draw-bar .second").tap();
  team.tell("lose");
  await page.locator(".toast.bad").waitFor();
  await everyDress(page, "lost");
  team.tell("track");
  team.tell("session running human_robot counters");
  await page.locator(".badge").first().waitFor();
  await everyDress(page, "counters");
  await page.locator("button.stop").tap();
  await page.locator(".resume").waitFor();
  await everyDress(page, "stopped");
  team.freeze();
  await page.locator(".map-note.stale").waitFor();
  await lookAt(page, "stale", "ca-dark");
  team.thaw();
  await page.setViewportSize({ width: 412, height: 915 });
  await page.locator(".strip:not(.unlinked)").waitFor();
}

async function popUp(page, team) {
  const resume = await page.locator(".resume").boundingBox();
  await page.mouse.move(resume.x + 50, resume.y + 20);
  await page.mouse.down();
  await until("it goes on", async () => (await page.locator(".resume").count()) === 0);
  await page.mouse.up();
  for (const theme of kThemes) {
    for (const language of kLanguages) {
      team.tell("session running human_robot none");
      await until("no pop-up is open", async () => (await page.locator('[data-button="settings"]').count()) > 0);
      await page.setViewportSize({ width: 412, height: 915 });
      await wear(page, language, theme);
      team.tell("session running human_robot popup");
      await page.locator(".veil").waitFor();
      await lookAt(page, "pop-up", `${language}-${theme}`);
      await page.locator(".popup .primary").click();
      await lookAt(page, "pop-up-placing", `${language}-${theme}`);
      await page.setViewportSize({ width: 412, height: 915 });
      await phone.tapMap(page, { x: 5, y: 12 });
    }
  }
  report("pop-up");
}

async function run() {
  const team = await fakeTeam(options.build, { settings: ["reminder_threshold_s = 1.0", "reminder_floor_s = 1.0"] });
  const browser = await phone.launch(options.chromium);
  try {
    const link = await team.link("participant");
    await welcome(browser, link);
    const { page, complaints } = await phone.openPhone(browser);
    await page.goto(link);
    await page.locator("button.primary").waitFor();
    for (const language of kLanguages) {
      await page.locator(`[data-word="${language}"]`).click();
      await lookAt(page, "start", language);
    }
    report("start");
    await page.locator("button.primary").click();
    await page.locator("canvas[data-view]").waitFor();
    await states(page, team);
    await popUp(page, team);
    team.tell("session running human_human none");
    await page.locator(".strip-row[hidden]").waitFor({ state: "attached" });
    await everyDress(page, "two-people");
    check(`nothing is wrong anywhere: ${faultsFound.length} faults`, faultsFound.length === 0);
    check(`the page complains about nothing: ${complaints.join("; ")}`, complaints.length === 0);
  } catch (error) {
    for (const page of browser.contexts().flatMap((context) => context.pages())) {
      if (options.screenshots !== undefined) await page.screenshot({ path: join(options.screenshots, "failed.png") });
    }
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
