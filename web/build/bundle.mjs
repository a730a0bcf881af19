// Makes one script of many modules: one for the page, one for the worker.

import { join } from "node:path";

import { build } from "esbuild";

import { ENGINE, WEB } from "./paths.mjs";

const COMMON = {
  bundle: true,
  write: false,
  format: "iife",
  minify: true,
  charset: "utf8",
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

/** The page. */
export async function bundlePage() {
  return text(await build({ ...COMMON, entryPoints: [join(WEB, "src/main.ts")] }));
}

function text(result) {
  return result.outputFiles[0].text;
}
