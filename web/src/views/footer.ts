// The licences, which are unpacked when somebody wants to read them.

import { byId } from "../dom/element";
import { wholePage } from "../dom/whole";
import { unpackedText } from "../engine/unpack";

export function footerView(): void {
  const details = byId("licences");
  const shown = byId("licences-shown");
  details.addEventListener("toggle", () => {
    if (shown.textContent === "") void wholePage().then(() => (shown.textContent = unpackedText("licences-text")));
  });
}
