// Files come to the engine, and go.

import type { FileEntry } from "../files/kinds";
import type { Session } from "../state/session";

/** Gives a file to the engine, and puts it into the list. */
export async function putFile(session: Session, entry: FileEntry, bytes: Uint8Array): Promise<void> {
  await session.engine.put(entry.name, bytes);
  listFiles(session, [entry]);
}

/** Puts files into the list, in the place of those of the same names. */
export function listFiles(session: Session, entries: readonly FileEntry[]): void {
  const names = new Set(entries.map(({ name }) => name));
  session.files.set([...session.files.value.filter(({ name }) => !names.has(name)), ...entries]);
}

/** Takes files away. */
export async function dropFiles(session: Session, names: readonly string[]): Promise<void> {
  for (const name of names) await session.engine.remove(name);
  session.files.set(session.files.value.filter(({ name }) => !names.includes(name)));
}
