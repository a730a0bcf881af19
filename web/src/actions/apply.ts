// Applies a change to a model as a step that can be undone.

import { toFailure } from "../engine/failure";
import type { Change, Failure, Request } from "../engine/types";
import { counted, digits } from "../dom/number";
import type { FileEntry, FileKind } from "../files/kinds";
import { findForm } from "../forms/all";
import { answersFor } from "../state/answers";
import { atStep, currentFile, type OpenModel, withStep } from "../state/model";
import type { Session } from "../state/session";
import { inspect } from "./inspect";
import { removeFiles, listFiles } from "./file_list";

/** Applies `request` to a model; returns the failure, if there is one. */
export async function apply(session: Session, id: number, text: string, request: Request): Promise<Failure | undefined> {
  const model = session.findModel(id);
  if (!model || session.keeping.value) return undefined;
  session.keeping.set(true);
  try {
    return await keepChange(session, model, text, request);
  } catch (error) {
    return toFailure(error);
  } finally {
    session.keeping.set(false);
  }
}

async function keepChange(session: Session, model: OpenModel, text: string, request: Request): Promise<Failure | undefined> {
  const fullRequest = { ...answersFor(model, findForm(request.verb)), ...request, models: [currentFile(model)] };
  const planned = await session.engine.change(fullRequest, []);
  if (planned.unchanged) return pageFailure("unchanged", `${text}: nothing to change`);
  const conflict = nameConflict(session, model, planned);
  if (conflict) return pageFailure("name-taken", conflict);
  const { change, next } = await session.engine.keep(fullRequest, []);
  listFiles(session, resultFiles(change));
  session.remember(change.explained);
  const step = { name: next.model, names: next.names, text: text.replace(/\.$/, "") };
  for (const name of next.names) session.saved.delete(name);
  session.update(model.id, (open) => withStep(open, step));
  session.announce(`Done: ${step.text}.`);
  // The new step replaces steps that were undone; their files are removed.
  const undone = model.steps.slice(model.stepCount).flatMap(({ names }) => names);
  await removeFiles(session, undone.filter((name) => !next.names.includes(name)));
  await inspect(session, model.id);
  return undefined;
}

/** Why the results cannot be stored under their names: they would replace a file of the user or the result of another model. */
function nameConflict(session: Session, { steps, stepCount }: OpenModel, { results }: Change): string | undefined {
  const undone = new Set(steps.slice(stepCount).flatMap(({ names }) => names));
  const openNames = new Set(session.files.value.map(({ name }) => name));
  const conflict = results.find(({ name }) => openNames.has(name) && !undone.has(name));
  if (!conflict) return undefined;
  return `a file ${conflict.name} is open already: close it and remove it from the files, or undo first; the result can also be downloaded`;
}

function pageFailure(code: string, message: string): Failure {
  return { code, message, needs_answer: false, fields: [] };
}

/** Properties that are said by name; the others are counted, if there are more than these. */
const NAMED_PROPERTIES = ["radius", "stiffness", "dissipation"];

/** Classes that have a common word. */
const WORDS: Readonly<Record<string, string>> = { ContactHalfSpace: "floor", ContactSphere: "sphere" };

/** What a change does, as a sentence: "12 spheres move; radius ×1.09, stiffness ×1.09 and 2 other properties change." */
export function changeText({ record: { objects, changes: all }, unchanged }: Change): string {
  if (unchanged) return "Nothing to change.";
  // The numbers of an object that is added do not change.
  const added = new Set(objects.map(({ path }) => path));
  const changes = all.filter(({ path }) => !added.has(path));
  const kinds = [...new Set(objects.map(({ change, class: kind }) => `${change} ${kind}`))].map((key) => {
    const [change = "", kind = ""] = key.split(" ");
    const count = objects.filter((one) => one.change === change && one.class === kind).length;
    return kind in WORDS ? `${counted(count, WORDS[kind] ?? "")} ${change}` : `${count} × ${kind} ${change}`;
  });
  const moved = changes.filter(({ property }) => property === "location").length;
  const properties = [...new Set(changes.map(({ property }) => property))].filter((property) => property !== "location");
  const isNamed = (property: string) => properties.length <= NAMED_PROPERTIES.length || NAMED_PROPERTIES.includes(property);
  const named = properties.filter(isNamed).map((property) => {
    const factors = new Set(changes.filter((one) => one.property === property).map(({ factor }) => factor));
    const [factor] = factors;
    return factors.size === 1 && typeof factor === "number" ? `${property} ×${digits(factor)}` : property;
  });
  const others = properties.length - named.length;
  const texts = [...named, ...(others > 0 ? [counted(others, named.length > 0 ? "other property" : "property", named.length > 0 ? "other properties" : "properties")] : [])];
  const last = texts.pop();
  const list = last === undefined ? [] : [`${texts.length > 0 ? `${texts.join(", ")} and ` : ""}${last} ${properties.length === 1 ? "changes" : "change"}`];
  const parts = [...kinds, ...(moved > 0 ? [counted(moved, "sphere moves", "spheres move")] : []), ...list];
  return parts.length === 0 ? "Only the note about the contacts changes." : `${parts.join("; ")}.`;
}

/** The results of a change as files: other models may take their contacts from them. */
function resultFiles({ results }: Change): FileEntry[] {
  return results.map(({ name, bytes }, index) => ({ name, bytes, kind: kindOfResult(name, index) }));
}

/** The kind of a result. A changed force set comes first, its geometry set second. */
function kindOfResult(name: string, index: number): FileKind {
  if (name.endsWith(".osim")) return "model";
  return index === 0 ? "forces" : "geometry";
}

/** Shows the model after its first `at` steps. */
export async function goTo(session: Session, id: number, stepCount: number): Promise<void> {
  const model = session.findModel(id);
  if (!model || session.keeping.value) return;
  const target = atStep(model, stepCount);
  if (target.stepCount === model.stepCount) return;
  const step = model.steps[Math.min(target.stepCount, model.stepCount)];
  session.update(id, () => target);
  session.announce(`${target.stepCount < model.stepCount ? "Undone" : "Done again"}: ${step?.text ?? ""}. The model is ${currentFile(target)} now.`);
  await inspect(session, id);
}

export function undo(session: Session): void {
  const model = session.model();
  if (model) void goTo(session, model.id, model.stepCount - 1);
}

export function redo(session: Session): void {
  const model = session.model();
  if (model) void goTo(session, model.id, model.stepCount + 1);
}
