// A model that is open, and the changes that were kept.

import type { Failure, Inspected, Request, Section } from "../engine/types";
import { Values } from "../forms/values";

/** A change that was kept: it made a new file. */
export interface Step {
  text: string;
  /** The new model's file. */
  name: string;
  /** All files that it made. */
  names: string[];
  request: Request;
  /** What it changed, to show. */
  sections: Section[];
  counts: string;
}

/** What the current change did to this model among several. */
export type Outcome = { state: "done"; text: string } | { state: "same"; text: string } | { state: "failed"; failure: Failure };

export interface OpenModel {
  readonly id: number;
  /** The file that was opened. */
  readonly origin: string;
  readonly steps: readonly Step[];
  /** How many of the steps hold: fewer than there are after an undo. */
  readonly stepCount: number;
  /** What the user answered about this model; it goes along with every request. */
  readonly answers: Values;
  readonly inspected: Inspected | null;
  readonly failure: Failure | null;
  /** Its own target mass, where several models are changed at once. */
  readonly targetMass: string;
  readonly outcome: Outcome | null;
}

let last = 0;

export function newModel(origin: string): OpenModel {
  last += 1;
  const start = { steps: [], stepCount: 0, inspected: null, failure: null, targetMass: "", outcome: null };
  return { id: last, origin, answers: new Values(), ...start };
}

/** The file that holds the model as it is now. */
export function currentFile(model: OpenModel): string {
  return model.steps[model.stepCount - 1]?.name ?? model.origin;
}

/** The step that was made last and holds. */
export function currentStep(model: OpenModel): Step | undefined {
  return model.steps[model.stepCount - 1];
}

/** Whether the model as it is now was read from a file of this name. */
export function uses(model: OpenModel, name: string): boolean {
  // Models name their files by paths of their own.
  return currentFile(model) === name || (model.inspected?.files ?? []).some((file) => lastName(file) === lastName(name));
}

function lastName(path: string): string {
  return path.split(/[/\\]/).pop() ?? path;
}

/** The model after one more step; steps that were undone are gone. */
export function withStep(model: OpenModel, step: Step): OpenModel {
  const steps = [...model.steps.slice(0, model.stepCount), step];
  return { ...model, steps, stepCount: steps.length, outcome: null };
}

/** The model after `at` of its steps. */
export function atStep(model: OpenModel, stepCount: number): OpenModel {
  return { ...model, stepCount: Math.max(0, Math.min(model.steps.length, stepCount)), outcome: null };
}
