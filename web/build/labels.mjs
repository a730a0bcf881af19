// Labels of fields, read from the file that declares them for the engine's messages.

import { readFileSync } from "node:fs";
import { join } from "node:path";

import { ROOT } from "./paths.mjs";

const SOURCE = "crates/osim-model/src/messages/input.rs";

/** The label of each field, by its name in requests. */
export function labels() {
  const text = readFileSync(join(ROOT, SOURCE), "utf8");
  const matches = [...text.matchAll(/^ {4}[A-Z]\w+ = "(\w+)", "([^"]+)";$/gm)];
  if (matches.length === 0) throw new Error(`${SOURCE}: no labels found`);
  return new Map(matches.map(([, name, label]) => [name, label]));
}
