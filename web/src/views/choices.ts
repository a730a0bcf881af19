// A row of radio buttons.

import { el } from "../dom/element";

let last = 0;

export function choices<T extends string>(title: string, all: readonly (readonly [T, string])[], chosen: T, choose: (one: T) => void): HTMLElement {
  last += 1;
  const name = `choices-${last}`;
  const radios = all.map(([value, text]) => {
    const input = el("input", { type: "radio", name, value, checked: value === chosen });
    input.addEventListener("change", () => choose(value));
    return el("label", { class: "verb small" }, input, el("span", {}, text));
  });
  return el("fieldset", { class: "choices" }, el("legend", { class: "hidden" }, title), ...radios);
}
