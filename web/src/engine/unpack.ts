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

/** Letters of a group, bytes of a group, and the number of different letters. */
const [GROUP, BYTES, BASE] = [11, 9, 94];

/** The bytes of letters. A group is a number of 72 bits, computed in three parts of 24 bits. */
function decode(text: string): Uint8Array {
  const letters = new TextEncoder().encode(text);
  const bytes = new Uint8Array(Math.floor((letters.length * BYTES) / GROUP));
  for (let start = 0, at = 0; start < letters.length; start += GROUP, at += BYTES) {
    let first = 0;
    let middle = 0;
    let last = 0;
    for (let place = start; place < start + GROUP; place += 1) {
      // After the end the largest digit, so that a shortened last group is decoded correctly.
      const code = letters[place] ?? 126;
      last = last * BASE + code - (code > 60 ? 33 : 32);
      middle = middle * BASE + (last >>> 24);
      first = first * BASE + (middle >>> 24);
      last &= 0xffffff;
      middle &= 0xffffff;
    }
    setPart(bytes, at, first);
    setPart(bytes, at + 3, middle);
    setPart(bytes, at + 6, last);
  }
  return bytes;
}

/** Writes 24 bits; places after the end are left out. */
function setPart(bytes: Uint8Array, at: number, part: number): void {
  bytes[at] = part >>> 16;
  bytes[at + 1] = part >>> 8;
  bytes[at + 2] = part;
}
