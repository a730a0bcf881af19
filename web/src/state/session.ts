// Everything that is open, and what the page is about to ask.

import type { Client } from "../engine/client";
import type { Change, Failure, Request, Section } from "../engine/types";
import type { FileEntry } from "../files/kinds";
import type { OpenModel } from "./model";
import { Signal } from "./signal";
import { type Value, Values } from "../forms/values";

/** A preset, and the file that it is from, if it is one of the user's. */
export interface PresetEntry {
  name: string;
  file?: string;
}

/** What the change in the form would do. */
export type Preview =
  | { state: "none" }
  | { state: "hint"; text: string }
  | { state: "failed"; failure: Failure }
  | {
      state: "done";
      change: Change;
      request: Request;
      sections: readonly Section[];
      /** Whether the sections that take longer are those of this change. */
      complete: boolean;
    };

export class Session {
  readonly files = new Signal<readonly FileEntry[]>([]);
  readonly models = new Signal<readonly OpenModel[]>([]);
  readonly chosen = new Signal<number | null>(null);
  readonly presets = new Signal<readonly PresetEntry[]>([]);
  readonly verb = new Signal("rescale");
  /** What the form of the verb says. */
  readonly values = new Values();
  /** What the calculator's form says. */
  readonly calculation = new Values();
  readonly preview = new Signal<Preview>({ state: "none" });
  readonly calculating = new Signal(false);
  /** What happened last, to see and to hear. */
  readonly announcement = new Signal("");
  /** Sections of the preview that are on the screen. */
  readonly visible = new Set<string>();
  /** What links in sections lead to, by anchor. */
  readonly explained = new Map<string, string>();

  /** Whether a change is being kept: another one would be made of the same file. */
  readonly keeping = new Signal(false);
  /** Whether all models are being changed. */
  readonly changingAll = new Signal(false);
  /** What could not be done with the model that is open, by one of its buttons. */
  readonly failed = new Signal<Failure | null>(null);
  /** Results that were downloaded. */
  readonly saved = new Set<string>();

  readonly #valuesByVerb = new Map<string, ReadonlyMap<string, Value>>();

  constructor(readonly engine: Client) {}

  /** Shows the form of another verb, with the values that it had before, or with `values`. */
  setVerb(verb: string, values?: ReadonlyMap<string, Value>): void {
    if (verb === this.verb.value && !values) return;
    if (verb !== this.verb.value) this.#valuesByVerb.set(this.verb.value, this.values.all());
    // The new form never has the values of the old one, not even for a moment.
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

  /** Replaces a model by what `change` makes of it, if it is still open. */
  update(id: number, change: (model: OpenModel) => OpenModel): void {
    this.models.set(this.models.value.map((model) => (model.id === id ? change(model) : model)));
  }

  announce(text: string): void {
    // The same text twice is announced twice.
    this.announcement.set("");
    this.announcement.set(text);
  }

  remember(explained: readonly { id: string; html: string }[] | undefined): void {
    for (const { id, html } of explained ?? []) this.explained.set(id, html);
  }
}
