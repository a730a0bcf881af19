// Unpacks what the build packed into an element: base64 of bytes that Zstandard compressed.

import { decompress } from "fzstd";

interface FromBase64 {
  fromBase64?: (text: string) => Uint8Array;
}

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
  // Newer browsers read base64 by themselves, ten times as fast.
  const quick = (Uint8Array as FromBase64).fromBase64;
  if (quick) return quick(text);
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let index = 0; index < letters.length; index += 1) bytes[index] = letters.charCodeAt(index);
  return bytes;
}
