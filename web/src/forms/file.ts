// A field for a file: an open file, or a file that the user adds.

import { button, el } from "../dom/element";
import type { Context, Control, SelectOption } from "./context";
import type { Field } from "./declaration";
import { frame } from "./frame";

export function fileControl(field: Field, context: Context): Control {
  const source = field.source ?? "models";
  const select = el("select", { name: field.name });
  const alsoSet = (chosen: string) => context.options(source).find(({ value }) => value === chosen)?.alsoSets ?? {};
  select.addEventListener("change", () => {
    const before = alsoSet(context.values.text(field.name));
    const now = alsoSet(select.value);
    context.values.set(field.name, select.value);
    // Fields that only the old option has set are cleared.
    for (const [name, value] of Object.entries(before)) {
      if (!(name in now) && context.values.text(name) === value) context.values.set(name, "");
    }
    for (const [name, value] of Object.entries(now)) context.values.set(name, value);
  });
  const add = button("Add a file…", () => void context.addFile(source).then(([name]) => name && context.values.set(field.name, name)), {
    class: "small",
  });
  add.append(el("span", { class: "hidden" }, ` for “${field.label}”`));
  const { element, check } = frame(field, context, select, el("div", { class: "box" }, select, add));
  let shownOptions = "";
  const refresh = (choices: boolean) => {
    const value = context.values.text(field.name);
    if (choices) {
      const options = withValue(withPresets(context.options(source), field), value);
      const key = JSON.stringify(options);
      const none = el("option", { value: "" }, options.length > 0 ? "not set" : "none here yet");
      if (key !== shownOptions) select.replaceChildren(none, ...optionElements(options));
      shownOptions = key;
    }
    select.value = value;
    check();
  };
  return { element, refresh };
}

/** The options, and presets that only this field has. */
function withPresets(options: SelectOption[], { choices = [] }: Field): SelectOption[] {
  const others = choices.filter(({ value }) => !options.some((option) => option.value === value));
  return [...options, ...others.map((choice) => ({ ...choice, heading: "Presets" }))];
}

/** The options, and the current value, which may name a file that is not open. */
function withValue(options: SelectOption[], value: string): SelectOption[] {
  const isListed = value === "" || options.some((option) => option.value === value);
  return isListed ? options : [...options, { value, text: `${value} (not here)` }];
}

function optionElements(options: readonly SelectOption[]): HTMLElement[] {
  const headings = [...new Set(options.map(({ heading }) => heading ?? ""))];
  return headings.flatMap((heading) => {
    const members = options.filter((option) => (option.heading ?? "") === heading);
    const elements = members.map(({ value, text }) => el("option", { value }, text));
    return heading === "" ? elements : [el("optgroup", { label: heading }, ...elements)];
  });
}
