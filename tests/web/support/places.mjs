// Paths of the page, the program and the browsers, and a check which of them are missing.

import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

export const ROOT = fileURLToPath(new URL("../../..", import.meta.url));
export const PAGE = join(ROOT, "target/web/osim-contact-scale.html");
export const PAGE_ADDRESS = pathToFileURL(PAGE).href;
export const PROGRAM = process.env.OSIM_PROGRAM ?? join(ROOT, "target/release/osim-contact-scale");
export const CORPUS = process.env.OSIM_CORPUS ?? "";
export const CHROMIUM = "/usr/bin/chromium";
export const FIREFOX = "/usr/bin/firefox-esr";

/** The path of a file below fixtures/. */
export function fixture(name) {
  return join(ROOT, "fixtures", name);
}

/** The path of a published model. */
export function published(name) {
  return join(CORPUS, name);
}

/** A fixture as a file to open, under its own name or under `name`. */
export function given(path, name = path.split("/").pop()) {
  return { name, bytes: readFileSync(fixture(path)) };
}

/** Programs and files that a test needs and this machine lacks; undefined if nothing is missing. */
export function lacking({ corpus = false, browser = CHROMIUM } = {}) {
  if (!existsSync(browser)) return `${browser}: not found`;
  if (corpus && !CORPUS) return "OSIM_CORPUS is not set";
  return undefined;
}

for (const [path, way] of [[PAGE, "node web/build.mjs"], [PROGRAM, "cargo build --release"]]) {
  if (!existsSync(path)) throw new Error(`${path} is not there: ${way}`);
}
