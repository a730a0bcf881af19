// Opens files: gives them to the engine, and inspects the models among them.

import type { Failure } from "../engine/types";
import { counted } from "../dom/number";
import { isUseful, KIND_TEXTS } from "../files/kinds";
import { type GivenFile, readFile, type ReadFile } from "../files/read";
import { expandArchives } from "../files/unzip";
import { lacksContacts, newModel, type OpenModel, uses } from "../state/model";
import type { Session } from "../state/session";
import { findOriginal, inspect, inspectAgain } from "./inspect";
import { refreshPresets } from "./presets";
import { putFile } from "./file_list";
import { replacedFiles, restoreFiles, type SortedFiles, sortFiles } from "./replace";

/** Most failures whose messages are said at once. */
const MOST_SAID = 3;

/** What to do with models: open them, or only keep their files for other models. */
type Models = "open" | "keep";

/** Opens files that were dropped or chosen. */
export async function openFiles(session: Session, files: readonly GivenFile[], models: Models = "open"): Promise<void> {
  if (files.length === 0) return;
  performance.mark("open");
  const all = await expandArchives(files);
  const useful = all.filter(({ name }) => isUseful(name));
  await openRead(session, await Promise.all(useful.map(readFile)), { models, leftOut: all.length - useful.length });
}

// Files are opened one group after the other, because each group depends on what is open.
let queue: Promise<void> = Promise.resolve();

/** Opens files whose bytes were read. */
export function openRead(session: Session, files: readonly ReadFile[], options: { models?: Models; leftOut?: number } = {}): Promise<void> {
  const done = queue.then(() => openNow(session, files, options));
  queue = done.catch(() => undefined);
  return done;
}

async function openNow(
  session: Session, files: readonly ReadFile[], { models = "open", leftOut = 0 }: { models?: Models; leftOut?: number },
): Promise<void> {
  const sorted = await sortFiles(session, files);
  const { accepted } = sorted;
  const old = await replacedFiles(session, accepted);
  const replaced = new Set(old.keys());
  for (const { bytes, ...entry } of accepted) await putFile(session, { ...entry, bytes: bytes.length }, bytes);
  const failures = await restoreFiles(session, old);
  // `restoreFiles` removes from `old` the files that it restored; their models are open as before.
  const names = models === "open" ? (await modelsToOpen(session, accepted)).filter((name) => !replaced.has(name) || old.has(name)) : [];
  const opened: number[] = [];
  for (const name of names) opened.push(await openModel(session, name));
  for (const id of opened.length > 1 ? opened.slice(0, 2) : []) {
    const original = await findOriginal(session, id);
    // Of a model and its original, the scaled one is the one to work on.
    if (original !== undefined && opened.length === 2) session.chosen.set(id);
  }
  showFormFor(session, opened);
  const [first] = sorted.alreadyOpen;
  if (first && opened.length === 0) session.chosen.set(first.id);
  const presetFailures = accepted.some(({ kind }) => kind === "presets") ? await refreshPresets(session) : [];
  // A mesh may belong to any model: an inspection does not list missing meshes.
  const all = accepted.some(({ kind }) => kind === "mesh") || (opened.length === 0 && accepted.length > 0);
  const isAffected = (model: OpenModel) => all || !model.inspected || accepted.some(({ name }) => uses(model, name));
  await inspectAgain(session, session.models.value.filter((model) => isAffected(model) && !opened.includes(model.id) && !failures.has(model.id)));
  session.announce(openedText(session, sorted, opened, [...failures.values(), ...presetFailures], leftOut));
}

/** A single model without contacts is given some first; the next model with contacts has the usual form again. */
function showFormFor(session: Session, opened: readonly number[]): void {
  const [model, ...others] = session.models.value;
  if (!model?.inspected || others.length > 0 || !opened.includes(model.id) || session.values.all().size > 0) return;
  const [from, to] = lacksContacts(model.inspected) ? ["rescale", "add"] : ["add", "rescale"];
  if (session.verb.value === from) session.setVerb(to);
}

/** The models among files; without models, force sets that no open model includes. */
async function modelsToOpen(session: Session, files: readonly ReadFile[]): Promise<string[]> {
  const namesOf = (kind: string) => files.filter((file) => file.kind === kind).map(({ name }) => name);
  const [models, forces] = [namesOf("model"), namesOf("forces")];
  if (models.length > 0 || forces.length === 0) return models;
  // A model that could not be read may have lacked this file.
  await inspectAgain(session, session.models.value.filter(({ inspected }) => !inspected));
  return forces.filter((name) => !session.models.value.some((model) => model.origin !== name && uses(model, name)));
}

/** Opens one model. It replaces an open model that was read from a file of this name. */
async function openModel(session: Session, name: string): Promise<number> {
  const before = session.models.value.find(({ origin }) => origin === name);
  if (!before) return openAsModel(session, name, session.model()?.inspected == null);
  const { id, answers, targetMass, seen } = before;
  seen.clear();
  session.update(id, () => ({ ...newModel(name), id, answers, targetMass, seen }));
  if (session.model()?.inspected == null) session.chosen.set(id);
  await inspect(session, id);
  return id;
}

/** Opens a file that the page has already, such as a force set, as a model. */
export async function openAsModel(session: Session, name: string, choose = true): Promise<number> {
  const model = newModel(name);
  session.add(model);
  if (choose) session.chosen.set(model.id);
  await inspect(session, model.id);
  return model.id;
}

/** A sentence about the files that were opened and refused. */
function openedText(
  session: Session, { accepted, alreadyOpen, refused }: SortedFiles, opened: readonly number[], notAccepted: readonly Failure[], leftOut: number,
): string {
  const failures = opened.flatMap((id) => session.findModel(id)?.failure ?? []);
  const openedCount = opened.length - failures.length;
  const rejected = [...refused, ...notAccepted];
  const parts = [
    openedCount > 0 && `${counted(openedCount, "model")} opened`,
    opened.length === 0 && accepted.length > notAccepted.length && addedText(session, accepted, accepted.length - notAccepted.length),
    failures.length > 0 && `${counted(failures.length, "model")} could not be opened: ${failures.length > 1 ? "their rows say why" : messages(failures)}`,
    alreadyOpen.length > 0 && `open already: ${alreadyOpen.map(({ origin }) => origin).join(", ")}`,
    rejected.length > 0 && `${counted(rejected.length, "file")} not taken: ${messages(rejected)}`,
    leftOut > 0 && `${counted(leftOut, "file")} left out: the page has no use for files of these kinds`,
  ].filter((part) => part !== false);
  const text = parts.join("; ");
  return text === "" ? "" : `${text.charAt(0).toUpperCase()}${text.slice(1)}.`;
}

/** "1 file added (motion): now open its model": a file that is no model shows nothing by itself. */
function addedText(session: Session, accepted: readonly ReadFile[], count: number): string {
  const [file, ...others] = accepted;
  const kind = file && others.length === 0 ? ` (${KIND_TEXTS[file.kind]})` : "";
  return `${counted(count, "file")} added${kind}${session.models.value.length === 0 ? ": now open the model" : ""}`;
}

/** The messages of failures. Only the first are said, because the line covers what is under it. */
function messages(failures: readonly Failure[]): string {
  const all = [...new Set(failures.map(({ message }) => message))];
  const more = all.length > MOST_SAID ? [`and ${all.length - MOST_SAID} more`] : [];
  return [...all.slice(0, MOST_SAID), ...more].join("; ");
}
