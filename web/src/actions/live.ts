// Keeps the preview up to date while the form changes: one question is in the air, and the newest one is next.

import { failureOf } from "../engine/failure";
import type { Change, Request, Section } from "../engine/types";
import { formOf } from "../forms/all";
import type { Form } from "../forms/declaration";
import { isEmpty, problems, unsaid } from "../forms/request";
import { fileOf } from "../state/model";
import type { Preview, Session } from "../state/session";
import { hasOwnMass, requestFor } from "./row";

// What is asked for at once: what may be on the screen and is quick.
const PLOTS = ["scene", "plots", "state"];
const ALL = ["changes", "reference", ...PLOTS, "falls", "feet", "findings", "figures"];
const REST_MS = 150;
/** The codes of a mass that may be in another unit. */
const SLIPS = new Set(["implausible-mass", "mass-in-pounds"]);

type Plan = { ask: Request } | { show: Preview };

export class Live {
  #asking = false;
  /** Which verb and which model the preview is of. */
  #of = "";
  #newer = false;
  #since: number | undefined;
  #rest: ReturnType<typeof setTimeout> | undefined;
  #rested: () => void = () => undefined;

  constructor(readonly session: Session) {}

  /** Calls `rested` when nothing was typed for a moment. */
  onRest(rested: () => void): void {
    this.#rested = rested;
  }

  /** Something was typed, ticked or moved. */
  typed = (): void => {
    this.#since ??= performance.now();
    this.changed();
  };

  /** The preview may be of something else now. */
  changed = (): void => {
    this.#newer = true;
    this.#forget();
    clearTimeout(this.#rest);
    this.#rest = setTimeout(() => this.#complete(), REST_MS);
    if (!this.#asking) void this.#ask();
  };

  async #ask(): Promise<void> {
    this.#asking = true;
    // Whatever happens, the next change must be asked for.
    try {
      while (this.#newer) {
        this.#newer = false;
        const since = this.#since;
        this.#since = undefined;
        await this.#show(this.#quick());
        if (since !== undefined) measureStep(since);
      }
    } finally {
      this.#asking = false;
    }
  }

  /** What is shown of another model, or of another verb, goes away at once: buttons under it would be about that one. */
  #forget(): void {
    const { state } = this.session.preview.value;
    if ((state === "done" || state === "failed") && this.#of !== subject(this.session)) this.session.preview.set({ state: "none" });
  }

  /** After a rest: what takes longer. */
  #complete(): void {
    // Browsers limit how often the address may change; that is no reason to stop here.
    try {
      this.#rested();
    } catch (error) {
      console.warn(error);
    }
    if (this.#asking || this.session.preview.value.state === "none") {
      if (this.#asking) this.#rest = setTimeout(() => this.#complete(), REST_MS);
      return;
    }
    this.#asking = true;
    void this.#show(ALL).finally(() => {
      this.#asking = false;
      if (this.#newer) void this.#ask();
    });
  }

  #quick(): string[] {
    return ["changes", ...PLOTS.filter((id) => this.session.visible.has(id))];
  }

  async #show(parts: string[]): Promise<void> {
    const { session } = this;
    const of = subject(session);
    const next = await this.#next(parts);
    // Another model may have been chosen meanwhile; that is asked about next.
    if (of !== subject(session)) return;
    this.#of = of;
    session.preview.set(next);
  }

  /** Asks for a change. A mass that was chosen by slider or button is meant as it is: pounds or grams are only typed by mistake. */
  async #asked(request: Request, parts: string[]): Promise<{ change: Change; request: Request }> {
    const { engine, values } = this.session;
    try {
      return { change: await engine.change(request, parts), request };
    } catch (error) {
      const { code } = failureOf(error);
      if (!SLIPS.has(code) || !values.isChosen("target_mass")) throw error;
      const meant = { ...request, yes: [...values.texts("yes"), code] };
      return { change: await engine.change(meant, parts), request: meant };
    }
  }

  async #next(parts: string[]): Promise<Preview> {
    const { session } = this;
    try {
      const planned = plan(session);
      if ("show" in planned) return planned.show;
      const { change, request } = await this.#asked(planned.ask, parts);
      session.remember(change.explained);
      return done(session.preview.value, change, request, parts);
    } catch (error) {
      return { state: "failed", failure: failureOf(error) };
    }
  }
}

/** What a preview is of. */
function subject(session: Session): string {
  const model = session.model();
  return `${session.verb.value} ${model ? `${model.id} ${fileOf(model)}` : ""}`;
}

/** What the form asks for now. */
function plan(session: Session): Plan {
  const model = session.model();
  const form = formOf(session.verb.value);
  if (!model?.inspected || !form) return { show: { state: "none" } };
  const { values } = session;
  const wrong = problems(form, values);
  if (wrong.size > 0) return hint(correctFirst(form, wrong));
  const missing = unsaid(form, values);
  if (missing.length > 0) return hint(`Say this to see what would change: ${quoted(missing)}.`);
  const says = !isEmpty(form, values) || hasOwnMass(session, form, model);
  if (ASKS_SOMETHING.has(form.verb) && !says) return hint(EMPTY[form.verb] ?? "");
  return { ask: requestFor(session, form, model) };
}

// Forms that mean nothing while they are empty. The others have a meaning: take all contacts out, say.
const EMPTY: Readonly<Record<string, string>> = {
  rescale: "Give a target mass, or a radius, to see what would change.",
  design: "Say what you want, such as a relative indentation, to see what would change.",
};
const ASKS_SOMETHING = new Set(Object.keys(EMPTY));

function hint(text: string): Plan {
  return { show: { state: "hint", text } };
}

/** Which fields have something wrong in them. */
function correctFirst(form: Form, wrong: ReadonlyMap<string, string>): string {
  return `Correct this first: ${quoted(form.fields.filter(({ name }) => wrong.has(name)))}.`;
}

function quoted(fields: readonly { label: string }[]): string {
  return fields.map(({ label }) => `“${label}”`).join(", ");
}

/** The new preview: sections of the same model that were not asked for stay until they are. */
function done(before: Preview, change: Change, request: Request, parts: readonly string[]): Preview {
  const complete = parts === ALL;
  const same = before.state === "done" && before.request.verb === request.verb && before.request.models?.[0] === request.models?.[0];
  const old: readonly Section[] = same && !complete ? before.sections : [];
  const fresh = new Map(change.sections.map((section) => [section.id, section]));
  const kept = old.filter(({ id }) => !parts.includes(id));
  return { state: "done", change, request, sections: [...kept, ...fresh.values()], complete };
}

/** How long it took from the first input to what is shown, for those who measure it. */
function measureStep(start: number): void {
  performance.measure("step", { start, end: performance.now() });
}
