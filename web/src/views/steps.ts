// The changes that were kept: which hold, and a way back and forth.

import { button, el } from "../dom/element";
import type { OpenModel } from "../state/model";

/** The steps as a list; nothing where there are none. */
export function stepList(model: OpenModel, goTo: (at: number) => void): HTMLElement[] {
  if (model.steps.length === 0) return [];
  const opened = entry(`Opened ${model.origin}`, 0, model, goTo);
  const made = model.steps.map(({ text, name }, index) => entry(`${text} → ${name}`, index + 1, model, goTo));
  return [el("ol", { class: "steps", "aria-label": "Steps" }, opened, ...made)];
}

function entry(text: string, at: number, model: OpenModel, goTo: (at: number) => void): HTMLElement {
  const now = at === model.at;
  const content = now ? el("strong", {}, text) : button(text, () => goTo(at), { class: "link" });
  return el("li", { class: at > model.at ? "undone" : undefined, "aria-current": now ? "step" : undefined }, content);
}
