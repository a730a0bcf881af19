// Runs other programs; what they print is seen, and a failure ends the build.

import { spawnSync } from "node:child_process";

import { ROOT } from "./paths.mjs";

/** Runs a program in the project's folder; gives what it writes to standard output when `capture` is set. */
export function run(program, words, { capture = false } = {}) {
  console.log(`+ ${[program, ...words].join(" ")}`);
  const stdout = capture ? "pipe" : "inherit";
  const options = { cwd: ROOT, stdio: ["ignore", stdout, "inherit"], encoding: "utf8", maxBuffer: 1 << 28 };
  const done = spawnSync(program, words, options);
  if (done.error) throw done.error;
  if (done.status !== 0) process.exit(done.status ?? 1);
  return done.stdout ?? "";
}
