// Adds label, help and problem to a field.

import { type Child, el, setAttribute, setText } from "../dom/element";
import { valueProblem } from "./check";
import type { Context } from "./context";
import type { Field } from "./declaration";

interface Frame {
  element: HTMLElement;
  /** Checks the value and shows its problem. */
  check(): void;
}

/** The id of a field's input. */
export function inputId(field: Field, context: Context): string {
  return `${context.prefix}-${field.name}`;
}

/** The label with the unit, for screen readers, too. */
function labelText({ label, unit }: Field): Child[] {
  return unit ? [label, " ", el("span", { class: "unit" }, `(${unit})`)] : [label];
}

/** A field around `input`, with label, help and problem. */
export function frame(field: Field, context: Context, input: HTMLElement, ...content: readonly Child[]): Frame {
  const id = inputId(field, context);
  const help = el("p", { class: "help", id: `${id}-help` }, field.help);
  const problem = el("p", { class: "problem", id: `${id}-problem`, role: "alert" });
  input.id = id;
  const describedBy = [field.help && help.id, problem.id].filter(Boolean).join(" ");
  input.setAttribute("aria-describedby", describedBy);
  const label = el("label", { for: id }, ...labelText(field));
  const element = el("div", { class: `field ${field.kind}` }, label, ...content, problem, ...(field.help ? [help] : []));
  const check = () => {
    const value = context.values.get(field.name);
    const text = (value !== undefined && valueProblem(field, value)) || "";
    setText(problem, text);
    setAttribute(input, "aria-invalid", text !== "" && "true");
  };
  return { element, check };
}
