// Opens explanations of equations and findings in a dialog when a link is clicked. The address keeps the request.

import { el } from "../dom/element";
import { parseHtml } from "../dom/markup";
import { anchorTopic } from "../engine/anchor";
import type { Session } from "../state/session";
import { readerDialog } from "./dialog";

export function showExplanations(session: Session): void {
  const { dialog, body } = readerDialog("explanation", "Explanation");
  document.addEventListener("click", (event) => {
    const link = event.target instanceof Element ? event.target.closest("a[href^='#']") : null;
    if (!link || link.id === "skip") return;
    event.preventDefault();
    void fillExplanation(session, (link.getAttribute("href") ?? "").slice(1), body).then(() => dialog.open || dialog.showModal());
  });
}

/** Shows the explanation that came with a section, or asks the engine for it. */
async function fillExplanation(session: Session, anchor: string, body: HTMLElement): Promise<void> {
  const html = session.explained.get(anchor);
  if (html !== undefined) return body.replaceChildren(parseHtml(html, 3));
  const text = await session.engine.explain(anchorTopic(anchor)).then((answer) => answer.text, (error: Error) => error.message);
  body.replaceChildren(el("pre", { class: "plain" }, text));
}
