// The manual of the page, which is unpacked when it is opened.

import { byId } from "../dom/element";
import { parseHtml } from "../dom/markup";
import { unpackedText } from "../engine/unpack";
import { readerDialog } from "./dialog";

export function manualView(): void {
  const { dialog, body } = readerDialog("manual", "Manual of this page");
  byId("read-manual").addEventListener("click", () => {
    if (!body.hasChildNodes()) body.append(parseHtml(unpackedText("manual-html"), 3));
    dialog.showModal();
  });
}
