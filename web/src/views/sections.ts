// Places for sections of the engine's renderer. Equal content is not replaced, so that a slider moves smoothly.

import { el, setText } from "../dom/element";
import { parseHtml } from "../dom/markup";
import { digits } from "../dom/number";
import type { Section } from "../engine/types";

export interface SectionPlace {
  element: HTMLElement;
  /** Shows a section; without one, hides the place. */
  show(section: Section | undefined): void;
}

interface Options {
  /** The prefix of ids in the place. */
  prefix: string;
  id: string;
  /** Whether the section is closed until its heading is clicked. */
  folded?: boolean;
  /** The heading, in place of the section's title. */
  title?: string;
}

/** A place for one section. */
export function placeSection({ prefix, id, folded = false, title }: Options): SectionPlace {
  const heading = el("h3", { id: `${prefix}-${id}-title` }, title ?? "");
  const body = el("div", { class: "body" });
  const element = folded
    ? el("details", { id: `${prefix}-${id}`, class: `section of-${id}`, hidden: true }, el("summary", {}, heading), body)
    : el("div", { id: `${prefix}-${id}`, class: `section of-${id}`, hidden: true }, heading, body);
  const scrolled = watchScrolling(body);
  let shownHtml: string | undefined;
  const show = (section: Section | undefined) => {
    element.hidden = section === undefined || section.html === "";
    if (section === undefined || section.html === shownHtml) return;
    shownHtml = section.html;
    setText(heading, title ?? section.title);
    const content = parseHtml(section.html);
    for (const cell of content.querySelectorAll("td")) shortenCell(cell);
    replaceContent(body, content, scrolled);
  };
  return { element, show };
}

/** Shows a number with four digits; all of them are its title. */
function shortenCell(cell: HTMLElement): void {
  const place = cell.querySelector("b") ?? cell;
  const whole = place.textContent ?? "";
  const [, sign = "", number = ""] = /^(×?)(-?\d[\d.]{4,}(?:e-?\d+)?)$/.exec(whole) ?? [];
  const significant = number.replace(/e.*|\D/g, "").replace(/^0+/, "");
  if (significant.length <= 4) return;
  const short = `${sign}${digits(Number(number))}`;
  cell.title = whole;
  place.textContent = short;
}

/** How far each box in `body` is scrolled, by its index. To ask the boxes at each step of a slider would lay out the page once more. */
function watchScrolling(body: HTMLElement): ReadonlyMap<number, number> {
  const scrolled = new Map<number, number>();
  const remember = ({ target }: Event) => target instanceof Element && scrolled.set(boxesIn(body).indexOf(target), target.scrollLeft);
  body.addEventListener("scroll", remember, { capture: true, passive: true });
  return scrolled;
}

function boxesIn(body: HTMLElement): Element[] {
  return [...body.querySelectorAll(".wide, .plot.feet")];
}

/** Replaces the content of `body`, and restores scroll positions and the focus. */
function replaceContent(body: HTMLElement, content: DocumentFragment, scrolled: ReadonlyMap<number, number>): void {
  const focused = [...body.querySelectorAll("a, [tabindex]")].indexOf(document.activeElement ?? body);
  body.replaceChildren(content);
  if (scrolled.size > 0) for (const [index, box] of boxesIn(body).entries()) box.scrollLeft = scrolled.get(index) ?? 0;
  if (focused >= 0) [...body.querySelectorAll<HTMLElement>("a, [tabindex]")][focused]?.focus({ preventScroll: true });
}
