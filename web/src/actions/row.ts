// Makes the request of the form for one of the open models.

import type { Request } from "../engine/types";
import type { Form } from "../forms/declaration";
import { numeric, buildRequest } from "../forms/request";
import { answersFor } from "../state/answers";
import { currentFile, type OpenModel } from "../state/model";
import type { Session } from "../state/session";

/** The request of the form, with the target mass in the model's row, if it has one. The engine reports a mass that is not a number. */
export function requestFor(session: Session, form: Form, model: OpenModel): Request {
  const request = buildRequest(form, session.values, currentFile(model), answersFor(model, form));
  return hasOwnMass(session, form, model) ? { ...request, target_mass: numeric(model.targetMass) } : request;
}

/** Whether the row of a model has a target mass. A single model has no row. */
export function hasOwnMass(session: Session, form: Form, model: OpenModel): boolean {
  const takesMass = form.fields.some(({ name }) => name === "target_mass");
  return takesMass && model.targetMass !== "" && session.models.value.length > 1;
}
