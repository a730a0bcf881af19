// A field for values by property: one line for each property that the model has.

import { el, setAttribute, setText } from "../dom/element";
import type { Context, Control } from "./context";
import type { Field } from "./declaration";
import { valueProblem } from "./check";
import { inputId } from "./frame";

export function mapControl(field: Field, context: Context): Control {
  const id = inputId(field, context);
  const rows = el("div", { class: "rows" });
  const problem = el("p", { class: "problem", id: `${id}-problem`, role: "alert" });
  const help = el("p", { class: "help", id: `${id}-help` }, field.help);
  const element = el("fieldset", { class: "field map", id }, el("legend", {}, field.label), rows, problem, help);
  let shownNames = "";
  const refresh = (choices: boolean) => {
    const entries = context.values.entries(field.name);
    const names = [...new Set([...context.options("properties").map(({ value }) => value), ...Object.keys(entries)])];
    if (choices && shownNames !== names.join("\n")) {
      shownNames = names.join("\n");
      rows.replaceChildren(...names.map((name) => row(field, context, id, name)));
    }
    for (const input of choices ? rows.querySelectorAll("input") : []) {
      const current = context.currentValue(input.name);
      input.placeholder = current === undefined ? "" : `now ${current}`;
    }
    for (const input of rows.querySelectorAll("input")) {
      const text = entries[input.name] ?? "";
      if (input.value.trim() !== text) input.value = text;
      const rowProblem = valueProblem(field, { [input.name]: text || "0" });
      setAttribute(input, "aria-invalid", rowProblem !== undefined && "true");
    }
    setText(problem, valueProblem(field, entries) ?? "");
  };
  return { element, refresh };
}

function row(field: Field, context: Context, id: string, name: string): HTMLElement {
  const input = el("input", {
    type: "text", name, id: `${id}-${name}`, autocomplete: "off", spellcheck: "false",
    "aria-describedby": `${id}-problem ${id}-help`,
  });
  input.addEventListener(context.commit, () => {
    const { [name]: _, ...others } = context.values.entries(field.name);
    const text = input.value.trim();
    context.values.set(field.name, text === "" ? others : { ...others, [name]: text });
  });
  return el("div", { class: "row" }, el("label", { for: input.id }, el("code", {}, name)), input);
}
