// Fields of one element: a check box, a choice, a line of text, several lines.

import { el } from "../dom/element";
import type { Context, Control } from "./context";
import type { Field } from "./declaration";
import { frame, inputId } from "./frame";

export function flagControl(field: Field, context: Context): Control {
  const id = inputId(field, context);
  const input = el("input", { type: "checkbox", id, name: field.name });
  if (field.help) input.setAttribute("aria-describedby", `${id}-help`);
  input.addEventListener("change", () => context.values.set(field.name, input.checked));
  const help = field.help ? [el("p", { class: "help", id: `${id}-help` }, field.help)] : [];
  const element = el("div", { class: "field flag" }, el("label", { for: id }, input, " ", field.label), ...help);
  return { element, refresh: () => void (input.checked = context.values.get(field.name) === true) };
}

export function choiceControl(field: Field, context: Context): Control {
  const emptyText = field.default ? `default: ${field.default}` : "not set";
  const options = (field.choices ?? []).map(({ value, text }) => el("option", { value }, text));
  const select = el("select", { name: field.name }, el("option", { value: "" }, emptyText), ...options);
  select.addEventListener("change", () => context.values.set(field.name, select.value));
  const { element, check } = frame(field, context, select, select);
  const refresh = () => {
    select.value = context.values.text(field.name);
    check();
  };
  return { element, refresh };
}

export function textControl(field: Field, context: Context): Control {
  const input = el("input", { type: "text", name: field.name, autocomplete: "off", spellcheck: "false" });
  input.addEventListener(context.commit, () => context.values.set(field.name, input.value.trim()));
  const { element } = frame(field, context, input, input);
  const refresh = () => {
    const text = context.values.text(field.name);
    if (input.value.trim() !== text) input.value = text;
  };
  return { element, refresh };
}

export function linesControl(field: Field, context: Context): Control {
  const input = el("textarea", { rows: 2, name: field.name, spellcheck: "false", placeholder: "one per line" });
  input.addEventListener(context.commit, () => context.values.set(field.name, splitLines(input.value)));
  const { element } = frame(field, context, input, input);
  const refresh = () => {
    const lines = context.values.texts(field.name);
    if (splitLines(input.value).join("\n") !== lines.join("\n")) input.value = lines.join("\n");
  };
  return { element, refresh };
}

/** The lines of a text that are not blank. */
export function splitLines(text: string): string[] {
  return text.split("\n").map((line) => line.trim()).filter(Boolean);
}
