// Facts of the project that the page shows: its version, and what to cite.

import { readFileSync } from "node:fs";
import { join } from "node:path";

import { ROOT } from "./paths.mjs";

/** The version of the workspace. */
export function version() {
  const text = readFileSync(join(ROOT, "Cargo.toml"), "utf8");
  const match = /\[workspace\.package\][^[]*?\nversion\s*=\s*"([^"]+)"/.exec(text);
  if (!match) throw new Error("Cargo.toml: no version in [workspace.package]");
  return match[1];
}

/** The paper, as CITATION.cff has it. */
export function paper() {
  const text = readFileSync(join(ROOT, "CITATION.cff"), "utf8");
  const references = text.slice(text.indexOf("\nreferences:"));
  const field = (pattern, what) => {
    const match = pattern.exec(references);
    if (!match) throw new Error(`CITATION.cff: no ${what} of the paper`);
    return match[1].replace(/\s+/g, " ").trim();
  };
  return {
    title: field(/title:\s*>-\s*\n((?:\s{6,}.+\n)+)/, "title"),
    family: field(/family-names:\s*(.+)/, "author"),
    given: field(/given-names:\s*(.+)/, "author"),
    journal: field(/journal:\s*(.+)/, "journal"),
    year: field(/year:\s*(.+)/, "year"),
    doi: field(/doi:\s*(.+)/, "doi"),
  };
}
