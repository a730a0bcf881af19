// The list of steps of a model, with buttons to go back and forth.

import { button, el } from "../dom/element";
import type { OpenModel } from "../state/model";

/** The steps as a list; empty if there are none. */
export function stepList(model: OpenModel, goTo: (stepCount: number) => void): HTMLElement[] {
  if (model.steps.length === 0) return [];
  const opened = stepEntry(`Opened ${model.origin}`, 0, model, goTo);
  const entries = model.steps.map(({ text, name }, index) => stepEntry(`${text} → ${name}`, index + 1, model, goTo));
  return [el("ol", { class: "steps", "aria-label": "Steps" }, opened, ...entries)];
}

function stepEntry(text: string, stepCount: number, model: OpenModel, goTo: (stepCount: number) => void): HTMLElement {
  const isCurrent = stepCount === model.stepCount;
  const content = isCurrent ? el("strong", {}, text) : button(text, () => goTo(stepCount), { class: "link" });
  return el("li", { class: stepCount > model.stepCount ? "undone" : undefined, "aria-current": isCurrent ? "step" : undefined }, content);
}
