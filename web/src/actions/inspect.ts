// Inspects models: their contacts and their findings.

import { toFailure } from "../engine/failure";
import { QUESTIONS } from "../forms/all";
import { answersFor } from "../state/answers";
import type { Inspected } from "../engine/types";
import { currentFile, hasMisplacedSpheres, isBare, isSameMass, type OpenModel } from "../state/model";
import type { Session } from "../state/session";

// Sections that are visible at once, and sections that open on demand and are computed later.
const QUICK_SECTIONS = ["feet", "scene"];
const SLOW_SECTIONS = ["contacts", "figures", "plots", "state", "model", "falls"];

/** Inspects a model after its current step. */
export async function inspect(session: Session, id: number): Promise<void> {
  const model = session.findModel(id);
  if (!model) return;
  const file = currentFile(model);
  // Until the answer comes, the model may have got another step.
  const update = (change: Partial<OpenModel>) => session.update(id, (open) => (currentFile(open) === file ? { ...open, ...change } : open));
  try {
    const inspected = await session.engine.inspect(file, answersFor(model, QUESTIONS), QUICK_SECTIONS);
    session.remember(inspected.explained);
    update({ inspected, failure: null });
    measureOpen();
    if (session.chosen.value === id) void inspectDetails(session, id);
    if (session.chosen.value !== null) void findOriginal(session, session.chosen.value);
  } catch (error) {
    const failure = toFailure(error);
    // If the failure is about a file that the model is compared with, the facts about the model stay on the screen.
    const isAboutOtherFile = failure.model != null && failure.model !== file && model.inspected !== null;
    update(isAboutOtherFile ? { failure } : { inspected: null, failure });
  }
}

/** Adds the slow sections for a model whose details are shown. */
export async function inspectDetails(session: Session, id: number): Promise<void> {
  const model = session.findModel(id);
  const first = model?.inspected;
  if (!model || !first || first.sections.some(({ id: sectionId }) => SLOW_SECTIONS.includes(sectionId))) return;
  const details = await session.engine.inspect(currentFile(model), answersFor(model, QUESTIONS), SLOW_SECTIONS).catch(() => null);
  if (!details) return;
  session.remember(details.explained);
  const sections = [...first.sections, ...details.sections];
  // The model may have been inspected again in between.
  session.update(id, (open) => (open.inspected === first ? { ...open, inspected: { ...first, sections, falls: details.falls } } : open));
}

/** More models than this are not compared with one. */
const MAX_ORIGINALS = 5;

/**
 * Finds the open models from which this one may have been scaled. Unless the user has said it, the model is compared with the only one from
 * now on; of several, the user has to choose.
 */
export async function findOriginal(session: Session, id: number): Promise<string | undefined> {
  const model = session.findModel(id);
  const inspected = model?.inspected;
  const said = model?.answers.text("from") || undefined;
  // What was found, and not said by the user, ends when another model fits, too.
  if (!model || !inspected || (said !== undefined && said !== model.originals.join("\n"))) return said;
  let isNew = false;
  const candidates = session.models.value.filter((other) => other.id !== id && !model.seen.has(other.origin) && mayBeOriginal(other, inspected));
  for (const other of candidates.slice(0, MAX_ORIGINALS)) {
    const from = currentFile(other);
    model.seen.add(other.origin);
    const compared = await session.engine.inspect(currentFile(model), { ...answersFor(model, QUESTIONS), from }, []).catch(() => null);
    if (!compared?.findings.some(({ remedy }) => remedy?.request.verb === "transfer")) continue;
    session.update(id, (open) => ({ ...open, originals: [...open.originals, from] }));
    isNew = true;
  }
  if (!isNew) return said;
  const [found, ...others] = session.findModel(id)?.originals ?? [];
  const only = others.length === 0 ? found : undefined;
  model.answers.set("from", only ?? "");
  if (session.chosen.value !== id) await inspect(session, id);
  return only;
}

/** Whether a model has the bodies of another, and contacts that fit its own bodies. */
function mayBeOriginal({ inspected }: OpenModel, scaled: Inspected): boolean {
  if (!inspected || isBare(inspected)) return false;
  const { mass_kg: bodyMass, contacts_mass_kg: contactsMass, bodies } = inspected.inspection;
  const names = (all: typeof bodies) => all.map(({ name }) => name).join("\n");
  const fits = bodyMass === null || !contactsMass || isSameMass(contactsMass.value, bodyMass);
  return fits && !hasMisplacedSpheres(inspected) && names(bodies) === names(scaled.inspection.bodies);
}

/** Inspects models again after other files were added or removed. */
export async function inspectAgain(session: Session, models: readonly OpenModel[] = session.models.value): Promise<void> {
  for (const { id } of models) await inspect(session, id);
}

/** Records the time from opening a file to showing its model, for performance tests. */
function measureOpen(): void {
  if (performance.getEntriesByName("open", "mark").length === 0) return;
  performance.measure("open", "open");
  performance.clearMarks("open");
}
