// Processes that a browser test starts, and ends again however it goes.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

/** A folder of this test's own, gone at its end. */
export const folder = mkdtempSync(join(tmpdir(), "tandem-browser-"));
const children = [];

/** Starts `program`; `lines` holds what it has printed so far, `ended` its exit code or signal. */
export function start(program, args = []) {
  const child = spawn(program, args, { stdio: ["pipe", "pipe", "inherit"] });
  const started = { program, child, lines: [], ended: undefined };
  let rest = "";
  child.stdout.on("data", (chunk) => {
    const parts = (rest + chunk).split("\n");
    rest = parts.pop();
    started.lines.push(...parts);
  });
  child.on("error", (error) => (started.ended = error.message));
  child.on("exit", (code, signal) => (started.ended = code ?? signal));
  children.push(started);
  return started;
}

/** Ends `started` as a crash does, and waits until it is gone. */
export async function kill(started) {
  children.splice(children.indexOf(started), 1);
  started.child.kill("SIGKILL");
  while (started.ended === undefined) await new Promise((resolve) => setTimeout(resolve, 5));
}

export async function until(what, condition, seconds = 20) {
  for (const end = Date.now() + 1000 * seconds; ; ) {
    const value = await condition();
    if (value) return value;
    const broken = children.find((one) => one.ended !== undefined);
    if (broken !== undefined) throw new Error(`${broken.program} ended (${broken.ended}) before: ${what}`);
    if (Date.now() > end) throw new Error(`never happened within ${seconds} s: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
}

export function check(what, holds) {
  if (!holds) throw new Error(`does not hold: ${what}`);
  console.log(`ok   ${what}`);
}

/** Asks every process to end, and makes it after 20 s; then removes the folder. */
async function endAll() {
  const runs = (one) => one.ended === undefined;
  for (const one of children.filter(runs)) one.child.kill("SIGTERM");
  for (const end = Date.now() + 20_000; children.some(runs) && Date.now() < end; ) {
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  for (const one of children.filter(runs)) one.child.kill("SIGKILL");
  rmSync(folder, { recursive: true, force: true });
}

/** Runs `test`, ends all it has started, and exits: 0 when it passed. */
export async function runAndExit(test) {
  let status = 0;
  for (const signal of ["SIGINT", "SIGTERM"]) process.on(signal, () => endAll().then(() => process.exit(1)));
  try {
    await test();
    console.log("passed");
  } catch (error) {
    console.error(error);
    for (const one of children) console.error(`${one.program}: ${one.lines.slice(-3).join("\n  ")}`);
    status = 1;
  }
  await endAll();
  process.exit(status);
}
