// Places for sections of the engine's renderer. What stays equal is not replaced, so that a slider moves smoothly, boxes stay scrolled, and the focus stays.

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
  let shownHtml: string | undefined;
  const show = (section: Section | undefined) => {
    element.hidden = section === undefined || section.html === "";
    if (section === undefined || section.html === shownHtml) return;
    shownHtml = section.html;
    setText(heading, title ?? section.title);
    const content = parseHtml(section.html);
    for (const cell of content.querySelectorAll("td")) shortenCell(cell);
    updateChildren(body, content);
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

/** Gives a place the children of `made`. Elements of the same kind stay, so that only what differs is laid out and drawn again. */
function updateChildren(place: Node, made: Node): void {
  const [before, after] = [[...place.childNodes], [...made.childNodes]];
  for (const [index, next] of after.entries()) {
    const old = before[index];
    if (!old) place.appendChild(next);
    else if (old.isEqualNode(next)) continue;
    else if (old instanceof Element && next instanceof Element && old.nodeName === next.nodeName) updateElement(old, next);
    else if (old instanceof Text && next instanceof Text) old.data = next.data;
    else place.replaceChild(next, old);
  }
  for (const surplus of before.slice(after.length)) surplus.remove();
}

function updateElement(old: Element, next: Element): void {
  for (const { name } of [...old.attributes]) if (!next.hasAttribute(name)) old.removeAttribute(name);
  for (const { name, value } of next.attributes) if (old.getAttribute(name) !== value) old.setAttribute(name, value);
  updateChildren(old, next);
}
