// Makes the page: one HTML file with everything in it.
//
//   node web/build.mjs                 all of it
//   node web/build.mjs --skip-engine   with the engine that was built last, which is quick

import { mkdirSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { bundlePage, bundleWorker } from "./build/bundle.mjs";
import { buildEngine, readEngine } from "./build/engine.mjs";
import { licences } from "./build/licences.mjs";
import { assemble } from "./build/page.mjs";
import { OUTPUT, PAGE } from "./build/paths.mjs";
import { checkTypes } from "./build/types.mjs";

const MOST_BYTES = 3_000_000;

const known = new Set(["--skip-engine"]);
const unknown = process.argv.slice(2).filter((word) => !known.has(word));
if (unknown.length > 0) {
  console.error(`error: unknown option ${unknown.join(" ")}; there is ${[...known].join(" ")}`);
  process.exit(2);
}
const skipEngine = process.argv.includes("--skip-engine");

mkdirSync(OUTPUT, { recursive: true });
if (!skipEngine) buildEngine();
checkTypes();
const engine = readEngine();
const worker = await bundleWorker();
const [boot, script] = [await bundlePage("boot"), await bundlePage("main")];
const { html, sizes } = await assemble({ boot, script, worker, wasm: engine.wasm, licences: licences(skipEngine) });

const file = join(OUTPUT, PAGE);
writeFileSync(file, html);
sizes.push(["the page", statSync(file).size]);
for (const [name, bytes] of sizes) console.log(`${String(bytes).padStart(9)} bytes  ${name}`);
console.log(file);
if (statSync(file).size > MOST_BYTES) {
  console.error(`error: the page is larger than ${MOST_BYTES} bytes`);
  process.exit(1);
}
