// Shows the lines of the file that change, on demand.

import { el } from "../dom/element";
import { toFailure } from "../engine/failure";
import type { Request } from "../engine/types";
import type { Session } from "../state/session";

// Limit of the lines on the page; the downloaded file has all.
const MAX_DIFF_LINES = 2000;

export interface LazySection {
  element: HTMLDetailsElement;
  /** Shows the section for a request: soon if it is open, else when it is opened. */
  ask(request: Request): void;
}

export function diffView(session: Session): LazySection {
  const lines = el("pre", { class: "diff", tabindex: 0, "aria-label": "Lines that change" });
  const explanation = el("p", { class: "quiet" });
  const title = el("h3", { id: "diff-title" }, "Lines that change");
  const element = el("details", { class: "section", id: "diff" }, el("summary", {}, title), explanation, lines);
  const show = async (request: Request) => {
    const text = await session.engine.diff(request).then(({ next }) => next.text, (error) => toFailure(error).message);
    const all = text.split("\n");
    lines.replaceChildren(...all.slice(0, MAX_DIFF_LINES).map(diffLine));
    const cut = all.length > MAX_DIFF_LINES ? ` The first ${MAX_DIFF_LINES} of ${all.length} lines are shown.` : "";
    explanation.textContent = `Lines with − go away, lines with + come in their place.${cut}`;
  };
  return lazySection(element, show);
}

function diffLine(text: string): HTMLElement {
  const kind = text.startsWith("+") ? "added" : text.startsWith("-") ? "removed" : text.startsWith("@@") ? "place" : "";
  return el("span", { class: `line ${kind}` }, `${text}\n`);
}

/** A section that calls `show` only while it is open, and after the request has not changed for a moment. */
export function lazySection(element: HTMLDetailsElement, show: (request: Request) => Promise<void>): LazySection {
  let request: Request | undefined;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const showIfOpen = () => request && element.open && void show(request);
  element.addEventListener("toggle", showIfOpen);
  const ask = (next: Request) => {
    if (JSON.stringify(request) === JSON.stringify(next)) return;
    request = next;
    clearTimeout(timer);
    timer = setTimeout(showIfOpen, 250);
  };
  return { element, ask };
}
