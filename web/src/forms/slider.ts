// A slider over masses around that of the model, and masses to choose: each step is the same factor, not the same number of kilograms.

import { button, el, setText } from "../dom/element";
import { digits, kilograms } from "../dom/number";
import { numberIn } from "./check";
import type { Context, Control } from "./context";
import type { Field } from "./declaration";

/** From a quarter of the model's mass to four times. Numbers that are typed reach further. */
const REACH = Math.log10(4);
const STEPS = 120;
/** Animals of Table 1 of the paper, kg. */
const ANIMALS: readonly [string, number][] = [["mouse", 0.0209], ["emu", 37.8], ["human", 62], ["horse", 545], ["giraffe", 1190]];

export function massSlider(field: Field, context: Context): Control {
  const slider = el("input", { type: "range", class: "slider", "aria-label": `${field.label}, slider` });
  const marks = [0, 0.5, 1].map((share) => mark(share));
  const scale = el("div", { class: "scale", "aria-hidden": "true" }, ...marks);
  const set = (mass: number) => context.values.choose(field.name, digits(mass, 6));
  const own = button("", () => set(context.ownMass() ?? 0), { class: "small" });
  const double = button("×2", () => set(2 * (said(field, context) ?? context.ownMass() ?? 0)), { class: "small", "aria-label": "Twice the mass" });
  const half = button("÷2", () => set((said(field, context) ?? context.ownMass() ?? 0) / 2), { class: "small", "aria-label": "Half the mass" });
  const animals = ANIMALS.map(([name, mass]) => button(name, () => set(mass), { class: "small", title: massText(mass), "aria-label": `${name}, ${massText(mass)}` }));
  const quick = el("div", { class: "quick", role: "group", "aria-label": "Masses to choose" }, own, half, double, ...animals);
  slider.addEventListener("input", () => context.values.choose(field.name, massAt(slider.valueAsNumber)));
  let middle = 0;
  const refresh = () => {
    const known = context.ownMass();
    for (const one of [own, double, half]) one.hidden = known === undefined;
    setText(own, `own mass: ${kilograms(known ?? 0)}`);
    if (middle !== (known ?? 62)) {
      middle = known ?? 62;
      const [least, most] = [Math.log10(middle) - REACH, Math.log10(middle) + REACH];
      Object.assign(slider, { min: String(least), max: String(most), step: String((2 * REACH) / STEPS) });
      for (const [index, factor] of [0.25, 1, 4].entries()) setText(marks[index] ?? scale, massText(middle * factor));
    }
    const given = said(field, context);
    const mass = given ?? middle;
    const place = Math.log10(mass);
    // Moving it to where the user just moved it would make it jump.
    if (massAt(slider.valueAsNumber) !== massAt(place)) slider.value = String(place);
    slider.setAttribute("aria-valuetext", given === undefined ? `not set; ${massText(mass)} now` : massText(mass));
  };
  return { element: el("div", { class: "slide" }, slider, scale, quick), refresh };
}

/** The mass that is typed. */
function said(field: Field, context: Context): number | undefined {
  const typed = numberIn(context.values.text(field.name)) ?? 0;
  return typed > 0 ? typed : undefined;
}

/** The mass at a place of the slider, to three digits, as people would write it. */
function massAt(place: number): string {
  return digits(10 ** place, 3);
}

function massText(mass: number): string {
  if (mass < 0.1) return `${digits(mass * 1000, 3)} g`;
  return mass < 10_000 ? `${digits(mass, 3)} kg` : `${digits(mass / 1000, 3)} t`;
}

function mark(share: number): HTMLElement {
  const made = el("span");
  made.style.left = `${share * 100}%`;
  return made;
}
