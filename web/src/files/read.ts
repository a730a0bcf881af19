// Reads files that were dropped or chosen.

import { type FileKind, kindOf, HEAD_BYTES } from "./kinds";

/** A file with its name on this page, which includes the folders if a folder was opened. */
export interface GivenFile {
  name: string;
  file: File;
}

export interface ReadFile {
  name: string;
  bytes: Uint8Array;
  kind: FileKind;
}

export async function readFile({ name, file }: GivenFile): Promise<ReadFile> {
  const head = await file.slice(0, HEAD_BYTES).text();
  return { name, bytes: new Uint8Array(await file.arrayBuffer()), kind: kindOf(name, head) };
}

/** The files of an input; those of a folder have their path. */
export function filesOfInput(list: FileList | null): GivenFile[] {
  return [...(list ?? [])].map((file) => ({ name: file.webkitRelativePath || file.name, file }));
}
