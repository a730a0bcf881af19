// The request of the form for one of the models that are open.

import type { Request } from "../engine/types";
import type { Form } from "../forms/declaration";
import { numeric, requestOf } from "../forms/request";
import { answered } from "../state/answers";
import { fileOf, type OpenModel } from "../state/model";
import type { Session } from "../state/session";

/** With the model's own target mass, where its row in the table has one. What is not a number goes along, too: the engine says why. */
export function requestFor(session: Session, form: Form, model: OpenModel): Request {
  const request = requestOf(form, session.values, fileOf(model), answered(model, form));
  return hasOwnMass(session, form, model) ? { ...request, target_mass: numeric(model.targetMass) } : request;
}

/** Whether the row of a model has a mass. A model alone has no row. */
export function hasOwnMass(session: Session, form: Form, model: OpenModel): boolean {
  const takesMass = form.fields.some(({ name }) => name === "target_mass");
  return takesMass && model.targetMass !== "" && session.models.value.length > 1;
}
