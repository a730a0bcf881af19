// The manual of the page, which is unpacked when somebody wants to read it.

import { byId } from "../dom/element";
import { parsed } from "../dom/markup";
import { wholePage } from "../dom/whole";
import { unpackedText } from "../engine/unpack";
import { reader } from "./dialog";

export function manualView(): void {
  const { dialog, body } = reader("manual", "Manual of this page");
  byId("read-manual").addEventListener("click", async () => {
    await wholePage();
    if (!body.hasChildNodes()) body.append(parsed(unpackedText("manual-html"), 3));
    dialog.showModal();
  });
}
