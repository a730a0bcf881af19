// Keeps the preview up to date while the form changes: one question is in the air, and the newest one is next.

import { failureOf } from "../engine/failure";
import type { Change, Request, Section } from "../engine/types";
import { formOf } from "../forms/all";
import { isEmpty, problems, requestOf, unsaid } from "../forms/request";
import { answered } from "../state/answers";
import { fileOf } from "../state/model";
import type { Preview, Session } from "../state/session";

// What is asked for at once: what may be on the screen and is quick.
const PLOTS = ["plots", "state"];
const ALL = ["changes", "reference", ...PLOTS, "feet", "findings", "figures"];
const REST_MS = 150;

type Plan = { ask: Request } | { show: Preview };

export class Live {
  #asking = false;
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
    clearTimeout(this.#rest);
    this.#rest = setTimeout(() => this.#complete(), REST_MS);
    if (!this.#asking) void this.#ask();
  };

  async #ask(): Promise<void> {
    this.#asking = true;
    while (this.#newer) {
      this.#newer = false;
      const since = this.#since;
      this.#since = undefined;
      await this.#show(plan(this.session), this.#quick());
      if (since !== undefined) measureStep(since);
    }
    this.#asking = false;
  }

  /** After a rest: what takes longer. */
  #complete(): void {
    this.#rested();
    if (this.#asking || this.session.preview.value.state === "none") {
      if (this.#asking) this.#rest = setTimeout(() => this.#complete(), REST_MS);
      return;
    }
    this.#asking = true;
    void this.#show(plan(this.session), ALL).finally(() => {
      this.#asking = false;
      if (this.#newer) void this.#ask();
    });
  }

  #quick(): string[] {
    return ["changes", ...PLOTS.filter((id) => this.session.visible.has(id))];
  }

  async #show(planned: Plan, parts: string[]): Promise<void> {
    const { session } = this;
    if ("show" in planned) return session.preview.set(planned.show);
    try {
      const change = await session.engine.change(planned.ask, parts);
      session.remember(change.explained);
      session.preview.set(done(session.preview.value, change, planned.ask, parts));
    } catch (error) {
      session.preview.set({ state: "failed", failure: failureOf(error) });
    }
  }
}

/** What the form asks for now. */
function plan(session: Session): Plan {
  const model = session.model();
  const form = formOf(session.verb.value);
  if (!model?.look || !form) return { show: { state: "none" } };
  const { values } = session;
  const wrong = problems(form, values);
  if (wrong.size > 0) return hint(`Correct this first: ${quoted(form.fields.filter(({ name }) => wrong.has(name)))}.`);
  const missing = unsaid(form, values);
  if (missing.length > 0) return hint(`Say this to see what would change: ${quoted(missing)}.`);
  if (ASKS_SOMETHING.has(form.verb) && isEmpty(form, values)) return hint(EMPTY[form.verb] ?? "");
  return { ask: requestOf(form, values, fileOf(model), answered(model, form)) };
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

function quoted(fields: readonly { label: string }[]): string {
  return fields.map(({ label }) => `“${label}”`).join(", ");
}

/** The new preview: sections that were not asked for stay until they are. */
function done(before: Preview, change: Change, request: Request, parts: readonly string[]): Preview {
  const complete = parts === ALL;
  const old: readonly Section[] = before.state === "done" && !complete ? before.sections : [];
  const fresh = new Map(change.sections.map((section) => [section.id, section]));
  const kept = old.filter(({ id }) => !parts.includes(id));
  return { state: "done", change, request, sections: [...kept, ...fresh.values()], complete };
}

/** How long it took from the first input to what is shown, for those who measure it. */
function measureStep(start: number): void {
  performance.measure("step", { start, end: performance.now() });
}
