// Inspects models: what is in them, and what is wrong.

import { failureOf } from "../engine/failure";
import { QUESTIONS } from "../forms/all";
import { answered } from "../state/answers";
import { fileOf, type OpenModel } from "../state/model";
import type { Session } from "../state/session";

// What is seen at once, and what opens only on demand: that is made when there is time.
const FIRST = ["feet", "scene"];
const LATER = ["contacts", "figures", "plots", "state", "model", "falls"];

/** Inspects a model as it is now. */
export async function inspect(session: Session, id: number): Promise<void> {
  const model = session.modelOf(id);
  if (!model) return;
  const file = fileOf(model);
  // When the answer comes, the model may have gone on to another step.
  const update = (change: Partial<OpenModel>) => session.update(id, (open) => (fileOf(open) === file ? { ...open, ...change } : open));
  try {
    const inspected = await session.engine.inspect(file, answered(model, QUESTIONS), FIRST);
    session.remember(inspected.explained);
    update({ inspected, failure: null });
    measureOpen();
    if (session.chosen.value === id) void inspectDetails(session, id);
  } catch (error) {
    const failure = failureOf(error);
    // Another file that the model is compared with is no reason to take from the screen what is known of the model.
    const ofAnother = failure.model != null && failure.model !== file && model.inspected !== null;
    update(ofAnother ? { failure } : { inspected: null, failure });
  }
}

/** Adds what takes longer, for a model whose details are shown. */
export async function inspectDetails(session: Session, id: number): Promise<void> {
  const model = session.modelOf(id);
  const first = model?.inspected;
  if (!model || !first || first.sections.some(({ id: made }) => LATER.includes(made))) return;
  const seen = await session.engine.inspect(fileOf(model), answered(model, QUESTIONS), LATER).catch(() => null);
  if (!seen) return;
  session.remember(seen.explained);
  const sections = [...first.sections, ...seen.sections];
  // It may have been inspected once more in between.
  session.update(id, (open) => (open.inspected === first ? { ...open, inspected: { ...first, sections, falls: seen.falls } } : open));
}

/** Inspects models again that may be seen otherwise now that other files are there. */
export async function inspectAgain(session: Session, models: readonly OpenModel[] = session.models.value): Promise<void> {
  for (const { id } of models) await inspect(session, id);
}

/** How long it took from a file to what is shown of it, for those who measure it. */
function measureOpen(): void {
  if (performance.getEntriesByName("open", "mark").length === 0) return;
  performance.measure("open", "open");
  performance.clearMarks("open");
}
