// Handles files whose names are open already, so that no open model is lost or broken.

import { toFailure } from "../engine/failure";
import type { Failure } from "../engine/types";
import type { FileEntry } from "../files/kinds";
import type { ReadFile } from "../files/read";
import { QUESTIONS } from "../forms/all";
import { answersFor } from "../state/answers";
import { currentFile, type OpenModel, uses } from "../state/model";
import type { Session } from "../state/session";
import { putFile } from "./file_list";

/** Files that were read, sorted by what to do with them. */
export interface SortedFiles {
  accepted: ReadFile[];
  /** Open models that have the same bytes. */
  alreadyOpen: OpenModel[];
  /** Why the other files are refused. */
  refused: Failure[];
}

/** A file before another file of its name replaced it. */
interface OldFile {
  entry: FileEntry;
  bytes: Uint8Array;
}

/** Sorts files. Results of this page, and models with steps, cannot be replaced. */
export async function sortFiles(session: Session, files: readonly ReadFile[]): Promise<SortedFiles> {
  const sorted: SortedFiles = { accepted: [], alreadyOpen: [], refused: [] };
  for (const file of files) {
    const open = session.models.value.find(({ origin }) => origin === file.name);
    const reason = refusalOfFile(session, file.name);
    if (open && (await hasSameBytes(session, file))) sorted.alreadyOpen.push(open);
    else if (reason) sorted.refused.push({ code: "name-taken", message: reason, needs_answer: false, fields: [] });
    else sorted.accepted.push(file);
  }
  return sorted;
}

function refusalOfFile(session: Session, name: string): string | undefined {
  const models = session.models.value;
  const owner = models.find(({ steps }) => steps.some(({ names }) => names.includes(name)));
  if (owner) return `${name} is the result of a change here: close ${currentFile(owner)} first, or give the file another name`;
  const changed = models.find(({ origin, steps }) => origin === name && steps.length > 0);
  return changed && `${name} is open with changes that were kept: close it first, or give the file another name`;
}

async function hasSameBytes(session: Session, { name, bytes }: ReadFile): Promise<boolean> {
  const existing = await session.engine.bytes(name);
  return existing?.length === bytes.length && existing.every((byte, index) => byte === bytes[index]);
}

/** The files of open models that these files replace. */
export async function replacedFiles(session: Session, files: readonly ReadFile[]): Promise<Map<string, OldFile>> {
  const old = new Map<string, OldFile>();
  for (const { name } of files) {
    const entry = session.files.value.find((file) => file.name === name);
    if (!entry || !session.models.value.some((model) => model.inspected && uses(model, name))) continue;
    const bytes = await session.engine.bytes(name);
    if (bytes) old.set(name, { entry, bytes });
  }
  return old;
}

/** Restores the old files of models that cannot be read with the new ones; returns the failures by model. */
export async function restoreFiles(session: Session, old: Map<string, OldFile>): Promise<Map<number, Failure>> {
  const failures = new Map<number, Failure>();
  for (const model of session.models.value) {
    const used = [...old].filter(([name]) => model.inspected && uses(model, name));
    const failure = used.length > 0 ? await inspectFailure(session, model) : undefined;
    if (!failure || failure.needs_answer) continue;
    for (const [name, { entry, bytes }] of used) {
      await putFile(session, entry, bytes);
      old.delete(name);
    }
    const explained = { ...failure, message: `the new file was not taken, and the one before stays open: ${failure.message}` };
    failures.set(model.id, explained);
    session.update(model.id, (open) => ({ ...open, failure: explained }));
  }
  return failures;
}

async function inspectFailure(session: Session, model: OpenModel): Promise<Failure | undefined> {
  try {
    await session.engine.inspect(currentFile(model), answersFor(model, QUESTIONS), []);
    return undefined;
  } catch (error) {
    return toFailure(error);
  }
}
