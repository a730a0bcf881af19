// Packs bytes into an element of the page: compressed by Zstandard, two letters for each 13 bits. It is data, not a script: nothing runs it.

import { spawnSync } from "node:child_process";

const LEVEL = ["--ultra", "-22", "--no-check", "--quiet", "--stdout"];

/** Text as an element with this id: what the page needs at once. */
export function textBlock(id, text) {
  return `<script type="text/plain" id="${id}">${text}</script>`;
}

/** A script or JSON in ASCII, which browsers read several times as fast as other text. */
export function asciiSource(text) {
  return text.replace(/[^\0-\x7f]/g, (unit) => `\\u${unit.charCodeAt(0).toString(16).padStart(4, "0")}`);
}

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

/** Each 13 bits as two letters of 94, of which 94² are just enough; `decode` in web/src/engine/unpack.ts reads them. */
function inLetters(bytes) {
  const text = [];
  let [bits, count] = [0, 0];
  // Zeros fill the last pair.
  for (const byte of [...bytes, 0, 0]) {
    bits = ((bits & 0x1fff) << 8) | byte;
    count += 8;
    if (count < 13) continue;
    count -= 13;
    const value = (bits >>> count) & 0x1fff;
    text.push(letter(Math.floor(value / 94)), letter(value % 94));
  }
  return text.slice(0, Math.ceil((bytes.length * 16) / 13)).join("");
}

/** A printable ASCII character from the blank to ~, without <, which could end the element. */
function letter(digit) {
  const code = 32 + digit;
  return String.fromCharCode(code < 60 ? code : code + 1);
}
