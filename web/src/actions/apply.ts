// Applies a change: its result becomes the model, as one more step that can be undone.

import { failureOf } from "../engine/failure";
import type { Change, Failure, Request } from "../engine/types";
import { counted } from "../dom/number";
import type { FileEntry, FileKind } from "../files/kinds";
import { formOf } from "../forms/all";
import { answered } from "../state/answers";
import { atStep, fileOf, type OpenModel, withStep } from "../state/model";
import type { Session } from "../state/session";
import { look } from "./look";

const SHOWN = ["changes"];

/** Applies `request` to a model; gives what went wrong, if something did. */
export async function apply(session: Session, id: number, text: string, request: Request): Promise<Failure | undefined> {
  const model = session.models.value.find((one) => one.id === id);
  if (!model) return undefined;
  const asked = { ...answered(model, formOf(request.verb)), ...request, models: [fileOf(model)] };
  try {
    const { change, next } = await session.engine.keep(asked, SHOWN);
    if (change.unchanged) return saysNothing(text);
    addFiles(session, change);
    session.remember(change.explained);
    const made = { name: next.model, names: next.names, request: asked, sections: change.sections };
    const step = { ...made, text: text.replace(/\.$/, ""), counts: countsOf(change, "did") };
    session.update(id, (open) => withStep(open, step));
    session.announce(`Done: ${step.text}. ${step.counts}.`);
    await look(session, id);
    return undefined;
  } catch (error) {
    return failureOf(error);
  }
}

function saysNothing(text: string): Failure {
  return { code: "unchanged", message: `${text}: nothing to change`, needs_answer: false, fields: [] };
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
function addFiles(session: Session, change: Change): void {
  const names = new Set(change.results.map(({ name }) => name));
  const others = session.files.value.filter(({ name }) => !names.has(name));
  const made = change.results.map(({ name, bytes }, index): FileEntry => ({ name, bytes, kind: kindOfResult(name, index) }));
  session.files.set([...others, ...made]);
}

/** A changed set is a force set, which comes first, or the geometry set that goes with it. */
function kindOfResult(name: string, index: number): FileKind {
  if (name.endsWith(".osim")) return "model";
  return index === 0 ? "forces" : "geometry";
}

/** Goes to the model after `at` of its steps. */
export async function goTo(session: Session, model: OpenModel, at: number): Promise<void> {
  const moved = atStep(model, at);
  if (moved.at === model.at) return;
  const step = model.steps[Math.min(moved.at, model.at)];
  session.update(model.id, () => moved);
  session.announce(`${moved.at < model.at ? "Undone" : "Done again"}: ${step?.text ?? ""}. The model is ${fileOf(moved)} now.`);
  await look(session, model.id);
}

export function undo(session: Session): void {
  const model = session.model();
  if (model) void goTo(session, model, model.at - 1);
}

export function redo(session: Session): void {
  const model = session.model();
  if (model) void goTo(session, model, model.at + 1);
}
