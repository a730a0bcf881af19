// Packs bytes into an element of the page: compressed by Zstandard, in base64. It is data, not a script: nothing runs it.

import { spawnSync } from "node:child_process";

const LEVEL = ["--ultra", "-22", "--no-check", "--quiet", "--stdout"];

/** `bytes` as an element with this id. */
export function block(id, bytes) {
  return `<script type="application/octet-stream" id="${id}">${packed(bytes)}</script>`;
}

function packed(bytes) {
  // Told the size, zstd asks the reader for no more memory than that: for 128 MB of it otherwise.
  const done = spawnSync("zstd", [...LEVEL, `--stream-size=${bytes.length}`], { input: bytes, maxBuffer: 1 << 28 });
  if (done.error || done.status !== 0) throw new Error(`zstd: ${done.error?.message ?? done.stderr}`);
  return done.stdout.toString("base64");
}
