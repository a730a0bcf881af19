// Links in sections lead to explanations of equations and findings. They open here; the address is the request's.

import { button, byId, el } from "../dom/element";
import { parsed } from "../dom/markup";
import type { Session } from "../state/session";

export function showExplanations(session: Session): void {
  const dialog = byId("explanation") as HTMLDialogElement;
  const title = el("h2", { id: "explanation-title" }, "Explanation");
  const body = el("div", { class: "body", tabindex: 0, role: "group", "aria-label": "Explanation" });
  const close = button("Close", () => dialog.close(), { class: "primary" });
  dialog.append(title, body, el("p", {}, close));
  // A click beside it closes it.
  dialog.addEventListener("click", (event) => event.target === dialog && dialog.close());
  document.addEventListener("click", (event) => {
    const link = event.target instanceof Element ? event.target.closest("a[href^='#']") : null;
    if (!link || link.id === "skip") return;
    event.preventDefault();
    void explain(session, (link.getAttribute("href") ?? "").slice(1), body).then(() => dialog.showModal());
  });
}

/** Opens the explanation of a topic that is not linked to in a section. */
async function explain(session: Session, anchor: string, body: HTMLElement): Promise<void> {
  const html = session.explained.get(anchor);
  if (html !== undefined) return body.replaceChildren(parsed(html));
  const text = await session.engine.explain(topicOf(anchor)).then((answer) => answer.text, (error: Error) => error.message);
  body.replaceChildren(el("pre", { class: "plain" }, text));
}

/** `equation-c-2` is about C.2, `finding-beyond-hertz` about beyond-hertz. */
function topicOf(anchor: string): string {
  const equation = /^equation-(.+)$/.exec(anchor)?.[1];
  if (equation !== undefined) return equation.toUpperCase().replace("-", ".");
  return anchor.replace(/^(finding|error)-/, "");
}
