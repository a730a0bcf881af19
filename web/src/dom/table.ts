// Tables in boxes that scroll where the page is too narrow, with a name for those who hear them.

import { type Child, el } from "./element";

/** A heading of a column: `words` of one above words instead of numbers; a hidden one is only heard. */
export interface Head {
  text: string;
  words?: boolean;
  hidden?: boolean;
}

/** A table whose caption and headings are given; `head` and `body` are where its rows are. */
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
