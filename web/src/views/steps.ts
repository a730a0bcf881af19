// The changes that were kept: which hold, and a way back and forth.

import { button, el } from "../dom/element";
import type { OpenModel } from "../state/model";

interface Acts {
  undo(): void;
  redo(): void;
  goTo(at: number): void;
}

/** Buttons to go back and forth among the steps of a model. */
export function stepButtons(model: OpenModel, acts: Acts): HTMLElement[] {
  const undo = button("Undo", acts.undo, { id: "undo", disabled: model.at === 0, "aria-keyshortcuts": "Control+Z" });
  const redo = button("Redo", acts.redo, { id: "redo", disabled: model.at === model.steps.length, "aria-keyshortcuts": "Control+Shift+Z" });
  return [undo, redo];
}

/** The steps as a list; nothing where there are none. */
export function stepList(model: OpenModel, acts: Acts): HTMLElement[] {
  if (model.steps.length === 0) return [];
  const opened = entry(`Opened ${model.origin}`, 0, model, acts);
  const made = model.steps.map(({ text, name }, index) => entry(`${text} → ${name}`, index + 1, model, acts));
  return [el("ol", { class: "steps", "aria-label": "Steps" }, opened, ...made)];
}

function entry(text: string, at: number, model: OpenModel, acts: Acts): HTMLElement {
  const now = at === model.at;
  const content = now ? el("strong", {}, text) : button(text, () => acts.goTo(at), { class: "link" });
  return el("li", { class: at > model.at ? "undone" : undefined, "aria-current": now ? "step" : undefined }, content);
}

