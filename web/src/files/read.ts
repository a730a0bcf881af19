// Reads files that were dropped or chosen. Bytes are handed over to the worker, not copied.

import { type FileKind, kindOf, LOOKED_AT } from "./kinds";

/** A file with the name that it has here: with its folders, where a folder was given. */
export interface Given {
  name: string;
  file: File;
}

export interface Read {
  name: string;
  bytes: Uint8Array;
  kind: FileKind;
}

export async function read({ name, file }: Given): Promise<Read> {
  const head = await file.slice(0, LOOKED_AT).text();
  return { name, bytes: new Uint8Array(await file.arrayBuffer()), kind: kindOf(name, head) };
}

/** Files from an input; those of a folder have their path in it. */
export function givenBy(list: FileList | null): Given[] {
  return [...(list ?? [])].map((file) => ({ name: file.webkitRelativePath || file.name, file }));
}
