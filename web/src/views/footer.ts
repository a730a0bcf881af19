// The licences, which are unpacked when they are opened.

import { byId } from "../dom/element";
import { unpackedText } from "../engine/unpack";

export function footerView(): void {
  const details = byId("licences");
  const licenceText = byId("licences-shown");
  details.addEventListener("toggle", () => {
    if (licenceText.textContent === "") licenceText.textContent = unpackedText("licences-text");
  });
}
