// What was answered about a model, as fields of a request.

import type { Form } from "../forms/declaration";
import { givenFields } from "../forms/request";
import type { OpenModel } from "./model";

const COMPARED = ["from", "body_scale_file"];

/** The answers that `form` takes, about the model as it is now. */
export function answersFor(model: OpenModel, form: Form | undefined): Record<string, unknown> {
  if (!form) return {};
  const fields = givenFields(form, model.answers);
  // The model is compared with the one that it was scaled from; a change may take its contacts from another one.
  if (form.verb !== "inspect") for (const name of COMPARED) delete fields[name];
  const geometry = changedGeometry(model);
  return geometry !== undefined && "geometry" in fields ? { ...fields, geometry } : fields;
}

/** A force set that was changed goes with the geometry set that was changed along with it. */
function changedGeometry({ steps, stepCount }: OpenModel): string | undefined {
  return steps.slice(0, stepCount).map(({ names }) => names[1]).filter((name) => name !== undefined).pop();
}
