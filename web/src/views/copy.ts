// The change as a call that can be copied: of the command, of Python, of MATLAB.

import { copy } from "../download/copy";
import { button, el } from "../dom/element";
import { failureOf } from "../engine/failure";
import type { Spelled } from "../engine/types";
import type { Session } from "../state/session";
import { asked, type Asked } from "./diff";

const LANGUAGES: readonly [keyof Spelled, string][] = [["command", "Command"], ["python", "Python"], ["matlab", "MATLAB"]];

export function copyView(session: Session): Asked {
  const boxes = LANGUAGES.map(([language, title]) => ({ language, ...box(session, title, `copy-${language}`) }));
  const note = el("p", { class: "quiet" },
    "The same change elsewhere: in a terminal, a Python script or MATLAB, where osim-contact-scale is installed.");
  const title = el("h3", { id: "copy-title" }, "Copy as command, Python or MATLAB");
  const element = el("details", { class: "section", id: "copy" }, el("summary", {}, title), note, ...boxes.map(({ element: one }) => one));
  return asked(element, async (request) => {
    const spelled = await session.engine.spell(request).catch((error) => failureOf(error).message);
    for (const { language, text } of boxes) {
      text.value = typeof spelled === "string" ? spelled : spelled[language];
      text.rows = text.value.split("\n").length;
    }
  });
}

function box(session: Session, title: string, id: string): { element: HTMLElement; text: HTMLTextAreaElement } {
  const text = el("textarea", { id, readonly: true, rows: 1, spellcheck: "false", class: "code" });
  const act = button(`Copy as ${title}`, () => {
    void copy(text.value, text).then((done) => session.announce(done ? `Copied as ${title}.` : "Press Ctrl+C to copy the selected text."));
  }, { class: "small" });
  return { element: el("div", { class: "copied" }, el("label", { for: id }, title), text, act), text };
}
