// Problems that axe-core finds on a page, in short.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const AXE_SOURCE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** The rules that are broken, each with the first places; `rules` are those to look at, else all. */
export async function axeFindings(page, rules) {
  await page.evaluate(`${AXE_SOURCE};0`);
  return page.evaluate(async (only) => {
    // Colours that are on their way are not those to look at.
    await Promise.allSettled(document.getAnimations().map(({ finished }) => finished));
    const options = { resultTypes: ["violations"], ...(only ? { runOnly: only } : {}) };
    const { violations } = await window.axe.run(document, options);
    return violations.map(({ id, help, nodes }) => `${id}: ${help}: ${nodes.length} × ${nodes[0].html.slice(0, 160)}`);
  }, rules ?? null);
}
