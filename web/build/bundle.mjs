// Makes one script of many modules: one for the page, one for the worker.

import { join } from "node:path";

import { build } from "esbuild";

import { asciiSource } from "./pack.mjs";
import { ENGINE, WEB } from "./paths.mjs";

const COMMON = {
  bundle: true,
  write: false,
  format: "iife",
  minify: true,
  charset: "ascii",
  legalComments: "none",
  // The oldest browsers that the page says it needs.
  target: ["chrome97", "firefox102", "safari16"],
  // What wasm-bindgen would load the module from, if it were not given its bytes.
  define: { "import.meta.url": '""' },
  logLevel: "warning",
};

/** The worker with the engine's binding. */
export async function bundleWorker() {
  return text(await build({
    ...COMMON,
    entryPoints: [join(WEB, "src/engine/worker.ts")],
    alias: { "osim-engine": join(ENGINE, "osim_web.js") },
  }));
}

/** The script `src/NAME.ts` of the page. */
export async function bundlePage(name) {
  return text(await build({ ...COMMON, entryPoints: [join(WEB, "src", `${name}.ts`)] }));
}

/** The script in ASCII; esbuild leaves other letters in regular expressions. */
function text(result) {
  return asciiSource(result.outputFiles[0].text);
}
