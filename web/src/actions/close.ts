// Closes a model; its files stay in the list.

import { currentFile, type OpenModel } from "../state/model";
import type { Session } from "../state/session";

export function close(session: Session, model: OpenModel): void {
  session.models.set(session.models.value.filter(({ id }) => id !== model.id));
  if (session.chosen.value === model.id) session.chosen.set(session.models.value[0]?.id ?? null);
  session.announce(`${currentFile(model)} is closed.`);
}
