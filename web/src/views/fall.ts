// Plays the drop test before and after the change in the view, with curves of the force.

import { el, setText } from "../dom/element";
import { digits } from "../dom/number";
import type { Fall } from "../engine/space";
import { findField, QUESTIONS } from "../forms/all";
import { Curves } from "./curves";
import { Player } from "./player";

/** The fall is shown slower by this factor. */
const SLOW_MOTION_FACTOR = 6;
const NAMES: Readonly<Record<string, string>> = { before: "contacts as they are", after: "new contacts", now: "contacts of the model" };

/** Takes the heights of the new and the old spheres above their places at rest, m, and whether they move. */
type Lift = (body: number, old: number, moves: boolean) => void;

export class FallView {
  readonly element = el("div", { class: "fall", hidden: true });
  readonly #player = new Player({ play: "Let it fall", time: "Time of the fall", id: "play-fall" }, (moment) => this.#showMoment(moment), () => this.lift(0, 0, false));
  readonly #curves = new Curves(130);
  readonly #summary = el("p", { class: "quiet", id: "fall-said" });
  #falls: readonly Fall[] = [];

  constructor(readonly lift: Lift) {
    this.element.append(this.#player.element, this.#curves.element, this.#summary);
  }

  show(falls: readonly Fall[]): void {
    if (falls === this.#falls) return;
    this.#falls = falls;
    const complete = this.#completeFalls();
    this.element.hidden = falls.length === 0;
    const moments = complete[0]?.heights_m.length ?? 0;
    const seconds = (complete[0]?.step_s ?? 0) * Math.max(0, moments - 1);
    this.#player.reset(moments, seconds * SLOW_MOTION_FACTOR);
    this.#curves.element.classList.toggle("none", moments === 0);
    const words = falls.map(describeFall).join(" ");
    setText(this.#summary, words);
    const curves = complete.map(({ name, forces_bw: values }) => ({ kind: name === "before" ? "old" as const : "new" as const, values }));
    this.#curves.show(curves, "force in body weights", `Drop test: ${words}`, 0, seconds);
  }

  #completeFalls(): readonly Fall[] {
    return this.#falls.filter(({ heights_m: heights }) => heights.length > 0);
  }

  /** Shows one moment: lifts the spheres above their final heights. */
  #showMoment(moment: number): void {
    const [old, next] = [this.#completeFalls().find(({ name }) => name === "before"), this.#completeFalls().find(({ name }) => name !== "before")];
    const aboveRest = (fall: Fall | undefined) => fall ? (fall.heights_m[moment] ?? 0) - (fall.heights_m[fall.heights_m.length - 1] ?? 0) : 0;
    this.lift(aboveRest(next), aboveRest(old), true);
    this.#curves.moveCursor(moment);
  }
}

function describeFall({ name, forces_bw: forces, why_not: why, heights_m: heights, radius_m: radius }: Fall): string {
  const which = NAMES[name] ?? name;
  const begin = which.charAt(0).toUpperCase() + which.slice(1);
  const field = (whole: string, named: string) => findField(named, QUESTIONS)?.label.replace(/^.*$/, (label) => `the field “${label.toLowerCase()}”`) ?? whole;
  if (why !== null) return `${begin}: ${why.replace(/`(\w+)`/g, field)}.`;
  const deepest = -Math.min(...heights);
  return `${begin}: at most ${digits(Math.max(...forces), 3)} body weights, up to ${digits(deepest * 1000, 3)} mm deep (${digits(deepest / radius, 2)} of the radius).`;
}
