// Warns before the page is closed with changes that were not downloaded.

import { currentStep } from "../state/model";
import type { Session } from "../state/session";

/** Lets the browser ask before the page is closed with a changed model that was not downloaded. */
export function warnBeforeLeaving(session: Session): void {
  addEventListener("beforeunload", (event) => {
    const changed = session.models.value.flatMap((model) => currentStep(model)?.name ?? []);
    if (changed.every((name) => session.saved.has(name))) return;
    event.preventDefault();
    // Older browsers need this.
    event.returnValue = "";
  });
}
