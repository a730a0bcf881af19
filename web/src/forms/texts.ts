// A field for several texts: the user ticks names of the model or types patterns.

import { el, setText } from "../dom/element";
import type { Context, Control } from "./context";
import type { Field } from "./declaration";
import { inputId } from "./frame";
import { splitLines } from "./simple";

export function textsControl(field: Field, context: Context): Control {
  const id = inputId(field, context);
  const list = el("div", { class: "ticks" });
  const state = el("span", { class: "quiet" });
  const patterns = field.source === "properties" ? undefined : patternsBox(field, context, id);
  const help = field.help ? [el("p", { class: "help", id: `${id}-help` }, field.help)] : [];
  const describedBy = field.help ? `${id}-help` : undefined;
  const group = el("fieldset", { "aria-describedby": describedBy }, el("legend", { class: "hidden" }, field.label), list, ...(patterns ? [patterns.element] : []), ...help);
  const details = el("details", { class: "field picker", id }, el("summary", {}, field.label, " ", state), group);
  let shownValues = "";
  const refresh = (choices: boolean) => {
    const chosen = new Set(context.values.texts(field.name));
    setText(state, chosen.size === 0 ? (field.default ?? "") : [...chosen].join(", "));
    const values = (field.source ? context.options(field.source) : []).map(({ value }) => value);
    if (choices && shownValues !== values.join("\n")) {
      shownValues = values.join("\n");
      list.replaceChildren(...values.map((value) => tick(field, context, value)));
    }
    for (const input of list.querySelectorAll("input")) input.checked = chosen.has(input.value);
    patterns?.show([...chosen].filter((text) => !values.includes(text)));
  };
  return { element: details, refresh };
}

function tick(field: Field, context: Context, value: string): HTMLElement {
  const input = el("input", { type: "checkbox", value });
  input.addEventListener("change", () => {
    const others = context.values.texts(field.name).filter((text) => text !== value);
    context.values.set(field.name, input.checked ? [...others, value] : others);
  });
  return el("label", {}, input, " ", el("span", {}, value));
}

function patternsBox(field: Field, context: Context, id: string): { element: HTMLElement; show(lines: string[]): void } {
  const input = el("textarea", { rows: 1, id: `${id}-patterns`, spellcheck: "false", placeholder: "*_r" });
  input.addEventListener(context.commit, () => {
    const names = new Set((field.source ? context.options(field.source) : []).map(({ value }) => value));
    const ticked = context.values.texts(field.name).filter((text) => names.has(text));
    context.values.set(field.name, [...ticked, ...splitLines(input.value)]);
  });
  const label = el("label", { for: input.id }, "Names or patterns, one per line");
  const show = (lines: string[]) => {
    if (splitLines(input.value).filter((line) => !lines.includes(line)).length > 0 || lines.some((line) => !input.value.includes(line))) {
      if (document.activeElement !== input) input.value = lines.join("\n");
    }
  };
  return { element: el("div", { class: "patterns" }, label, input), show };
}
