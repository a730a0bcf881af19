// Shows the last event in one line that covers no button, for screen readers, too.

import { byId, setText } from "../dom/element";
import { toFailure } from "../engine/failure";
import type { Session } from "../state/session";

/** Time for which the line stays visible, for each line of text that a person has to read. */
const FRESH_MS = 3000;
const LINE_LETTERS = 90;

export function showAnnouncements(session: Session): void {
  const line = byId("announcement");
  let timer: ReturnType<typeof setTimeout> | undefined;
  session.announcement.watch((text) => {
    setText(line, text);
    if (text === "") return;
    line.classList.add("fresh");
    clearTimeout(timer);
    timer = setTimeout(() => line.classList.remove("fresh"), FRESH_MS * Math.ceil(text.length / LINE_LETTERS));
  });
  // Unexpected failures are shown, too.
  addEventListener("unhandledrejection", ({ reason }) => session.announce(`This did not work: ${toFailure(reason).message}.`));
}
