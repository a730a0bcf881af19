// A window over the page: a title, what is read, and a button that closes it.

import { button, byId, el } from "../dom/element";

export interface Reader {
  dialog: HTMLDialogElement;
  body: HTMLElement;
}

/** Fills the dialog `id` of the page; what is read goes into its body. */
export function readerDialog(id: string, title: string): Reader {
  const dialog = byId(id) as HTMLDialogElement;
  const body = el("div", { class: "body", tabindex: 0, role: "group", "aria-label": title });
  const close = button("Close", () => dialog.close(), { class: "primary" });
  dialog.append(el("h2", { id: `${id}-title` }, title), body, el("p", {}, close));
  // A click beside it closes it.
  dialog.addEventListener("click", (event) => event.target === dialog && dialog.close());
  return { dialog, body };
}
