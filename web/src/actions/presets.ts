// Presets: those that the engine has, and those of the user's files.

import { failureOf } from "../engine/failure";
import type { Failure } from "../engine/types";
import type { KnownPreset, Session } from "../state/session";

/** Asks for them again; gives why those of a file cannot be had. */
export async function refreshPresets(session: Session): Promise<Failure[]> {
  const failures: Failure[] = [];
  const own = session.files.value.filter(({ kind }) => kind === "presets").map(({ name }) => name);
  const of = (file?: string) => presetsOf(session, file).catch((error) => (failures.push(located(failureOf(error))), []));
  const found = (await Promise.all([of(), ...own.map(of)])).flat();
  // A file of presets has the built-in ones, too.
  const first = found.filter(({ name }, index) => found.findIndex((other) => other.name === name) === index);
  session.presets.set(first);
  return failures;
}

async function presetsOf(session: Session, file: string | undefined): Promise<KnownPreset[]> {
  const found = await session.engine.presets(file === undefined ? {} : { presets: file });
  return found.map(({ name }) => (file === undefined ? { name } : { name, file }));
}

/** The place in front: these messages are on one line, without the box that shows the file. */
function located(failure: Failure): Failure {
  const place = [failure.model, failure.line, failure.column].filter((part) => part != null).join(":");
  return place === "" || failure.message.startsWith(place) ? failure : { ...failure, message: `${place}: ${failure.message}` };
}
