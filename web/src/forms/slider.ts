// A slider over masses, from a shrew to a whale: each step is the same factor, not the same number of kilograms.

import { el } from "../dom/element";
import { digits } from "../dom/number";
import { numberIn } from "./check";
import type { Context, Control } from "./context";
import type { Field } from "./declaration";

// Powers of ten: 1 g to 100 t. A step is 1.16 %.
const LEAST = -3;
const MOST = 5;
const STEP = 0.005;
const MARKS: readonly [number, string][] = [[-3, "1 g"], [0, "1 kg"], [3, "1 t"], [5, "100 t"]];

export function massSlider(field: Field, context: Context): Control {
  const slider = el("input", {
    type: "range", min: LEAST, max: MOST, step: STEP, class: "slider", "aria-label": `${field.label}, slider`,
  });
  const scale = el("div", { class: "scale", "aria-hidden": "true" }, ...MARKS.map(mark));
  slider.addEventListener("input", () => context.values.set(field.name, massAt(slider.valueAsNumber)));
  const refresh = () => {
    const typed = numberIn(context.values.text(field.name)) ?? 0;
    const said = typed > 0 ? typed : undefined;
    const mass = said ?? (context.currentMass() || 1);
    const place = Math.log10(mass);
    // Moving it to where the user just moved it would make it jump.
    if (massAt(slider.valueAsNumber) !== massAt(place)) slider.value = String(place);
    slider.setAttribute("aria-valuetext", said === undefined ? `not set; ${massText(mass)} now` : massText(mass));
  };
  return { element: el("div", { class: "slide" }, slider, scale), refresh };
}

/** The mass at a place of the slider, to three digits, as people would write it. */
function massAt(place: number): string {
  return digits(10 ** place, 3);
}

function massText(mass: number): string {
  if (mass < 0.1) return `${digits(mass * 1000, 3)} g`;
  return mass < 10_000 ? `${digits(mass, 3)} kg` : `${digits(mass / 1000, 3)} t`;
}

function mark([place, text]: [number, string]): HTMLElement {
  const made = el("span", {}, text);
  made.style.left = `${((place - LEAST) / (MOST - LEAST)) * 100}%`;
  return made;
}
