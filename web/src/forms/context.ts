// What the controls of a form share.

import type { Source } from "./declaration";
import type { Values } from "./values";

/** Something to choose. */
export interface Option {
  value: string;
  text: string;
  /** Options with the same heading are together. */
  heading?: string;
  /** Fields that must be given with it. */
  alsoSets?: Readonly<Record<string, string>>;
}

export interface Context {
  values: Values;
  /** What ids of the form's elements begin with. */
  prefix: string;
  /** Whether a value counts while it is typed, or when it is complete. */
  commit: "input" | "change";
  /** What there is to choose from. */
  options(source: Source): Option[];
  /** Lets the user add files; gives their names. */
  addFile(source: Source): Promise<string[]>;
  /** The value of a property in the model, where it has one. */
  currentValue(property: string): string | undefined;
  /** What the model weighs, kg; where that is not known, what its contacts were made for. */
  modelMass(): number | undefined;
}

/** A field on the page. */
export interface Control {
  element: HTMLElement;
  /** Shows what the form says now; `choices`: what there is to choose from may be other than before. */
  refresh(choices: boolean): void;
}
