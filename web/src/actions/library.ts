// The same change for all models that are open.

import { failureOf } from "../engine/failure";
import type { Change, Request } from "../engine/types";
import { counted, digits } from "../dom/number";
import { formOf } from "../forms/all";
import { isEmpty, problems } from "../forms/request";
import { save } from "../download/save";
import type { OpenModel, Outcome } from "../state/model";
import type { Session } from "../state/session";
import { countsOf } from "./apply";
import { requestFor } from "./row";

/** Whether the form says something that can be done to all. */
export function canChangeAll(session: Session): boolean {
  const form = formOf(session.verb.value);
  // One that is still being opened would be left out without a word.
  if (!form || session.models.value.some(({ inspected, failure }) => !inspected && !failure)) return false;
  if (problems(form, session.values).size > 0) return false;
  const owns = session.models.value.some(({ targetMass }) => targetMass !== "");
  return !isEmpty(form, session.values) || (form.verb === "rescale" && owns) || form.verb === "remove";
}

/** Does the change to each model, and shows in its row what it does. */
export function changeAll(session: Session): Promise<void> {
  return once(session, async () => {
    const { done, failed } = await eachRow(session, (request) => session.engine.change(request, ["changes"]));
    session.announce(`${done} of ${done + failed} models would change${failed > 0 ? `, ${failed} failed` : ""}.`);
  });
}

/** Does the change to each model and saves the results in one archive; models that fail are not in it. */
export function downloadAll(session: Session): Promise<void> {
  return once(session, async () => {
    await session.engine.zipBegin();
    const { done, failed } = await eachRow(session, (request) => session.engine.zipAdd(request));
    const bytes = await session.engine.zipEnd();
    if (done > 0) save("models.zip", bytes, "application/zip");
    const without = failed > 0 ? `; ${failed} failed and are not in it` : "";
    const made = `models.zip has the results of ${counted(done, "model")}${without}.`;
    session.announce(done > 0 ? made : "No model could be changed; there is no archive.");
  });
}

/** One of these at a time: there is one archive. */
async function once(session: Session, act: () => Promise<void>): Promise<void> {
  if (session.changingAll.value) return;
  session.changingAll.set(true);
  try {
    await act();
  } catch (error) {
    session.announce(`The models could not be changed: ${failureOf(error).message}.`);
  } finally {
    session.changingAll.set(false);
  }
}

/** Asks for each model what the form says now, whatever is typed meanwhile; counts what comes out. */
async function eachRow(session: Session, ask: (request: Request) => Promise<Change>): Promise<{ done: number; failed: number }> {
  const form = formOf(session.verb.value);
  const requestOfRow = (model: OpenModel) => form && requestFor(session, form, model);
  const rows = session.models.value.map((model) => ({ model, request: requestOfRow(model) }));
  let failed = 0;
  let done = 0;
  for (const { model, request } of rows) {
    if (!request) continue;
    const outcome = model.inspected ? await outcomeOf(ask(request)) : failedToOpen(model);
    if (outcome?.state === "failed") failed += 1;
    else if (outcome) done += 1;
    // A row shows the outcome of what the form says; if that is something else by now, nothing.
    const asked = JSON.stringify(request);
    session.update(model.id, (open) => (JSON.stringify(requestOfRow(open)) === asked ? { ...open, outcome } : open));
  }
  return { done, failed };
}

function failedToOpen({ failure }: OpenModel): Outcome | null {
  return failure && { state: "failed", failure };
}

async function outcomeOf(asked: Promise<Change>): Promise<Outcome> {
  try {
    const change = await asked;
    if (change.unchanged) return { state: "same", text: "nothing to change; it stays as it is" };
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
