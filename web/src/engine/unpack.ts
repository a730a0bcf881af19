// Unpacks data that the build stored in elements: bytes compressed by Zstandard, written as letters (web/build/pack.mjs).

import { decompress } from "fzstd";

/** The bytes that are packed in `text`. */
export function unpack(text: string): Uint8Array<ArrayBuffer> {
  return decompress(decode(text)) as Uint8Array<ArrayBuffer>;
}

/** The packed text of the element with this id. */
export function packed(id: string): string {
  return document.getElementById(id)?.textContent ?? "";
}

/** The unpacked text of the element with this id. */
export function unpackedText(id: string): string {
  return new TextDecoder().decode(unpack(packed(id)));
}

/** Letters by their places, as in web/build/pack.mjs: two of them are 13 bits. */
const LETTERS = Array.from({ length: 95 }, (_, place) => 32 + place).filter((code) => code !== 60);

/** The bytes of letters. A pair is read as one number, little-endian as every browser has it. */
function decode(text: string): Uint8Array {
  const values = new Uint16Array(1 << 15);
  for (const [high, first] of LETTERS.entries()) for (const [low, second] of LETTERS.entries()) values[first | (second << 8)] = high * 94 + low;
  // After the end the last letter, so that half a pair is decoded correctly.
  const pairs = new Uint16Array(new TextEncoder().encode(`${text}~`).buffer, 0, (text.length + 1) >> 1);
  const bytes = new Uint8Array((text.length * 13) >> 4);
  let [bits, count, at] = [0, 0, 0];
  for (let place = 0; place < pairs.length; place += 1) {
    bits = (bits << 13) | (values[pairs[place] ?? 0] ?? 0);
    // Each pair has one whole byte, or two.
    for (count += 13; count >= 8; at += 1) bytes[at] = bits >>> (count -= 8);
  }
  return bytes;
}
