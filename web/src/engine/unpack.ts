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

function bytesOf(text: string): Uint8Array {
  const bytes = new Uint8Array(Math.floor((text.length * 4) / 5));
  let at = 0;
  for (let start = 0; start < text.length; start += 5) {
    let value = 0;
    for (let place = start; place < start + 5; place += 1) value = value * 85 + digit(text, place);
    for (let shift = 24; shift >= 0 && at < bytes.length; shift -= 8) bytes[at++] = (value >>> shift) & 255;
  }
  return bytes;
}

/** That of the letter at a place; behind the end the largest, so that what is cut off the last group does not matter. */
function digit(text: string, place: number): number {
  if (place >= text.length) return 84;
  const code = text.charCodeAt(place);
  return code > 60 ? code - 36 : code - 35;
}
