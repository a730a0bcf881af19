// Packs bytes into an element of the page: compressed by Zstandard, five letters for four bytes. It is data, not a script: nothing runs it.

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

/** Four bytes as five letters of 85, a sixteenth less than in base64; `bytesOf` in web/src/engine/unpack.ts reads them. */
function inLetters(bytes) {
  let text = "";
  for (let start = 0; start < bytes.length; start += 4) {
    const count = Math.min(4, bytes.length - start);
    let value = 0;
    for (let at = 0; at < 4; at += 1) value = value * 256 + (at < count ? bytes[start + at] : 0);
    let group = "";
    for (let at = 0; at < 5; at += 1) {
      group = letter(value % 85) + group;
      value = Math.floor(value / 85);
    }
    text += group.slice(0, count + 1);
  }
  return text;
}

/** From # on, without <, which could end the element. */
function letter(digit) {
  const code = 35 + digit;
  return String.fromCharCode(code < 60 ? code : code + 1);
}
