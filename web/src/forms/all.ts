// The forms that the build made from the schemas of requests.

import { packed } from "../engine/unpack";
import type { ChangeForm, Field, Form, Forms } from "./declaration";

const forms = JSON.parse(packed("forms")) as Forms;

export const CHANGES: readonly ChangeForm[] = forms.changes;
export const CALCULATOR: Form = forms.calculator;
export const QUESTIONS: Form = forms.questions;

export function findForm(verb: string): ChangeForm | undefined {
  return CHANGES.find((form) => form.verb === verb);
}

/** The declaration of a field by its name, first in `form`, then in all other forms. */
export function findField(name: string, form: Form): Field | undefined {
  const forms = [form, QUESTIONS, ...CHANGES];
  return forms.flatMap(({ fields }) => fields).find((field) => field.name === name);
}
