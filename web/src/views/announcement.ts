// Shows the last event in one line that covers no button, for screen readers, too.

import { byId, setText } from "../dom/element";
import { toFailure } from "../engine/failure";
import type { Session } from "../state/session";

/** Time for which the line stays visible, for each line of text that a person has to read. */
const HIGHLIGHTED_MS = 3000;
const LETTERS_OF_LINE = 90;

export function showAnnouncements(session: Session): void {
  const line = byId("announcement");
  const setSpace = (height: string) => (byId("acts").style.paddingBottom = height);
  let timer: ReturnType<typeof setTimeout> | undefined;
  session.announcement.watch((text) => {
    setText(line, text);
    if (text === "") return;
    line.classList.add("fresh");
    // The buttons at the bottom stay above a text of several lines.
    setSpace(`${line.getBoundingClientRect().height}px`);
    clearTimeout(timer);
    timer = setTimeout(() => {
      line.classList.remove("fresh");
      setSpace("");
    }, HIGHLIGHTED_MS * Math.ceil(text.length / LETTERS_OF_LINE));
  });
  // Unexpected failures are shown, too.
  addEventListener("unhandledrejection", ({ reason }) => session.announce(`This did not work: ${toFailure(reason).message}.`));
}
