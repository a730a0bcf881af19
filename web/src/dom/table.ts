// Creates tables in boxes that scroll if the page is too narrow, with a name for screen readers.

import { type Child, el } from "./element";

/** A heading of a column: `words` if the column has words instead of numbers; `hidden` if it is only for screen readers. */
export interface Head {
  text: string;
  words?: boolean;
  hidden?: boolean;
}

/** A table in a box; `head` and `body` have its rows. */
export function boxedTable(name: string, caption: string, head: HTMLTableRowElement, body: HTMLTableSectionElement): HTMLElement {
  const table = el("table", {}, el("caption", {}, el("span", {}, caption)), el("thead", {}, head), body);
  return el("div", { class: "wide", role: "group", "aria-label": name, tabindex: 0 }, table);
}

/** The cells of a row of headings. */
export function headCells(heads: readonly Head[]): HTMLElement[] {
  return heads.map(({ text, words, hidden }) => {
    const content: Child = hidden ? el("span", { class: "hidden" }, text) : text;
    return el("th", { scope: "col", class: words && "words" }, content);
  });
}
