// Changes that were kept are gone when the page is left.

import { currentStep } from "../state/model";
import type { Session } from "../state/session";

/** The browser asks before the page is left with a changed model that was not downloaded. */
export function warnBeforeLeaving(session: Session): void {
  addEventListener("beforeunload", (event) => {
    const changed = session.models.value.flatMap((model) => currentStep(model)?.name ?? []);
    if (changed.every((name) => session.saved.has(name))) return;
    event.preventDefault();
    // Older browsers ask because of this.
    event.returnValue = "";
  });
}
