// Applies a change to a model as a step that can be undone.

import { toFailure } from "../engine/failure";
import type { Change, Failure, Request } from "../engine/types";
import { counted } from "../dom/number";
import type { FileEntry, FileKind } from "../files/kinds";
import { findForm } from "../forms/all";
import { answersFor } from "../state/answers";
import { atStep, currentFile, type OpenModel, withStep } from "../state/model";
import type { Session } from "../state/session";
import { inspect } from "./inspect";
import { removeFiles, listFiles } from "./file_list";

const KEPT_SECTIONS = ["changes"];

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
  const { change, next } = await session.engine.keep(fullRequest, KEPT_SECTIONS);
  listFiles(session, resultFiles(change));
  session.remember(change.explained);
  const result = { name: next.model, names: next.names, request: fullRequest, sections: change.sections };
  const step = { ...result, text: text.replace(/\.$/, ""), counts: changeCounts(change, "did") };
  for (const name of next.names) session.saved.delete(name);
  session.update(model.id, (open) => withStep(open, step));
  session.announce(`Done: ${step.text}. ${step.counts}.`);
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

type Tense = "would" | "did";

/** How many numbers and objects change, as a text. */
export function changeCounts({ record, unchanged }: Change, tense: Tense): string {
  if (unchanged) return "Nothing to change";
  const [change, are] = tense === "did" ? ["changed", ""] : ["change", "are "];
  const objects = [...new Set(record.objects.map((object) => object.change))].map((kind) => {
    const count = record.objects.filter((object) => object.change === kind).length;
    return `${counted(count, "object")} ${are}${kind}`;
  });
  const numbers = new Set(record.changes.map(({ property }) => property));
  const properties = counted(numbers.size, "property", "properties");
  const changes = record.changes.length > 0 ? [`${counted(record.changes.length, "number")} of ${properties} ${change}`] : [];
  const text = [...changes, ...objects].join(", ");
  return text === "" ? `Only the note about the contacts ${tense === "did" ? "changed" : "changes"}` : text;
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
