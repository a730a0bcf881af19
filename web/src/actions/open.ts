// Opens files: hands them to the engine, and looks at the models among them.

import { failureOf } from "../engine/failure";
import type { Failure } from "../engine/types";
import { counted } from "../dom/number";
import type { FileEntry } from "../files/kinds";
import { type Given, read, type Read } from "../files/read";
import { newModel } from "../state/model";
import type { KnownPreset, Session } from "../state/session";
import { look, lookAgain } from "./look";

/** Opens what was dropped or chosen. */
export async function openFiles(session: Session, given: readonly Given[]): Promise<void> {
  if (given.length === 0) return;
  performance.mark("open");
  const files = await Promise.all(given.map(read));
  await openRead(session, files);
}

/** Opens files that were read. */
export async function openRead(session: Session, files: readonly Read[]): Promise<void> {
  const models = modelsAmong(files);
  const replaced = await Promise.all(models.map((name) => keepOld(session, name)));
  for (const file of files) await put(session, file);
  const failures: Failure[] = [];
  for (const [index, name] of models.entries()) {
    const failure = await openModel(session, name, replaced[index] ?? null);
    if (failure) failures.push(failure);
  }
  if (models.length === 0) await lookAgain(session);
  if (files.some(({ kind }) => kind === "presets")) void refreshPresets(session);
  announce(session, files, models.length - failures.length, failures);
}

/** Models, and a force set where it comes without one: else it belongs to a model. */
function modelsAmong(files: readonly Read[]): string[] {
  const named = (kind: string) => files.filter((file) => file.kind === kind).map(({ name }) => name);
  const models = named("model");
  return models.length > 0 ? models : named("forces");
}

/** The bytes of a model that is open and is about to be replaced. */
async function keepOld(session: Session, name: string): Promise<Uint8Array | null> {
  return session.models.value.some(({ origin }) => origin === name) ? session.engine.bytes(name) : null;
}

async function put(session: Session, { name, bytes, kind }: Read): Promise<void> {
  const entry: FileEntry = { name, bytes: bytes.length, kind };
  await session.engine.put(name, bytes);
  session.files.set([...session.files.value.filter((file) => file.name !== name), entry]);
}

/** Opens one model; one that cannot be read does not take the place of one that could. */
async function openModel(session: Session, name: string, old: Uint8Array | null): Promise<Failure | undefined> {
  const before = session.models.value.find(({ origin }) => origin === name);
  const model = before ? { ...newModel(name), id: before.id, answers: before.answers } : newModel(name);
  if (!before) session.add(model);
  const failure = before && old ? await tryLook(session, name) : undefined;
  if (before && old && failure && !failure.needs_answer) {
    await session.engine.put(name, old);
    const kept = { ...failure, message: `the new file was not taken, and the one before stays open: ${failure.message}` };
    session.update(model.id, (open) => ({ ...open, failure: kept }));
    return failure;
  }
  if (before) session.update(before.id, () => model);
  if (session.model()?.look == null) session.chosen.set(model.id);
  await look(session, model.id);
  return session.models.value.find(({ id }) => id === model.id)?.failure ?? undefined;
}

async function tryLook(session: Session, name: string): Promise<Failure | undefined> {
  try {
    await session.engine.look(name, {}, []);
    return undefined;
  } catch (error) {
    return failureOf(error);
  }
}

/** Opens a file that is there already as a model: a force set, say. */
export async function openAsModel(session: Session, name: string): Promise<void> {
  const model = newModel(name);
  session.add(model);
  session.chosen.set(model.id);
  await look(session, model.id);
}

/** The presets that the engine has, and those of a file. */
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

function announce(session: Session, files: readonly Read[], opened: number, failures: readonly Failure[]): void {
  const messages = failures.map(({ message }) => message).join("; ");
  const parts = opened > 0 ? [`${counted(opened, "model")} opened`] : failures.length > 0 ? [] : [`${counted(files.length, "file")} added`];
  if (failures.length > 0) parts.push(`${counted(failures.length, "model")} could not be opened: ${messages}`);
  session.announce(`${parts.join(", ")}.`);
}
