// A field for a number; for the target mass with a slider.

import { el } from "../dom/element";
import type { Context, Control } from "./context";
import type { Field } from "./declaration";
import { frame } from "./frame";
import { massSlider } from "./slider";

export function numberControl(field: Field, context: Context): Control {
  const input = el("input", {
    type: "text", inputmode: field.kind === "integer" ? "numeric" : "decimal", autocomplete: "off", spellcheck: "false",
    placeholder: field.default, name: field.name,
  });
  input.addEventListener(context.commit, () => context.values.set(field.name, input.value));
  // A question is answered once and needs no slider.
  const slider = field.name === "target_mass" && context.commit === "input" ? massSlider(field, context) : undefined;
  const { element, check } = frame(field, context, input, input, ...(slider ? [slider.element] : []));
  const refresh = (choices: boolean) => {
    const text = context.values.text(field.name);
    // Blanks that the user is typing stay.
    if (input.value.trim() !== text.trim()) input.value = text;
    slider?.refresh(choices);
    check();
  };
  return { element, refresh };
}
