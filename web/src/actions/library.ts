// Makes one change in all open models.

import { toFailure } from "../engine/failure";
import type { Change, Request } from "../engine/types";
import { counted } from "../dom/number";
import { findForm } from "../forms/all";
import { isEmpty, problems } from "../forms/request";
import type { Value } from "../forms/values";
import { save } from "../download/save";
import { currentFile, type OpenModel, type Outcome } from "../state/model";
import type { Session } from "../state/session";
import { changeText } from "./apply";
import { requestFor } from "./row";

/** Whether the form has a change that can be made in all models. */
export function canChangeAll(session: Session): boolean {
  const form = findForm(session.verb.value);
  // A model that is still being opened would be left out silently.
  if (!form || session.models.value.some(({ inspected, failure }) => !inspected && !failure)) return false;
  if (problems(form, session.values).size > 0) return false;
  const anyOwnMass = session.models.value.some(({ targetMass }) => targetMass !== "");
  return !isEmpty(form, session.values) || (form.verb === "rescale" && anyOwnMass) || form.verb === "remove";
}

/** Computes the change of each model, and shows its effect in the model's row. */
export function changeAll(session: Session): Promise<void> {
  return exclusively(session, async () => {
    const { done, failed } = await forEachModel(session, (request) => session.engine.change(request, ["changes"]));
    session.announce(`${done} of ${done + failed} models would change${failed > 0 ? `, ${failed} failed` : ""}.`);
  });
}

/** Changes each model and downloads the results in one archive, without models that fail. */
export function downloadAll(session: Session): Promise<void> {
  return exclusively(session, async () => {
    await session.engine.zipBegin();
    const { done, failed } = await forEachModel(session, (request) => session.engine.zipAdd(request));
    const bytes = await session.engine.zipEnd();
    if (done > 0) save("models.zip", bytes, "application/zip");
    const without = failed > 0 ? `; ${failed} failed and are not in it` : "";
    const message = `models.zip has the results of ${counted(done, "model")}${without}.`;
    session.announce(done > 0 ? message : "No model could be changed; there is no archive.");
  });
}

/** Lets the spheres of all models follow their bones from one that they were scaled from, and downloads the results. */
export function followAll(session: Session, from: string): Promise<void> {
  // The preview is of a model that changes.
  const scaled = session.models.value.find((model) => currentFile(model) !== from);
  if (scaled) session.chosen.set(scaled.id);
  session.setVerb("transfer", new Map<string, Value>([["from", from], ["follow_bodies", true], ["level", true]]));
  return downloadAll(session);
}

/** Runs one task at a time, because there is one archive. */
async function exclusively(session: Session, act: () => Promise<void>): Promise<void> {
  if (session.changingAll.value) return;
  session.changingAll.set(true);
  try {
    await act();
  } catch (error) {
    session.announce(`The models could not be changed: ${toFailure(error).message}.`);
  } finally {
    session.changingAll.set(false);
  }
}

/** Sends the request of the form for each model, even if the user types meanwhile; counts successes and failures. */
async function forEachModel(session: Session, ask: (request: Request) => Promise<Change>): Promise<{ done: number; failed: number }> {
  const form = findForm(session.verb.value);
  const requestOfRow = (model: OpenModel) => form && requestFor(session, form, model);
  const rows = session.models.value.map((model) => ({ model, request: requestOfRow(model) }));
  let failed = 0;
  let done = 0;
  for (const { model, request } of rows) {
    // A model that gives its contacts to the others stays as it is.
    if (!request || request["from"] === currentFile(model)) continue;
    const outcome = model.inspected ? await toOutcome(ask(request)) : failedToOpen(model);
    if (outcome?.state === "failed") failed += 1;
    else if (outcome) done += 1;
    // If the form has another change by now, the row shows no outcome.
    const requestKey = JSON.stringify(request);
    session.update(model.id, (open) => (JSON.stringify(requestOfRow(open)) === requestKey ? { ...open, outcome } : open));
  }
  return { done, failed };
}

function failedToOpen({ failure }: OpenModel): Outcome | null {
  return failure && { state: "failed", failure };
}

async function toOutcome(answer: Promise<Change>): Promise<Outcome> {
  try {
    const change = await answer;
    if (change.unchanged) return { state: "same", text: "nothing to change; it stays as it is" };
    return { state: "done", text: changeText(change) };
  } catch (error) {
    return { state: "failed", failure: toFailure(error) };
  }
}
