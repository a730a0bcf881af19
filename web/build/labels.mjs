// What fields are called. The engine's messages name them so, so that the names are read from where they are declared.

import { readFileSync } from "node:fs";
import { join } from "node:path";

import { ROOT } from "./paths.mjs";

const SOURCE = "crates/osim-model/src/messages/input.rs";

/** The label of each field, by its name in requests. */
export function labels() {
  const text = readFileSync(join(ROOT, SOURCE), "utf8");
  const found = [...text.matchAll(/^ {4}[A-Z]\w+ = "(\w+)", "([^"]+)";$/gm)];
  if (found.length === 0) throw new Error(`${SOURCE}: no labels found`);
  return new Map(found.map(([, name, label]) => [name, label]));
}
