// Loads the presets of the engine and of the user's files.

import { toFailure } from "../engine/failure";
import type { Failure } from "../engine/types";
import type { PresetEntry, Session } from "../state/session";

/** Loads all presets again; returns the failures of files that cannot be read. */
export async function refreshPresets(session: Session): Promise<Failure[]> {
  const failures: Failure[] = [];
  const files = session.files.value.filter(({ kind }) => kind === "presets").map(({ name }) => name);
  const load = (file?: string) => loadPresets(session, file).catch((error) => (failures.push(withPlace(toFailure(error))), []));
  const loaded = (await Promise.all([load(), ...files.map(load)])).flat();
  // A file of presets has the built-in ones, too.
  const unique = loaded.filter(({ name }, index) => loaded.findIndex((other) => other.name === name) === index);
  session.presets.set(unique);
  return failures;
}

async function loadPresets(session: Session, file: string | undefined): Promise<PresetEntry[]> {
  const presets = await session.engine.presets(file === undefined ? {} : { presets: file });
  return presets.map(({ name }) => (file === undefined ? { name } : { name, file }));
}

/** A failure whose message begins with its place, because it is shown on one line, without an excerpt of the file. */
function withPlace(failure: Failure): Failure {
  const place = [failure.model, failure.line, failure.column].filter((part) => part != null).join(":");
  return place === "" || failure.message.startsWith(place) ? failure : { ...failure, message: `${place}: ${failure.message}` };
}
