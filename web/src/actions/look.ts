// Looks at models: what is in them, and what is wrong.

import { failureOf } from "../engine/failure";
import { QUESTIONS } from "../forms/all";
import { answered } from "../state/answers";
import { fileOf, type OpenModel } from "../state/model";
import type { Session } from "../state/session";

// What is seen at once, and what opens only on demand: that is made when there is time.
const FIRST = ["feet"];
const LATER = ["contacts", "figures", "plots", "state", "model"];

/** Looks at a model as it is now. */
export async function look(session: Session, id: number): Promise<void> {
  const model = find(session, id);
  if (!model) return;
  const fields = answered(model, QUESTIONS);
  try {
    const seen = await session.engine.look(fileOf(model), fields, FIRST);
    session.remember(seen.explained);
    session.update(id, (open) => ({ ...open, look: seen, failure: null }));
    measureOpen();
    if (session.chosen.value === id) void lookCloser(session, id);
  } catch (error) {
    const failure = failureOf(error);
    session.update(id, (open) => ({ ...open, look: null, failure }));
  }
}

/** Adds what takes longer, for a model whose details are shown. */
export async function lookCloser(session: Session, id: number): Promise<void> {
  const model = find(session, id);
  const first = model?.look;
  if (!model || !first || first.sections.some(({ id: made }) => LATER.includes(made))) return;
  const seen = await session.engine.look(fileOf(model), answered(model, QUESTIONS), LATER).catch(() => null);
  if (!seen) return;
  session.remember(seen.explained);
  const sections = [...first.sections, ...seen.sections];
  // Another look may have come between.
  session.update(id, (open) => (open.look === first ? { ...open, look: { ...first, sections } } : open));
}

/** Looks again at models that may be seen otherwise now that other files are there. */
export async function lookAgain(session: Session): Promise<void> {
  for (const { id } of session.models.value) await look(session, id);
}

function find(session: Session, id: number): OpenModel | undefined {
  return session.models.value.find((model) => model.id === id);
}

/** How long it took from a file to what is shown of it, for those who measure it. */
function measureOpen(): void {
  if (performance.getEntriesByName("open", "mark").length === 0) return;
  performance.measure("open", "open");
  performance.clearMarks("open");
}
