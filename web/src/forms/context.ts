// Data and functions that all controls of a form use.

import type { Source } from "./declaration";
import type { Values } from "./values";

/** An option of a field. */
export interface SelectOption {
  value: string;
  text: string;
  /** Options with the same heading are one group. */
  heading?: string;
  /** Other fields that this option sets. */
  alsoSets?: Readonly<Record<string, string>>;
}

export interface Context {
  values: Values;
  /** The prefix of the ids of the form's elements. */
  prefix: string;
  /** The event that sets a value: while the user types, or when the value is complete. */
  commit: "input" | "change";
  /** The options of a source. */
  options(source: Source): SelectOption[];
  /** Lets the user add files; returns their names. */
  addFile(source: Source): Promise<string[]>;
  /** The value of a property in the model, if it has one for all spheres or forces. */
  currentValue(property: string): string | undefined;
  /** The mass of the model, kg; if that is not known, the mass that its contacts were made for. */
  modelMass(): number | undefined;
}

/** A field on the page. */
export interface Control {
  element: HTMLElement;
  /** Shows the current value; `choices`: the options may have changed. */
  refresh(choices: boolean): void;
}
