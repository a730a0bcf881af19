// Files of a name that is here already: nothing that is open is lost or broken by them.

import { failureOf } from "../engine/failure";
import type { Failure } from "../engine/types";
import type { FileEntry } from "../files/kinds";
import type { Read } from "../files/read";
import { QUESTIONS } from "../forms/all";
import { answered } from "../state/answers";
import { fileOf, type OpenModel, uses } from "../state/model";
import type { Session } from "../state/session";
import { putFile } from "./put";

/** What to do with files that were read. */
export interface Sorted {
  taken: Read[];
  /** Models that are open with the same bytes. */
  same: OpenModel[];
  /** Why others cannot be taken. */
  refused: Failure[];
}

/** A file as it was before another one of its name came. */
interface Old {
  entry: FileEntry;
  bytes: Uint8Array;
}

/** Which files can be taken. Those that are results here, or have led to results, stay as they are. */
export async function sortFiles(session: Session, files: readonly Read[]): Promise<Sorted> {
  const sorted: Sorted = { taken: [], same: [], refused: [] };
  for (const file of files) {
    const open = session.models.value.find(({ origin }) => origin === file.name);
    const why = refusal(session, file.name);
    if (open && (await isSame(session, file))) sorted.same.push(open);
    else if (why) sorted.refused.push({ code: "name-taken", message: why, needs_answer: false, fields: [] });
    else sorted.taken.push(file);
  }
  return sorted;
}

function refusal(session: Session, name: string): string | undefined {
  const models = session.models.value;
  const maker = models.find(({ steps }) => steps.some(({ names }) => names.includes(name)));
  if (maker) return `${name} is the result of a change here: close ${fileOf(maker)} first, or give the file another name`;
  const changed = models.find(({ origin, steps }) => origin === name && steps.length > 0);
  return changed && `${name} is open with changes that were kept: close it first, or give the file another name`;
}

async function isSame(session: Session, { name, bytes }: Read): Promise<boolean> {
  const there = await session.engine.bytes(name);
  return there?.length === bytes.length && there.every((byte, index) => byte === bytes[index]);
}

/** The files that these replace, where an open model uses them. */
export async function oldOnes(session: Session, files: readonly Read[]): Promise<Map<string, Old>> {
  const old = new Map<string, Old>();
  for (const { name } of files) {
    const entry = session.files.value.find((file) => file.name === name);
    if (!entry || !session.models.value.some((model) => model.inspected && uses(model, name))) continue;
    const bytes = await session.engine.bytes(name);
    if (bytes) old.set(name, { entry, bytes });
  }
  return old;
}

/** Puts files back where a model cannot be read any more with the new ones; gives what went wrong, by model. */
export async function putBack(session: Session, old: Map<string, Old>): Promise<Map<number, Failure>> {
  const failures = new Map<number, Failure>();
  for (const model of session.models.value) {
    const used = [...old].filter(([name]) => model.inspected && uses(model, name));
    const failure = used.length > 0 ? await triedWith(session, model) : undefined;
    if (!failure || failure.needs_answer) continue;
    for (const [name, { entry, bytes }] of used) {
      await putFile(session, entry, bytes);
      old.delete(name);
    }
    const kept = { ...failure, message: `the new file was not taken, and the one before stays open: ${failure.message}` };
    failures.set(model.id, kept);
    session.update(model.id, (open) => ({ ...open, failure: kept }));
  }
  return failures;
}

async function triedWith(session: Session, model: OpenModel): Promise<Failure | undefined> {
  try {
    await session.engine.inspect(fileOf(model), answered(model, QUESTIONS), []);
    return undefined;
  } catch (error) {
    return failureOf(error);
  }
}
