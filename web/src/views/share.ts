// The change elsewhere: as a call of the command, of Python, of MATLAB, as JSON, as a link.

import { copy } from "../download/copy";
import { button, el, setText } from "../dom/element";
import { failureOf } from "../engine/failure";
import type { Request } from "../engine/types";
import type { Session } from "../state/session";

const NOTE = "The same elsewhere: in a terminal, a Python script or MATLAB, where osim-contact-scale is installed; as a request in JSON; and as a link \
that opens this page with the same options. The link names no file.";

/** Gives what opens the dialog for a request. */
export function shareDialog(session: Session): (request: Request) => void {
  // What is under an open dialog is not heard.
  const said = el("p", { role: "status" });
  const say = (text: string) => setText(said, text);
  const boxes = {
    command: box("Command", say), python: box("Python", say), matlab: box("MATLAB", say), json: box("JSON", say), link: box("Link", say),
  };
  const title = el("h2", { id: "share-title", tabindex: -1 }, "Share");
  const dialog = el("dialog", { id: "shared", "aria-labelledby": "share-title" }, title, el("p", { class: "quiet" }, NOTE),
    ...Object.values(boxes).map(({ element }) => element));
  dialog.append(said, el("p", {}, button("Close", () => dialog.close(), { class: "primary" })));
  dialog.addEventListener("click", (event) => event.target === dialog && dialog.close());
  document.body.append(dialog);
  return (request) => {
    dialog.showModal();
    say("");
    for (const { text } of Object.values(boxes)) show(text, "");
    show(boxes.json.text, JSON.stringify(request, null, 2));
    show(boxes.link.text, location.href);
    session.engine.spell(request).then((spelled) => {
      for (const language of ["command", "python", "matlab"] as const) show(boxes[language].text, spelled[language]);
    }, (error) => say(failureOf(error).message));
  };
}

function show(area: HTMLTextAreaElement, text: string): void {
  area.value = text;
  area.rows = Math.min(8, text.split("\n").length);
}

function box(title: string, say: (text: string) => void): { element: HTMLElement; text: HTMLTextAreaElement } {
  const id = `share-${title.toLowerCase()}`;
  const text = el("textarea", { id, readonly: true, rows: 1, spellcheck: "false", class: "code" });
  const act = button(`Copy as ${title}`, () => {
    void copy(text.value, text).then((done) => say(done ? `Copied as ${title}.` : "Press Ctrl+C to copy the selected text."));
  }, { class: "small" });
  return { element: el("div", { class: "copied" }, el("label", { for: id }, title), text, act), text };
}
