// The engine: Rust compiled for browsers, and its binding to JavaScript.

import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";

import { ENGINE } from "./paths.mjs";
import { run } from "./run.mjs";

const MODULE = "target/wasm/wasm32-unknown-unknown/web/osim_web.wasm";
const BINDGEN = ["run", "--locked", "--manifest-path", "web/bindgen/Cargo.toml", "--target-dir", "target/bindgen"];

/** Compiles crates/osim-web and binds it. */
export function buildEngine() {
  run("bash", ["dev/cargo_wasm.sh", "build", "--profile", "web", "--package", "osim-web"]);
  run("cargo", [...BINDGEN, "--", MODULE, ENGINE]);
}

/** The engine of the last build. */
export function readEngine() {
  const wasm = join(ENGINE, "osim_web_bg.wasm");
  if (!existsSync(wasm)) {
    console.error(`error: ${wasm} is missing: build once without --skip-engine`);
    process.exit(1);
  }
  return { wasm: readFileSync(wasm) };
}
