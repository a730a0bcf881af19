// Unpacks what the build packed into an element: letters for bytes that Zstandard compressed (web/build/pack.mjs).

import { decompress } from "fzstd";

/** The bytes in `text`. */
export function unpack(text: string): Uint8Array<ArrayBuffer> {
  return decompress(bytesOf(text)) as Uint8Array<ArrayBuffer>;
}

/** The packed text of the element with this id. */
export function packed(id: string): string {
  return document.getElementById(id)?.textContent ?? "";
}

/** What the element with this id holds, as text. */
export function unpackedText(id: string): string {
  return new TextDecoder().decode(unpack(packed(id)));
}

/** Letters for so many bytes in a group, and how many letters there are. */
const [GROUP, BYTES, BASE] = [11, 9, 94];
/** The last six letters of a group are below this; in parts of 24 bits. */
const PART = 2 ** 24;
const [ABOVE, BELOW] = [Math.floor(BASE ** 6 / PART), BASE ** 6 % PART];

function bytesOf(text: string): Uint8Array {
  const bytes = new Uint8Array(Math.floor((text.length * BYTES) / GROUP));
  let at = 0;
  for (let start = 0; start < text.length; start += GROUP) {
    for (const part of parts(number(text, start, 5), number(text, start + 5, 6))) {
      for (let shift = 16; shift >= 0 && at < bytes.length; shift -= 8) bytes[at++] = (part >>> shift) & 255;
    }
  }
  return bytes;
}

/** `high` times 94^6 and `low`, 72 bits in three parts: more than a number holds. */
function parts(high: number, low: number): [number, number, number] {
  const last = (high % PART) * BELOW + (low % PART);
  const middle = Math.floor(high / PART) * BELOW + (high % PART) * ABOVE + Math.floor(low / PART) + Math.floor(last / PART);
  const first = Math.floor(high / PART) * ABOVE + Math.floor(middle / PART);
  return [first, middle % PART, last % PART];
}

/** The number that `count` letters from `start` on are. */
function number(text: string, start: number, count: number): number {
  let value = 0;
  for (let place = start; place < start + count; place += 1) value = value * BASE + digit(text, place);
  return value;
}

/** That of the letter at a place; behind the end the largest, so that what is cut off the last group does not matter. */
function digit(text: string, place: number): number {
  if (place >= text.length) return BASE - 1;
  const code = text.charCodeAt(place);
  return code > 60 ? code - 33 : code - 32;
}
