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
/** Numbers are computed in parts of 24 bits: 94^6 has a part above and a part below. */
const PART_SIZE = 2 ** 24;
const [FACTOR_ABOVE, FACTOR_BELOW] = [Math.floor(BASE ** 6 / PART_SIZE), BASE ** 6 % PART_SIZE];

function decode(text: string): Uint8Array {
  const bytes = new Uint8Array(Math.floor((text.length * BYTES) / GROUP));
  let at = 0;
  for (let start = 0; start < text.length; start += GROUP) {
    for (const part of partsOfGroup(numberOfDigits(text, start, 5), numberOfDigits(text, start + 5, 6))) {
      for (let shift = 16; shift >= 0 && at < bytes.length; shift -= 8) bytes[at++] = (part >>> shift) & 255;
    }
  }
  return bytes;
}

/** `high` times 94^6 plus `low`, in three parts of 24 bits, because a number cannot hold 72 bits. */
function partsOfGroup(high: number, low: number): [number, number, number] {
  const last = (high % PART_SIZE) * FACTOR_BELOW + (low % PART_SIZE);
  const middle = Math.floor(high / PART_SIZE) * FACTOR_BELOW + (high % PART_SIZE) * FACTOR_ABOVE + Math.floor(low / PART_SIZE) + Math.floor(last / PART_SIZE);
  const first = Math.floor(high / PART_SIZE) * FACTOR_ABOVE + Math.floor(middle / PART_SIZE);
  return [first, middle % PART_SIZE, last % PART_SIZE];
}

/** The number that is written by `count` letters from `start` on. */
function numberOfDigits(text: string, start: number, count: number): number {
  let value = 0;
  for (let place = start; place < start + count; place += 1) value = value * BASE + digitAt(text, place);
  return value;
}

/** The digit at a place; after the end the largest digit, so that a shortened last group is decoded correctly. */
function digitAt(text: string, place: number): number {
  if (place >= text.length) return BASE - 1;
  const code = text.charCodeAt(place);
  return code > 60 ? code - 33 : code - 32;
}
