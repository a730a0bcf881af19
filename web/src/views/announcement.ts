// What happened last, in one line near the top: for eyes and for screen readers.

import { byId, setText } from "../dom/element";
import { toFailure } from "../engine/failure";
import type { Session } from "../state/session";

// For so long it stays in view while the page is scrolled.
const FRESH_MS = 10_000;

export function showAnnouncements(session: Session): void {
  const line = byId("announcement");
  let timer: ReturnType<typeof setTimeout> | undefined;
  session.announcement.watch((text) => {
    setText(line, text);
    if (text === "") return;
    line.classList.add("fresh");
    clearTimeout(timer);
    timer = setTimeout(() => line.classList.remove("fresh"), FRESH_MS);
  });
  // Unexpected failures are shown, too.
  addEventListener("unhandledrejection", ({ reason }) => session.announce(`This did not work: ${toFailure(reason).message}.`));
}
