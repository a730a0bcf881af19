// The licences of everything in the page: of the engine's libraries, and of those in the scripts.

import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { OUTPUT, ROOT, WEB } from "./paths.mjs";
import { run } from "./run.mjs";

const FILE = join(OUTPUT, "licences.txt");
const LINE = `\n\n${"=".repeat(80)}\n\n`;

/** The text of all licences; with `reuse`, that of the last build. */
export function licences(reuse) {
  if (!(reuse && existsSync(FILE))) writeFileSync(FILE, collectLicences());
  return readFileSync(FILE, "utf8");
}

function collectLicences() {
  const own = ["LICENSE-MIT", "LICENSE-APACHE"].map((name) => readFileSync(join(ROOT, name), "utf8").trim());
  const engine = run("python3", ["web/build/licences.py"], { capture: true }).trim();
  const scripts = ["fflate", "fzstd", "three"].map((name) => {
    const text = readFileSync(join(WEB, "node_modules", name, "LICENSE"), "utf8").trim();
    return `${name} ${version(name)}: MIT\n\n${text}`;
  });
  const head = "osim-contact-scale: MIT OR Apache-2.0";
  return [head, ...own, engine, ...scripts].join(LINE) + "\n";
}

function version(name) {
  return JSON.parse(readFileSync(join(WEB, "node_modules", name, "package.json"), "utf8")).version;
}
