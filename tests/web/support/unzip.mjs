// Unpacks archives with Python's own library, so that another program than the page reads them.

import { spawnSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

/** The files in an archive, by their names. */
export function unzipped(bytes) {
  const folder = mkdtempSync(join(tmpdir(), "osim-web-zip-"));
  try {
    writeFileSync(join(folder, "models.zip"), bytes);
    const done = spawnSync("python3", ["-m", "zipfile", "-e", "models.zip", "inside"], { cwd: folder, encoding: "utf8" });
    if (done.status !== 0) throw new Error(done.stderr);
    const inside = join(folder, "inside");
    return new Map(readdirSync(inside).map((name) => [name, readFileSync(join(inside, name))]));
  } finally {
    rmSync(folder, { recursive: true });
  }
}
