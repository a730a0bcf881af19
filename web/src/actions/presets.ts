// Presets: those that the engine has, and those of the user's files.

import type { KnownPreset, Session } from "../state/session";

/** Asks for them again. */
export async function refreshPresets(session: Session): Promise<void> {
  const own = session.files.value.filter(({ kind }) => kind === "presets").map(({ name }) => name);
  const asked = [undefined, ...own].map((file) => presetsOf(session, file));
  const found = (await Promise.all(asked)).flat();
  // A file of presets has the built-in ones, too.
  const first = found.filter(({ name }, index) => found.findIndex((other) => other.name === name) === index);
  session.presets.set(first);
}

async function presetsOf(session: Session, file: string | undefined): Promise<KnownPreset[]> {
  const found = await session.engine.presets(file === undefined ? {} : { presets: file }).catch(() => []);
  return found.map(({ name }) => (file === undefined ? { name } : { name, file }));
}
