// The user's answers about a model, as fields of a request.

import type { Form } from "../forms/declaration";
import { givenFields } from "../forms/request";
import type { OpenModel } from "./model";

const COMPARED = ["from", "body_scale_file"];

/** The answers that `form` has fields for. */
export function answersFor(model: OpenModel, form: Form | undefined): Record<string, unknown> {
  if (!form) return {};
  const fields = givenFields(form, model.answers);
  // The comparison with the original belongs to inspections; a change may take its contacts from another model.
  if (form.verb !== "inspect") for (const name of COMPARED) delete fields[name];
  const geometry = changedGeometry(model);
  return geometry !== undefined && "geometry" in fields ? { ...fields, geometry } : fields;
}

/** The geometry set that was changed together with the force set. */
function changedGeometry({ steps, stepCount }: OpenModel): string | undefined {
  return steps.slice(0, stepCount).map(({ names }) => names[1]).filter((name) => name !== undefined).pop();
}
