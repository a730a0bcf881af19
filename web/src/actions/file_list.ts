// Adds files to the engine and the list of files, and removes them.

import type { FileEntry } from "../files/kinds";
import type { Session } from "../state/session";

/** Gives a file to the engine and lists it. */
export async function putFile(session: Session, entry: FileEntry, bytes: Uint8Array): Promise<void> {
  await session.engine.put(entry.name, bytes);
  listFiles(session, [entry]);
}

/** Lists files; they replace those of the same names. */
export function listFiles(session: Session, entries: readonly FileEntry[]): void {
  const names = new Set(entries.map(({ name }) => name));
  session.files.set([...session.files.value.filter(({ name }) => !names.has(name)), ...entries]);
}

/** Removes files from the engine and the list. */
export async function removeFiles(session: Session, names: readonly string[]): Promise<void> {
  for (const name of names) await session.engine.remove(name);
  session.files.set(session.files.value.filter(({ name }) => !names.includes(name)));
}
