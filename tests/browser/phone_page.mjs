// The phone's page in headless Chromium: opens it, finds places on its map, looks at its colours.
import { createRequire } from "node:module";

const require = createRequire(new URL("../../gateway/web/package.json", import.meta.url));
const { chromium } = require("playwright-core");

export const kPersonPath = [0xd5, 0x5e, 0x00];
export const kRobotPath = [0x00, 0x72, 0xb2];

/** With the hash of a public key (base64 of SHA-256) the browser trusts that certificate as a lab's phone does. */
export function launch(executablePath, trustedKey) {
  return chromium.launch({
    executablePath,
    args: [...(trustedKey === undefined ? [] : [`--ignore-certificate-errors-spki-list=${trustedKey}`]),
      "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
      "--disable-component-update", "--disable-sync"],
  });
}

/** A page as large as a phone, or as `options` of Playwright say; `complaints` gathers what it complains about. */
export async function openPhone(browser, options = {}) {
  const context = await browser.newContext({
    viewport: { width: 412, height: 915 },
    deviceScaleFactor: 2,
    hasTouch: true,
    isMobile: true,
    ignoreHTTPSErrors: true,
    locale: "en-GB",
    ...options,
  });
  const page = await context.newPage();
  page.setDefaultTimeout(15_000);
  const complaints = [];
  page.on("console", (message) => {
    // A certificate that is not trusted, as on a guest's phone: the page does without a service worker.
    if (message.type() === "error" && !/service ?worker|when fetching the script/i.test(message.text())) complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(error.message));
  return { page, complaints };
}

/** Opens `link` and taps through to the search. */
export async function join(page, link) {
  await page.goto(link);
  await page.locator("button.primary").tap();
  await page.locator('.strip:not(.unlinked) [data-name="link"]:is(.good, .busy)').waitFor();
  await page.locator("canvas[data-view]").waitFor();
}

const mapOf = (page) => page.locator("canvas.map-canvas");

/** Where the team believes the "robot" or the "person" to be; undefined where it does not know. */
export async function believed(page, who) {
  const told = await mapOf(page).getAttribute(`data-${who}`);
  if (told === null) return undefined;
  const [x, y] = told.split(" ").map(Number);
  return { x, y };
}

/** Where the map's point lies on the page, from what the canvas says of its view. */
export async function onPage(page, { x, y }) {
  const box = await mapOf(page).boundingBox();
  const [cx, cy, scale, turn] = (await mapOf(page).getAttribute("data-view")).split(" ").map(Number);
  const [dx, dy] = [(x - cx) * scale, (y - cy) * scale];
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  return { x: box.x + box.width / 2 + c * dx - s * dy, y: box.y + box.height / 2 - (s * dx + c * dy) };
}

export async function tapMap(page, place) {
  const { x, y } = await onPage(page, place);
  await page.touchscreen.tap(x, y);
}

/** True when a finger reaches the map there, and not a button near it. */
function isInReach(page, { x, y }) {
  return page.evaluate(
    ([left, top]) =>
      [[0, 0], [30, 0], [-30, 0], [0, 30], [0, -30]].every(
        ([dx, dy]) => document.elementFromPoint(left + dx, top + dy)?.className === "map-canvas",
      ),
    [x, y],
  );
}

/** True when the map shows free floor for half a metre around: neither wall nor the grey of what is unknown. */
async function isFloor(page, place) {
  const around = [[0, 0], [0.5, 0], [-0.5, 0], [0, 0.5], [0, -0.5], [0.35, 0.35], [-0.35, 0.35], [0.35, -0.35], [-0.35, -0.35]];
  const box = await mapOf(page).boundingBox();
  const spots = [];
  for (const [dx, dy] of around) {
    const spot = await onPage(page, { x: place.x + dx, y: place.y + dy });
    spots.push([(spot.x - box.x) / box.width, (spot.y - box.y) / box.height]);
  }
  return mapOf(page).evaluate((canvas, shares) => {
    const context = canvas.getContext("2d");
    return shares.every(([x, y]) => {
      if (x < 0 || x >= 1 || y < 0 || y >= 1) return false;
      const [r, g, b] = context.getImageData(Math.floor(x * canvas.width), Math.floor(y * canvas.height), 1, 1).data;
      const unknown = Math.abs(r - 0xde) + Math.abs(g - 0xe3) + Math.abs(b - 0xe8) < 12;
      return r + g + b > 350 && !unknown;
    });
  }, spots);
}

/** A place where a person can stand, `near` to `far` metres from the robot, and not under a button. */
export async function placeForAPerson(page, near, far) {
  const robot = await believed(page, "robot");
  for (let distance = near; distance <= far; distance += 0.5) {
    for (let bearing = 0; bearing < 360; bearing += 30) {
      const radians = (bearing * Math.PI) / 180;
      const place = { x: robot.x + distance * Math.cos(radians), y: robot.y + distance * Math.sin(radians) };
      if ((await isInReach(page, await onPage(page, place))) && (await isFloor(page, place))) return place;
    }
  }
  throw new Error("no place near the robot can be touched");
}

/** How many pixels of the map have this colour, within a tolerance. */
export function pixelsOf(page, colour) {
  return mapOf(page).evaluate((canvas, [r, g, b]) => {
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let i = 0; i < data.length; i += 4) {
      if (Math.abs(data[i] - r) + Math.abs(data[i + 1] - g) + Math.abs(data[i + 2] - b) < 12) count += 1;
    }
    return count;
  }, colour);
}
