// Dialogs with a title, a text to read and a button that closes them.

import { button, byId, el } from "../dom/element";

export interface Reader {
  dialog: HTMLDialogElement;
  body: HTMLElement;
}

/** Fills the dialog `id` of the page; the caller adds the text to its body. */
export function readerDialog(id: string, title: string): Reader {
  const dialog = byId(id) as HTMLDialogElement;
  const body = el("div", { class: "body", tabindex: 0, role: "group", "aria-label": title });
  const close = button("Close", () => dialog.close(), { class: "primary" });
  dialog.append(el("h2", { id: `${id}-title` }, title), body, el("p", {}, close));
  // A click outside the dialog closes it.
  dialog.addEventListener("click", (event) => event.target === dialog && dialog.close());
  return { dialog, body };
}
