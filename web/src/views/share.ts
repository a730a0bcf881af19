// Shows a request as a call of the command, of Python and MATLAB, as JSON, and as a link.

import { copy } from "../download/copy";
import { button, el, setText } from "../dom/element";
import { toFailure } from "../engine/failure";
import type { Request } from "../engine/types";
import type { Session } from "../state/session";

const NOTE = "The same elsewhere: in a terminal, a Python script or MATLAB, where osim-contact-scale is installed; as a request in JSON; and as a link \
that opens this page with the same options. The link names no file.";

/** Returns a function that opens the dialog for a request. */
export function shareDialog(session: Session): (request: Request) => void {
  // The status is inside the dialog, because screen readers ignore the page under it.
  const status = el("p", { role: "status" });
  const setStatus = (text: string) => setText(status, text);
  const boxes = {
    command: copyBox("Command", setStatus), python: copyBox("Python", setStatus), matlab: copyBox("MATLAB", setStatus), json: copyBox("JSON", setStatus), link: copyBox("Link", setStatus),
  };
  const title = el("h2", { id: "share-title", tabindex: -1 }, "Share");
  const dialog = el("dialog", { id: "shared", "aria-labelledby": "share-title" }, title, el("p", { class: "quiet" }, NOTE),
    ...Object.values(boxes).map(({ element }) => element));
  dialog.append(status, el("p", {}, button("Close", () => dialog.close(), { class: "primary" })));
  dialog.addEventListener("click", (event) => event.target === dialog && dialog.close());
  document.body.append(dialog);
  return (request) => {
    dialog.showModal();
    setStatus("");
    for (const { text } of Object.values(boxes)) fillArea(text, "");
    fillArea(boxes.json.text, JSON.stringify(request, null, 2));
    fillArea(boxes.link.text, location.href);
    session.engine.spell(request).then((spelled) => {
      for (const language of ["command", "python", "matlab"] as const) fillArea(boxes[language].text, spelled[language]);
    }, (error) => setStatus(toFailure(error).message));
  };
}

function fillArea(area: HTMLTextAreaElement, text: string): void {
  area.value = text;
  area.style.height = "";
  area.style.height = `${Math.min(200, area.scrollHeight + 2)}px`;
}

function copyBox(title: string, setStatus: (text: string) => void): { element: HTMLElement; text: HTMLTextAreaElement } {
  const id = `share-${title.toLowerCase()}`;
  const text = el("textarea", { id, readonly: true, rows: 1, spellcheck: "false", class: "code" });
  const act = button(`Copy as ${title}`, () => {
    void copy(text.value, text).then((done) => setStatus(done ? `Copied as ${title}.` : "Press Ctrl+C to copy the selected text."));
  }, { class: "small" });
  return { element: el("div", { class: "copied" }, el("label", { for: id }, title), text, act), text };
}
