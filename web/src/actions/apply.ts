// Applies a change: its result becomes the model, as one more step that can be undone.

import { failureOf } from "../engine/failure";
import type { Change, Failure, Request } from "../engine/types";
import { counted } from "../dom/number";
import type { FileEntry, FileKind } from "../files/kinds";
import { formOf } from "../forms/all";
import { answered } from "../state/answers";
import { atStep, fileOf, type OpenModel, withStep } from "../state/model";
import type { Session } from "../state/session";
import { inspect } from "./inspect";
import { dropFiles, listFiles } from "./put";

const SHOWN = ["changes"];

/** Applies `request` to a model; gives what went wrong, if something did. */
export async function apply(session: Session, id: number, text: string, request: Request): Promise<Failure | undefined> {
  const model = session.modelOf(id);
  if (!model || session.keeping.value) return undefined;
  session.keeping.set(true);
  try {
    return await keep(session, model, text, request);
  } catch (error) {
    return failureOf(error);
  } finally {
    session.keeping.set(false);
  }
}

async function keep(session: Session, model: OpenModel, text: string, request: Request): Promise<Failure | undefined> {
  const asked = { ...answered(model, formOf(request.verb)), ...request, models: [fileOf(model)] };
  const planned = await session.engine.change(asked, []);
  if (planned.unchanged) return refused("unchanged", `${text}: nothing to change`);
  const taken = nameTaken(session, model, planned);
  if (taken) return refused("name-taken", taken);
  const { change, next } = await session.engine.keep(asked, SHOWN);
  listFiles(session, filesOf(change));
  session.remember(change.explained);
  const made = { name: next.model, names: next.names, request: asked, sections: change.sections };
  const step = { ...made, text: text.replace(/\.$/, ""), counts: countsOf(change, "did") };
  for (const name of next.names) session.saved.delete(name);
  session.update(model.id, (open) => withStep(open, step));
  session.announce(`Done: ${step.text}. ${step.counts}.`);
  // Steps that were undone are gone now, and so are their files.
  const undone = model.steps.slice(model.at).flatMap(({ names }) => names);
  await dropFiles(session, undone.filter((name) => !next.names.includes(name)));
  await inspect(session, model.id);
  return undefined;
}

/** Why the results cannot be kept under their names: a file that was given, or a result of another model, would be lost. */
function nameTaken(session: Session, { steps, at }: OpenModel, { results }: Change): string | undefined {
  const undone = new Set(steps.slice(at).flatMap(({ names }) => names));
  const here = new Set(session.files.value.map(({ name }) => name));
  const taken = results.find(({ name }) => here.has(name) && !undone.has(name));
  if (!taken) return undefined;
  return `a file ${taken.name} is open already: close it and remove it from the files, or undo first; the result can also be downloaded`;
}

function refused(code: string, message: string): Failure {
  return { code, message, needs_answer: false, fields: [] };
}

type Tense = "would" | "did";

/** How much changes, in a few words. */
export function countsOf({ record, unchanged }: Change, tense: Tense): string {
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

/** Results are files as any other: another model may take its contacts from them. */
function filesOf({ results }: Change): FileEntry[] {
  return results.map(({ name, bytes }, index) => ({ name, bytes, kind: kindOfResult(name, index) }));
}

/** A changed set is a force set, which comes first, or the geometry set that goes with it. */
function kindOfResult(name: string, index: number): FileKind {
  if (name.endsWith(".osim")) return "model";
  return index === 0 ? "forces" : "geometry";
}

/** Goes to the model after `at` of its steps. */
export async function goTo(session: Session, id: number, at: number): Promise<void> {
  const model = session.modelOf(id);
  if (!model || session.keeping.value) return;
  const moved = atStep(model, at);
  if (moved.at === model.at) return;
  const step = model.steps[Math.min(moved.at, model.at)];
  session.update(id, () => moved);
  session.announce(`${moved.at < model.at ? "Undone" : "Done again"}: ${step?.text ?? ""}. The model is ${fileOf(moved)} now.`);
  await inspect(session, id);
}

export function undo(session: Session): void {
  const model = session.model();
  if (model) void goTo(session, model.id, model.at - 1);
}

export function redo(session: Session): void {
  const model = session.model();
  if (model) void goTo(session, model.id, model.at + 1);
}
