// Checks the types of the page's TypeScript.

import { join } from "node:path";

import { WEB } from "./paths.mjs";
import { run } from "./run.mjs";

export function checkTypes() {
  run(process.execPath, [join(WEB, "node_modules", "typescript", "bin", "tsc"), "--noEmit", "--project", join(WEB, "tsconfig.json")]);
}
