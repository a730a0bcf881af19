// Packs bytes into an element of the page: compressed by Zstandard, eleven letters for nine bytes. It is data, not a script: nothing runs it.

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
  return inLetters(done.stdout);
}

/** Nine bytes as eleven letters of 94, of which 94^11 are just enough; `decode` in web/src/engine/unpack.ts reads them. */
function inLetters(bytes) {
  let text = "";
  for (let start = 0; start < bytes.length; start += 9) {
    const count = Math.min(9, bytes.length - start);
    let value = 0n;
    for (let at = 0; at < 9; at += 1) value = value * 256n + BigInt(at < count ? bytes[start + at] : 0);
    let group = "";
    for (let at = 0; at < 11; at += 1) {
      group = letter(Number(value % 94n)) + group;
      value /= 94n;
    }
    text += group.slice(0, Math.ceil((count * 11) / 9));
  }
  return text;
}

/** A printable ASCII character from the blank to ~, without <, which could end the element. */
function letter(digit) {
  const code = 32 + digit;
  return String.fromCharCode(code < 60 ? code : code + 1);
}
