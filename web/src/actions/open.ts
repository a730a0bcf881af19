// Opens files: hands them to the engine, and inspects the models among them.

import type { Failure } from "../engine/types";
import { counted } from "../dom/number";
import { isUseful } from "../files/kinds";
import { type Given, read, type Read } from "../files/read";
import { unzipped } from "../files/unzip";
import { newModel, type OpenModel, uses } from "../state/model";
import type { Session } from "../state/session";
import { inspect, inspectAgain } from "./inspect";
import { refreshPresets } from "./presets";
import { putFile } from "./put";
import { oldOnes, putBack, type Sorted, sortFiles } from "./replace";

/** What to do with models: open them, or keep them for others that need them. */
type Models = "open" | "at hand";

/** Opens what was dropped or chosen. */
export async function openFiles(session: Session, given: readonly Given[], models: Models = "open"): Promise<void> {
  if (given.length === 0) return;
  performance.mark("open");
  const all = await unzipped(given);
  const useful = all.filter(({ name }) => isUseful(name));
  await openRead(session, await Promise.all(useful.map(read)), { models, leftOut: all.length - useful.length });
}

// One after the other: what comes next has to know what is open by then.
let turn: Promise<void> = Promise.resolve();

/** Opens files that were read. */
export function openRead(session: Session, files: readonly Read[], how: { models?: Models; leftOut?: number } = {}): Promise<void> {
  const done = turn.then(() => openInTurn(session, files, how));
  turn = done.catch(() => undefined);
  return done;
}

async function openInTurn(
  session: Session, files: readonly Read[], { models = "open", leftOut = 0 }: { models?: Models; leftOut?: number },
): Promise<void> {
  const sorted = await sortFiles(session, files);
  const { taken } = sorted;
  const old = await oldOnes(session, taken);
  const replaced = new Set(old.keys());
  for (const { bytes, ...entry } of taken) await putFile(session, { ...entry, bytes: bytes.length }, bytes);
  const failures = await putBack(session, old);
  // What was put back is not there any more in `old`, and is open as before.
  const names = models === "open" ? (await modelsAmong(session, taken)).filter((name) => !replaced.has(name) || old.has(name)) : [];
  const opened: number[] = [];
  for (const name of names) opened.push(await openModel(session, name));
  const [first] = sorted.same;
  if (first && opened.length === 0) session.chosen.set(first.id);
  const bad = taken.some(({ kind }) => kind === "presets") ? await refreshPresets(session) : [];
  // Bones are drawn of meshes that are here, though a model does not name those that it lacks.
  const all = taken.some(({ kind }) => kind === "mesh") || (opened.length === 0 && taken.length > 0);
  const touched = (model: OpenModel) => all || !model.inspected || taken.some(({ name }) => uses(model, name));
  await inspectAgain(session, session.models.value.filter((model) => touched(model) && !opened.includes(model.id) && !failures.has(model.id)));
  session.announce(summary(session, sorted, opened, [...failures.values(), ...bad], leftOut));
}

/** Models, and a force set where it comes without one and none that is open includes it. */
async function modelsAmong(session: Session, files: readonly Read[]): Promise<string[]> {
  const named = (kind: string) => files.filter((file) => file.kind === kind).map(({ name }) => name);
  const [models, forces] = [named("model"), named("forces")];
  if (models.length > 0 || forces.length === 0) return models;
  // One may have lacked just this file.
  await inspectAgain(session, session.models.value.filter(({ inspected }) => !inspected));
  return forces.filter((name) => !session.models.value.some((model) => model.origin !== name && uses(model, name)));
}

/** Opens one model, in the place of one that was read from a file of this name. */
async function openModel(session: Session, name: string): Promise<number> {
  const before = session.models.value.find(({ origin }) => origin === name);
  if (!before) return openAsModel(session, name, session.model()?.inspected == null);
  const { id, answers, targetMass } = before;
  session.update(id, () => ({ ...newModel(name), id, answers, targetMass }));
  if (session.model()?.inspected == null) session.chosen.set(id);
  await inspect(session, id);
  return id;
}

/** Opens a file that is there already as a model: a force set, say. */
export async function openAsModel(session: Session, name: string, choose = true): Promise<number> {
  const model = newModel(name);
  session.add(model);
  if (choose) session.chosen.set(model.id);
  await inspect(session, model.id);
  return model.id;
}

/** What happened, in a sentence. */
function summary(
  session: Session, { taken, same, refused }: Sorted, opened: readonly number[], notTaken: readonly Failure[], leftOut: number,
): string {
  const failures = opened.flatMap((id) => session.modelOf(id)?.failure ?? []);
  const messages = (all: readonly Failure[]) => all.map(({ message }) => message).join("; ");
  const good = opened.length - failures.length;
  const others = [...refused, ...notTaken];
  const parts = [
    good > 0 && `${counted(good, "model")} opened`,
    opened.length === 0 && taken.length > notTaken.length && `${counted(taken.length - notTaken.length, "file")} added`,
    failures.length > 0 && `${counted(failures.length, "model")} could not be opened: ${messages(failures)}`,
    same.length > 0 && `open already: ${same.map(({ origin }) => origin).join(", ")}`,
    others.length > 0 && `${counted(others.length, "file")} not taken: ${messages(others)}`,
    leftOut > 0 && `${counted(leftOut, "file")} left out: the page has no use for files of these kinds`,
  ].filter((part) => part !== false);
  const text = parts.join("; ");
  return text === "" ? "" : `${text.charAt(0).toUpperCase()}${text.slice(1)}.`;
}
