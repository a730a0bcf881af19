// Applies the change in the form to the model.

import type { Failure } from "../engine/types";
import { byId } from "../dom/element";
import { findForm } from "../forms/all";
import { describeRequest } from "../forms/describe";
import { currentFile } from "../state/model";
import type { Session } from "../state/session";
import { apply } from "./apply";

export async function keepResult(session: Session): Promise<Failure | undefined> {
  const preview = session.preview.value;
  if (preview.state !== "done") return undefined;
  const { request } = preview;
  const model = session.models.value.find((open) => currentFile(open) === request.models?.[0]);
  if (!model || session.keeping.value) return undefined;
  const failure = await apply(session, model.id, describeRequest(request, findForm(request.verb), model.inspected?.inspection.mass_kg), request);
  if (failure) return failure;
  // The form is cleared: the same change would otherwise be previewed on top of itself.
  session.values.clear();
  if (request.verb === "add") session.setVerb("rescale", new Map());
  byId("model-title").focus();
  return undefined;
}
