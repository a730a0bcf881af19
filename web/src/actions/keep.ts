// Keeps what the form would change: the result becomes the model.

import type { Failure } from "../engine/types";
import { byId } from "../dom/element";
import { formOf } from "../forms/all";
import { spoken } from "../forms/spoken";
import { fileOf } from "../state/model";
import type { Session } from "../state/session";
import { apply } from "./apply";

export async function keepResult(session: Session): Promise<Failure | undefined> {
  const preview = session.preview.value;
  if (preview.state !== "done") return undefined;
  const { request } = preview;
  const model = session.models.value.find((open) => fileOf(open) === request.models?.[0]);
  if (!model || session.keeping.value) return undefined;
  const failure = await apply(session, model.id, spoken(request, formOf(request.verb)), request);
  if (failure) return failure;
  // What was asked for holds now; asked for again, it would be done twice.
  session.values.clear();
  byId("model-title").focus();
  return undefined;
}
