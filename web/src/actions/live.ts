// Keeps the preview up to date while the form changes: one request is sent at a time, then the newest one.

import { toFailure } from "../engine/failure";
import type { Change, Inspected, Request, Section } from "../engine/types";
import { findForm } from "../forms/all";
import type { Form } from "../forms/declaration";
import { isEmpty, problems, missingFields } from "../forms/request";
import { currentFile, lacksContacts, proposedRequest } from "../state/model";
import type { Preview, Session } from "../state/session";
import { hasOwnMass, requestFor } from "./row";

// Sections that are quick to compute and may be on the screen.
const QUICK_SECTIONS = ["scene", "plots", "state"];
const ALL_SECTIONS = ["changes", "reference", ...QUICK_SECTIONS, "falls", "feet", "findings", "figures"];
const REST_BEFORE_PREVIEW_MS = 150;
/** Codes of questions whether a mass is in another unit. */
const UNIT_QUESTIONS = new Set(["implausible-mass", "mass-in-pounds"]);

type Plan = { ask: Request } | { show: Preview };

export class LivePreview {
  #isAsking = false;
  /** The verb and the model that the preview is about. */
  #previewSubject = "";
  #isOutdated = false;
  #firstTypedAt: number | undefined;
  #restTimer: ReturnType<typeof setTimeout> | undefined;
  #afterRest: () => void = () => undefined;

  constructor(readonly session: Session) {}

  /** Calls `rested` after the user has typed nothing for a moment. */
  onRest(rested: () => void): void {
    this.#afterRest = rested;
  }

  /** Call this after the user has changed a field. */
  typed = (): void => {
    this.#firstTypedAt ??= performance.now();
    this.changed();
  };

  /** Call this when the preview may be outdated. */
  changed = (): void => {
    this.#isOutdated = this.session.isPreviewOld = true;
    this.#discardStale();
    clearTimeout(this.#restTimer);
    this.#restTimer = setTimeout(() => this.#refreshAll(), REST_BEFORE_PREVIEW_MS);
    if (!this.#isAsking) void this.#ask();
  };

  async #ask(): Promise<void> {
    this.#isAsking = true;
    // Also after an error, the next change must be requested.
    try {
      while (this.#isOutdated) {
        this.#isOutdated = false;
        const since = this.#firstTypedAt;
        this.#firstTypedAt = undefined;
        await this.#updatePreview(this.#quickSections());
        if (since !== undefined) measureStep(since);
      }
    } finally {
      this.#isAsking = false;
      this.session.isPreviewOld = this.#isOutdated;
    }
  }

  /** Hides a preview of another model or verb at once, because its buttons would act on that one. */
  #discardStale(): void {
    const { state } = this.session.preview.value;
    if ((state === "done" || state === "failed") && this.#previewSubject !== subjectName(this.session)) this.session.preview.set({ state: "none" });
  }

  /** Requests the slow sections after the user has typed nothing for a moment. */
  #refreshAll(): void {
    // Browsers limit how often the address may change; the error does not matter here.
    try {
      this.#afterRest();
    } catch (error) {
      console.warn(error);
    }
    if (this.#isAsking || this.session.preview.value.state === "none") {
      if (this.#isAsking) this.#restTimer = setTimeout(() => this.#refreshAll(), REST_BEFORE_PREVIEW_MS);
      return;
    }
    this.#isAsking = true;
    void this.#updatePreview(ALL_SECTIONS).finally(() => {
      this.#isAsking = false;
      if (this.#isOutdated) void this.#ask();
    });
  }

  #quickSections(): string[] {
    return ["changes", ...QUICK_SECTIONS.filter((id) => this.session.visible.has(id))];
  }

  async #updatePreview(parts: string[]): Promise<void> {
    const { session } = this;
    const subjectBefore = subjectName(session);
    const next = await this.#nextPreview(parts);
    // If another model was chosen meanwhile, the next request is about that one.
    if (subjectBefore !== subjectName(session)) return;
    this.#previewSubject = subjectBefore;
    session.preview.set(next);
  }

  /** Requests a change. A mass from the slider or a button is confirmed at once: only typed numbers may be in pounds or grams. */
  async #requestChange(request: Request, parts: string[]): Promise<{ change: Change; request: Request }> {
    const { engine, values } = this.session;
    try {
      return { change: await engine.change(request, parts), request };
    } catch (error) {
      const { code } = toFailure(error);
      if (!UNIT_QUESTIONS.has(code) || !values.isChosen("target_mass")) throw error;
      const confirmed = { ...request, yes: [...values.texts("yes"), code] };
      return { change: await engine.change(confirmed, parts), request: confirmed };
    }
  }

  async #nextPreview(parts: string[]): Promise<Preview> {
    const { session } = this;
    try {
      const planned = planPreview(session);
      if ("show" in planned) return planned.show;
      const { change, request } = await this.#requestChange(planned.ask, parts);
      session.remember(change.explained);
      return donePreview(session.preview.value, change, request, parts);
    } catch (error) {
      return { state: "failed", failure: toFailure(error) };
    }
  }
}

/** Waits until the preview is that of the form as it is now. */
export async function previewOfForm(session: Session): Promise<void> {
  while (session.isPreviewOld) await new Promise((resolve) => setTimeout(resolve, 20));
}

/** The verb and the model that a preview would be about. */
function subjectName(session: Session): string {
  const model = session.model();
  return `${session.verb.value} ${model ? `${model.id} ${currentFile(model)}` : ""}`;
}

/** The request of the form, or the preview to show without one. */
function planPreview(session: Session): Plan {
  const model = session.model();
  const form = findForm(session.verb.value);
  if (!model?.inspected || !form) return { show: { state: "none" } };
  const { values } = session;
  const wrong = problems(form, values);
  if (wrong.size > 0) return hintPlan(correctFirst(form, wrong));
  const isFilled = !isEmpty(form, values) || hasOwnMass(session, form, model);
  const missing = missingFields(form, values);
  if (!isFilled && model.stepCount > 0 && (missing.length > 0 || NEEDS_INPUT.has(form.verb)) && !proposedRequest(model.inspected)) return hintPlan(KEPT_HINT);
  if (missing.length > 0) return hintPlan(`To see what would change, fill in ${quotedLabels(missing)}.`);
  if (NEEDS_INPUT.has(form.verb) && !isFilled) return hintPlan(emptyHint(form, model.inspected));
  return { ask: requestFor(session, form, model) };
}

// Hints for forms that need a value. An empty form of another verb is a request: `remove` then removes all contacts.
const EMPTY_HINTS: Readonly<Record<string, string>> = {
  rescale: "Give a target mass, or a radius, to see what would change.",
  add: "Choose where the contacts come from: another model or a preset, a table, or the bodies that touch the ground.",
  design: "Say what you want, such as a relative indentation, to see what would change.",
};
const KEPT_HINT = "The change is kept. Download the model with the blue button below, or change more.";
const NEEDS_INPUT = new Set(Object.keys(EMPTY_HINTS));

function emptyHint({ verb }: Form, inspected: Inspected): string {
  if (verb !== "add" && lacksContacts(inspected)) return "First give the model contacts, in step 2.";
  if (proposedRequest(inspected)) return "Click the blue button of step 2, or choose another change, to see its result.";
  return EMPTY_HINTS[verb] ?? "";
}

function hintPlan(text: string): Plan {
  return { show: { state: "hint", text } };
}

/** A hint that names the fields with problems. */
function correctFirst(form: Form, wrong: ReadonlyMap<string, string>): string {
  return `Correct this first: ${quotedLabels(form.fields.filter(({ name }) => wrong.has(name)))}.`;
}

function quotedLabels(fields: readonly { label: string }[]): string {
  return fields.map(({ label }) => `“${label}”`).join(", ");
}

/** The new preview. Sections of the same request that were not computed again stay. */
function donePreview(before: Preview, change: Change, request: Request, parts: readonly string[]): Preview {
  const complete = parts === ALL_SECTIONS;
  const isSameRequest = before.state === "done" && before.request.verb === request.verb && before.request.models?.[0] === request.models?.[0];
  const oldSections: readonly Section[] = isSameRequest && !complete ? before.sections : [];
  const newSections = new Map(change.sections.map((section) => [section.id, section]));
  const remaining = oldSections.filter(({ id }) => !parts.includes(id));
  return { state: "done", change, request, sections: [...remaining, ...newSections.values()], complete };
}

/** Records the time from the first input to the new preview, for performance tests. */
function measureStep(start: number): void {
  performance.measure("step", { start, end: performance.now() });
}
