// Shows a form: main fields first, all others in groups that are closed at first.

import { el, setText } from "../dom/element";
import type { Context, Control } from "./context";
import { control } from "./control";
import type { Field, Form } from "./declaration";

export interface FormView {
  element: HTMLElement;
  /** Call this when the options may have changed. */
  refresh(): void;
  /** Call this when the form is removed. */
  end(): void;
}

export function showForm(form: Form, context: Context): FormView {
  const controls = new Map(form.fields.map((field) => [field.name, control(field, context)]));
  const mainFields = form.fields.filter(({ group }) => group === "");
  const groupedFields = form.fields.filter(({ group }) => group !== "");
  const count = el("span", { class: "quiet" });
  const more = el("details", { class: "more", id: `${context.prefix}-more` },
    el("summary", {}, "More options ", count), ...groups(groupedFields, controls));
  const hint = el("p", { class: "relation", role: "status" });
  const mainElements = mainFields.map(({ name }) => elementOf(controls, name));
  const element = el("div", { class: "form" }, ...mainElements, hint, ...(groupedFields.length > 0 ? [more] : []));
  const update = (choices: boolean, name: string | null) => {
    for (const [fieldName, { refresh }] of controls) if (name === null || fieldName === name) refresh(choices);
    const setCount = groupedFields.filter((field) => context.values.get(field.name) !== undefined).length;
    setText(count, setCount > 0 ? `(${setCount} set)` : "");
    setText(hint, relationHint(form, context));
  };
  update(true, null);
  const end = context.values.watch((name) => update(false, name));
  return { element, refresh: () => update(true, null), end };
}

function elementOf(controls: ReadonlyMap<string, Control>, name: string): HTMLElement {
  return controls.get(name)?.element ?? el("div");
}

function groups(fields: readonly Field[], controls: ReadonlyMap<string, Control>): HTMLElement[] {
  const titles = [...new Set(fields.map(({ group }) => group))];
  return titles.map((title) => {
    const members = fields.filter(({ group }) => group === title).map(({ name }) => elementOf(controls, name));
    return el("fieldset", { class: "group" }, el("legend", {}, title), ...members);
  });
}

/** A hint if the values of the form exclude each other, or if one needs another. */
function relationHint(form: Form, { values }: Pick<Context, "values">): string {
  const isGiven = (name: string) => values.get(name) !== undefined;
  const label = (name: string) => `“${form.fields.find((field) => field.name === name)?.label ?? name}”`;
  const excluded = form.excludes.find((pair) => pair.every(isGiven));
  if (excluded) return `${excluded.map(label).join(" and ")} exclude each other.`;
  const unmet = form.needs.find(([name, others]) => isGiven(name) && !others.some(isGiven));
  return unmet ? `${label(unmet[0])} needs ${unmet[1].map(label).join(" or ")}.` : "";
}
