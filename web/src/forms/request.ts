// Makes requests from the values of forms, and finds problems and missing fields.

import type { Request } from "../engine/types";
import type { Field, Form } from "./declaration";
import { numberIn, valueProblem } from "./check";
import type { Value, Values } from "./values";

/** The fields of the form that have values, for a request. */
export function givenFields(form: Form, values: Values): Record<string, unknown> {
  const entries = form.fields.flatMap((field): [string, unknown][] => {
    const value = values.get(field.name);
    return value === undefined ? [] : [[field.name, requestValue(field, value)]];
  });
  return Object.fromEntries(entries);
}

/** The request of a form about a model; values of the form replace the answers about the model. */
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

/** A text as a number; any other text unchanged, so that the engine reports the problem. Factors begin with x. */
export function numeric(text: string): number | string {
  return numberIn(text) ?? text.trim().replace(/^×/, "x");
}

function numericEntries(entries: Readonly<Record<string, string>>): Record<string, number | string> {
  return Object.fromEntries(Object.entries(entries).map(([name, text]) => [name, numeric(text)]));
}

/** Problems of values by field; empty if the request can be sent. */
export function problems(form: Form, values: Values): Map<string, string> {
  const entries = form.fields.flatMap((field): [string, string][] => {
    const value = values.get(field.name);
    const problem = value === undefined ? undefined : valueProblem(field, value);
    return problem ? [[field.name, problem]] : [];
  });
  return new Map(entries);
}

/** Required fields without a value; of two alternatives the first. */
export function missingFields(form: Form, values: Values): Field[] {
  const isGiven = (name: string): boolean => values.get(name) !== undefined;
  const missing = form.either.filter((pair) => !pair.some(isGiven)).map(([first]) => first);
  const names = [...form.required.filter((name) => !isGiven(name)), ...missing];
  return form.fields.filter(({ name }) => names.includes(name));
}

/** Whether no field of the form has a value. */
export function isEmpty(form: Form, values: Values): boolean {
  return form.fields.every(({ name }) => values.get(name) === undefined);
}
