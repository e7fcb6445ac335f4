// Makes docs/images/phone.png anew: a person walks along the plan of a whole simulated search and says so now and then.
//
//   node phone_picture.mjs --build BUILD_FOLDER --output FILE [--after SECONDS] [--chromium FILE]
import { parseArgs } from "node:util";
import * as phone from "./phone_page.mjs";
import { runAndExit, until } from "./processes.mjs";
import { pairingLink, wholeSystem } from "./systems.mjs";

const { values: options } = parseArgs({
  options: {
    build: { type: "string" },
    output: { type: "string" },
    after: { type: "string", default: "40" },
    chromium: { type: "string", default: "/usr/bin/chromium" },
  },
});
const kSpeed_mps = 0.75;
const kBetweenPoses_s = 5;

/** The newest accepted plan, as the gateway sends it. */
function hearPlans(page) {
  const heard = { plan: undefined, at: 0 };
  page.on("websocket", (socket) =>
    socket.on("framereceived", ({ payload }) => {
      if (typeof payload !== "string") return;
      const message = JSON.parse(payload);
      if (message.type !== "plan" || message.state !== "accepted") return;
      if (message.id !== heard.plan?.id) heard.at = performance.now();
      heard.plan = message;
    }),
  );
  return heard;
}

/** Where somebody is who has walked `length` metres along `points`. */
function along(points, length) {
  let left = length;
  for (let i = 1; i < points.length; i += 1) {
    const [[, x0, y0], [, x1, y1]] = [points[i - 1], points[i]];
    const leg = Math.hypot(x1 - x0, y1 - y0);
    if (left < leg) return { x: x0 + ((x1 - x0) * left) / leg, y: y0 + ((y1 - y0) * left) / leg };
    left -= leg;
  }
  const [, x, y] = points.at(-1);
  return { x, y };
}

await runAndExit(async () => {
  const link = await pairingLink(await wholeSystem(options.build, "brl"));
  const browser = await phone.launch(options.chromium);
  try {
    const { page } = await phone.openPhone(browser);
    const heard = hearPlans(page);
    await page.goto(link);
    await page.locator("button.primary").tap();
    await until("the robot is drawn", async () => (await phone.pixelsOf(page, phone.kRobotPath)) > 200);
    await phone.tapMap(page, await phone.placeForAPerson(page, 2.0, 3.0));
    await page.locator(".replan").tap();
    await until("a plan is accepted", () => heard.plan, 60);
    const began = performance.now();
    let told = began;
    await until("the search has gone on for a while", async () => {
      const now = performance.now();
      const mine = heard.plan.paths.find((path) => path.agent.startsWith("person"));
      if (mine !== undefined && now - told > 1000 * kBetweenPoses_s) {
        told = now;
        await phone.tapMap(page, along(mine.points, (kSpeed_mps * (now - heard.at)) / 1000));
      }
      const moving = await page.locator('[data-name="robot"].good').count();
      return now - began > 1000 * Number(options.after) && moving > 0 && now - told > 800 && now - told < 2000;
    }, Number(options.after) + 60);
    await page.screenshot({ path: options.output });
  } finally {
    await browser.close();
  }
});
