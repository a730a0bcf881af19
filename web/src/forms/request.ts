// From what a form says to a request, and what keeps it from being one.

import type { Request } from "../engine/types";
import type { Field, Form } from "./declaration";
import { numberIn, valueProblem } from "./check";
import type { Value, Values } from "./values";

/** The fields that the form says, as a request has them. */
export function givenFields(form: Form, values: Values): Record<string, unknown> {
  const entries = form.fields.flatMap((field): [string, unknown][] => {
    const value = values.get(field.name);
    return value === undefined ? [] : [[field.name, requestValue(field, value)]];
  });
  return Object.fromEntries(entries);
}

/** The request of a form about a model; what was answered about the model holds unless the form says otherwise. */
export function buildRequest(form: Form, values: Values, model: string, answers: Record<string, unknown>): Request {
  return { verb: form.verb, models: [model], ...answers, ...givenFields(form, values) };
}

function requestValue(field: Field, value: Value): unknown {
  switch (field.kind) {
    case "number":
    case "integer":
    case "rule":
      return typeof value === "string" ? numeric(value) : value;
    case "map":
      return typeof value === "object" ? numericEntries(value as Readonly<Record<string, string>>) : value;
    default:
      return value;
  }
}

/** A number as one; any other text as it is, for the engine to say what is wrong with it. Its factors begin with an x. */
export function numeric(text: string): number | string {
  return numberIn(text) ?? text.trim().replace(/^×/, "x");
}

function numericEntries(entries: Readonly<Record<string, string>>): Record<string, number | string> {
  return Object.fromEntries(Object.entries(entries).map(([name, text]) => [name, numeric(text)]));
}

/** Problems of what was typed, by field; empty where the request can be asked. */
export function problems(form: Form, values: Values): Map<string, string> {
  const entries = form.fields.flatMap((field): [string, string][] => {
    const value = values.get(field.name);
    const problem = value === undefined ? undefined : valueProblem(field, value);
    return problem ? [[field.name, problem]] : [];
  });
  return new Map(entries);
}

/** Fields that must be given and are not; the first of two, if one or the other must be. */
export function missingFields(form: Form, values: Values): Field[] {
  const isGiven = (name: string): boolean => values.get(name) !== undefined;
  const missing = form.either.filter((pair) => !pair.some(isGiven)).map(([first]) => first);
  const names = [...form.required.filter((name) => !isGiven(name)), ...missing];
  return form.fields.filter(({ name }) => names.includes(name));
}

/** Whether the form says anything at all. */
export function isEmpty(form: Form, values: Values): boolean {
  return form.fields.every(({ name }) => values.get(name) === undefined);
}
