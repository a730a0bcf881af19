// An open model and the changes that were applied to it.

import type { Failure, Inspected, Request } from "../engine/types";
import { Values } from "../forms/values";

/** A change that was applied: it made a new file. */
export interface Step {
  text: string;
  /** The new model's file. */
  name: string;
  /** All files that the change made. */
  names: string[];
}

/** The outcome of the current change for one of several models. */
export type Outcome = { state: "done"; text: string } | { state: "same"; text: string } | { state: "failed"; failure: Failure };

export interface OpenModel {
  readonly id: number;
  /** The file that was opened. */
  readonly origin: string;
  readonly steps: readonly Step[];
  /** How many of the steps are applied: fewer than all after an undo. */
  readonly stepCount: number;
  /** The user's answers about this model, for every request. */
  readonly answers: Values;
  readonly inspected: Inspected | null;
  readonly failure: Failure | null;
  /** The target mass of this model, if several models are changed at once. */
  readonly targetMass: string;
  readonly outcome: Outcome | null;
  /** Files of open models that were compared with this one, to find its original: each once. */
  readonly seen: Set<string>;
  /** Those that may be its original. */
  readonly originals: readonly string[];
}

let last = 0;

export function newModel(origin: string): OpenModel {
  last += 1;
  const start = { steps: [], stepCount: 0, originals: [], inspected: null, failure: null, targetMass: "", outcome: null };
  return { id: last, origin, answers: new Values(), seen: new Set(), ...start };
}

/** The file of the model after its current step. */
export function currentFile(model: OpenModel): string {
  return model.steps[model.stepCount - 1]?.name ?? model.origin;
}

/** The last step that is applied. */
export function currentStep(model: OpenModel): Step | undefined {
  return model.steps[model.stepCount - 1];
}

/** Whether the current model was read from a file of this name. */
export function uses(model: OpenModel, name: string): boolean {
  // A model names its files by paths that the page does not know; only the last parts are compared.
  return currentFile(model) === name || (model.inspected?.files ?? []).some((file) => lastName(file) === lastName(name));
}

function lastName(path: string): string {
  return path.split(/[/\\]/).pop() ?? path;
}

/** The model after one more step, without the steps that were undone. */
export function withStep(model: OpenModel, step: Step): OpenModel {
  const steps = [...model.steps.slice(0, model.stepCount), step];
  return { ...model, steps, stepCount: steps.length, outcome: null };
}

/** The model after its first `at` steps. */
export function atStep(model: OpenModel, stepCount: number): OpenModel {
  return { ...model, stepCount: Math.max(0, Math.min(model.steps.length, stepCount)), outcome: null };
}

/** Masses that differ by at most this part of the smaller one count as one body. */
const SAME_MASS = 0.02;

export function isSameMass(one: number, other: number): boolean {
  return Math.abs(one - other) <= SAME_MASS * Math.min(one, other);
}

/** Whether a model has no contact forces that can be changed. */
export function isBare({ inspection }: Inspected): boolean {
  return inspection.forces.length === 0;
}

/** Whether contacts can be added before all else. Forces of a misspelt class are no reason to add others. */
export function lacksContacts(inspected: Inspected): boolean {
  return isBare(inspected) && !inspected.findings.some(({ severity }) => severity === "error");
}

/** The change that the check proposes for what is wrong. */
export function proposedRequest({ findings }: Inspected): Request | undefined {
  return findings.find(({ remedy, severity }) => remedy && severity !== "remark")?.remedy?.request;
}

const MISPLACED = new Set(["spheres-left-behind", "spheres-misplaced"]);

/** Whether a finding says that spheres are not where the bones are. A remark about a heel without spheres does not count. */
export function hasMisplacedSpheres({ findings }: Inspected): boolean {
  return findings.some(({ code, severity }) => MISPLACED.has(code) && severity !== "remark");
}
