// A slider for masses, and buttons for common masses. Each step is a factor, not a number of kilograms.

import { button, el, setText } from "../dom/element";
import { digits, kilograms } from "../dom/number";
import { numberIn } from "./check";
import type { Context, Control } from "./context";
import type { Field } from "./declaration";

/** A step of the slider in powers of ten: 1.2 %. */
const STEP = 0.005;
/** The slider goes from a quarter of the model's mass to four times, and holds all animals. Typed numbers can go further. */
const RANGE = 4;
/** Animals of Table 1 of the paper, kg, the lightest first. */
const ANIMALS: readonly [string, number][] = [["mouse", 0.0209], ["emu", 37.8], ["human", 62], ["horse", 545], ["giraffe", 1190]];

export function massSlider(field: Field, context: Context): Control {
  const slider = el("input", { type: "range", class: "slider", "aria-label": `${field.label}, slider` });
  const marks = [el("span"), el("span"), el("span")] as const;
  const scale = el("div", { class: "scale", "aria-hidden": "true" }, ...marks);
  const set = (mass: number) => context.values.choose(field.name, digits(mass, 6));
  const ownButton = button("", () => set(context.modelMass() ?? 0), { class: "small" });
  const double = button("×2", () => set(2 * (typedMass(field, context) ?? context.modelMass() ?? 0)), { class: "small", "aria-label": "Twice the mass" });
  const half = button("÷2", () => set((typedMass(field, context) ?? context.modelMass() ?? 0) / 2), { class: "small", "aria-label": "Half the mass" });
  const animals = ANIMALS.map(([name, mass]) => button(name, () => set(mass), { class: "small", title: massText(mass), "aria-label": `${name}, ${massText(mass)}` }));
  const quick = el("div", { class: "quick", role: "group", "aria-label": "Masses to choose" }, ownButton, half, double, ...animals);
  slider.addEventListener("input", () => context.values.choose(field.name, massAt(slider.valueAsNumber)));
  let middle = 0;
  const refresh = () => {
    const modelMass = context.modelMass();
    for (const one of [ownButton, double, half]) one.hidden = modelMass === undefined;
    setText(ownButton, `own mass: ${kilograms(modelMass ?? 0)}`);
    if (middle !== (modelMass ?? 62)) {
      middle = modelMass ?? 62;
      const masses = [middle / RANGE, middle * RANGE, ...ANIMALS.map(([, mass]) => mass)];
      const [least, most] = [Math.floor(Math.log10(Math.min(...masses)) / STEP) * STEP, Math.ceil(Math.log10(Math.max(...masses)) / STEP) * STEP];
      Object.assign(slider, { min: String(least), max: String(most), step: String(STEP) });
      for (const [index, place] of [least, Math.log10(middle), most].entries()) {
        const element = marks[index] ?? scale;
        setText(element, massText(10 ** place));
        element.style.left = `${(100 * (place - least)) / (most - least)}%`;
        // Near an end, its mark has no room: from 66 kg on it would touch that of the giraffe.
        element.hidden = place === Math.log10(middle) && Math.abs((2 * place - least - most) / (most - least)) > 0.47;
      }
    }
    const typed = typedMass(field, context);
    const mass = typed ?? middle;
    const place = Math.log10(mass);
    // Setting the place that the user has just chosen would make the slider jump.
    if (massAt(slider.valueAsNumber) !== massAt(place)) slider.value = String(place);
    slider.setAttribute("aria-valuetext", typed === undefined ? `not set; ${massText(mass)} now` : massText(mass));
  };
  return { element: el("div", { class: "slide" }, slider, scale, quick), refresh };
}

/** The mass in the field, if it is a positive number. */
function typedMass(field: Field, context: Context): number | undefined {
  const typed = numberIn(context.values.text(field.name)) ?? 0;
  return typed > 0 ? typed : undefined;
}

/** The mass at a place of the slider, with three digits. */
function massAt(place: number): string {
  return digits(10 ** place, 3);
}

function massText(mass: number): string {
  if (mass < 0.1) return `${digits(mass * 1000, 3)} g`;
  return mass < 10_000 ? `${digits(mass, 3)} kg` : `${digits(mass / 1000, 3)} t`;
}
