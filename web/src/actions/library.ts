// The same change for all models that are open.

import { failureOf } from "../engine/failure";
import type { Change, Request } from "../engine/types";
import { counted, digits } from "../dom/number";
import { numberIn } from "../forms/check";
import { formOf } from "../forms/all";
import { isEmpty, requestOf } from "../forms/request";
import { save } from "../download/save";
import { answered } from "../state/answers";
import { fileOf, type OpenModel, type Outcome } from "../state/model";
import type { Session } from "../state/session";
import { countsOf } from "./apply";

/** The request of the form for one of several models, with its own target mass. */
export function requestOfRow(session: Session, model: OpenModel): Request | undefined {
  const form = formOf(session.verb.value);
  if (!form) return undefined;
  const own = numberIn(model.targetMass);
  const takesMass = form.fields.some(({ name }) => name === "target_mass");
  const request = requestOf(form, session.values, fileOf(model), answered(model, form));
  return takesMass && own !== undefined ? { ...request, target_mass: own } : request;
}

/** Whether the form says something that can be done to all. */
export function canChangeAll(session: Session): boolean {
  const form = formOf(session.verb.value);
  // One that is still being opened would be left out without a word.
  if (session.models.value.some(({ look, failure }) => !look && !failure)) return false;
  const owns = session.models.value.some(({ targetMass }) => targetMass !== "");
  return form !== undefined && (!isEmpty(form, session.values) || (form.verb === "rescale" && owns) || form.verb === "remove");
}

/** Does the change to each model, and shows in its row what it does. */
export async function changeAll(session: Session): Promise<void> {
  await eachRow(session, (request) => session.engine.change(request, ["changes"]));
  const { done, failed } = tally(session);
  session.announce(`${done} of ${done + failed} models changed${failed > 0 ? `, ${failed} failed` : ""}.`);
}

/** Does the change to each model and saves the results in one archive; models that fail are not in it. */
export async function downloadAll(session: Session): Promise<void> {
  await session.engine.zipBegin();
  await eachRow(session, (request) => session.engine.zipAdd(request));
  const { done, failed } = tally(session);
  const bytes = await session.engine.zipEnd();
  if (done > 0) save("models.zip", bytes, "application/zip");
  const without = failed > 0 ? `; ${failed} failed and are not in it` : "";
  const made = `models.zip has the results of ${counted(done, "model")}${without}.`;
  session.announce(done > 0 ? made : "No model could be changed; there is no archive.");
}

async function eachRow(session: Session, ask: (request: Request) => Promise<Change>): Promise<void> {
  for (const model of session.models.value) {
    const request = requestOfRow(session, model);
    if (!request) continue;
    const outcome = model.look ? await outcomeOf(ask(request)) : null;
    session.update(model.id, (open) => ({ ...open, outcome: outcome ?? failedToOpen(open) }));
  }
}

function failedToOpen({ failure }: OpenModel): Outcome | null {
  return failure && { state: "failed", failure };
}

async function outcomeOf(asked: Promise<Change>): Promise<Outcome> {
  try {
    const change = await asked;
    if (change.unchanged) return { state: "same", text: "nothing to change" };
    return { state: "done", text: shortly(change) };
  } catch (error) {
    return { state: "failed", failure: failureOf(error) };
  }
}

/** The factor of the stiffness, where there is one. */
function shortly(change: Change): string {
  const factors = new Set(change.record.changes.filter(({ property }) => property === "stiffness").map(({ factor }) => factor));
  const [factor] = factors;
  return factors.size === 1 && typeof factor === "number" ? `stiffness ×${digits(factor)}` : countsOf(change, "would");
}

function tally(session: Session): { done: number; failed: number } {
  const states = session.models.value.map(({ outcome }) => outcome?.state);
  const failed = states.filter((state) => state === "failed").length;
  return { done: states.filter((state) => state === "done" || state === "same").length, failed };
}
