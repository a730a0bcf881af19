// The state of the page: open files and models, forms, and the preview.

import type { Client } from "../engine/client";
import type { Change, Failure, Request, Section } from "../engine/types";
import type { FileEntry } from "../files/kinds";
import type { OpenModel } from "./model";
import { Signal } from "./signal";
import { type Value, Values } from "../forms/values";

/** A preset, and its file, if it is one of the user's. */
export interface PresetEntry {
  name: string;
  file?: string;
}

/** The effect of the change in the form. */
export type Preview =
  | { state: "none" }
  | { state: "hint"; text: string }
  | { state: "failed"; failure: Failure }
  | {
      state: "done";
      change: Change;
      request: Request;
      sections: readonly Section[];
      /** Whether the slow sections are up to date, too. */
      complete: boolean;
    };

export class Session {
  readonly files = new Signal<readonly FileEntry[]>([]);
  readonly models = new Signal<readonly OpenModel[]>([]);
  readonly chosen = new Signal<number | null>(null);
  readonly presets = new Signal<readonly PresetEntry[]>([]);
  readonly verb = new Signal("rescale");
  /** The values of the verb's form. */
  readonly values = new Values();
  /** The values of the calculator's form. */
  readonly calculation = new Values();
  readonly preview = new Signal<Preview>({ state: "none" });
  /** Whether the form has changed since the preview was made. */
  isPreviewOld = false;
  readonly calculating = new Signal(false);
  /** The last event, as a text to show and to announce. */
  readonly announcement = new Signal("");
  /** Sections of the preview that are on the screen. */
  readonly visible = new Set<string>();
  /** Explanations that links in sections open, by anchor. */
  readonly explained = new Map<string, string>();

  /** Whether a change is being applied: a second one must wait for its result. */
  readonly keeping = new Signal(false);
  /** Whether all models are being changed. */
  readonly changingAll = new Signal(false);
  /** The failure of a button of the open model. */
  readonly failed = new Signal<Failure | null>(null);
  /** Results that were downloaded. */
  readonly saved = new Set<string>();

  readonly #valuesByVerb = new Map<string, ReadonlyMap<string, Value>>();

  constructor(readonly engine: Client) {}

  /** Shows the form of another verb, with its earlier values or with `values`. */
  setVerb(verb: string, values?: ReadonlyMap<string, Value>): void {
    if (verb === this.verb.value && !values) return;
    if (verb !== this.verb.value) this.#valuesByVerb.set(this.verb.value, this.values.all());
    // The verb changes before the listeners are called, so that the new form never has the old values.
    this.values.replace(values ?? this.#valuesByVerb.get(verb) ?? new Map<string, Value>(), () => this.verb.set(verb));
  }

  /** The model whose details are shown. */
  model(): OpenModel | undefined {
    return this.findModel(this.chosen.value);
  }

  findModel(id: number | null): OpenModel | undefined {
    return this.models.value.find((model) => model.id === id);
  }

  add(model: OpenModel): void {
    this.models.set([...this.models.value, model]);
  }

  /** Replaces a model by the result of `change`, if it is still open. */
  update(id: number, change: (model: OpenModel) => OpenModel): void {
    this.models.set(this.models.value.map((model) => (model.id === id ? change(model) : model)));
  }

  announce(text: string): void {
    // The text is cleared first, so that an equal text is announced again.
    this.announcement.set("");
    this.announcement.set(text);
  }

  remember(explained: readonly { id: string; html: string }[] | undefined): void {
    for (const { id, html } of explained ?? []) this.explained.set(id, html);
  }
}
