// Describes a request in a few words, for the list of steps.

import type { Request } from "../engine/types";
import type { ChangeForm } from "./declaration";

const MAX_LENGTH = 60;

/** "Rescale: target mass 500 kg". */
export function describeRequest(request: Request, form: ChangeForm | undefined): string {
  const title = form?.title ?? request.verb;
  const parts = (form?.fields ?? []).flatMap(({ name, label, unit, group }) => {
    const value = request[name];
    // Files that belong to the model are in every request.
    if (value === undefined || group === "Files") return [];
    return [`${lower(label)}${valueText(value)}${unit && typeof value === "number" ? ` ${unit}` : ""}`];
  });
  const text = parts.join(", ");
  return text === "" ? title : `${title}: ${text.length > MAX_LENGTH ? `${text.slice(0, MAX_LENGTH)}…` : text}`;
}

function valueText(value: unknown): string {
  if (value === true) return "";
  if (Array.isArray(value)) return ` ${value.join(" ")}`;
  if (typeof value === "object" && value !== null) return ` ${Object.entries(value).map((pair) => pair.join(" ")).join(", ")}`;
  return ` ${String(value)}`;
}

function lower(label: string): string {
  return /^[A-Z][a-z]/.test(label) && !label.startsWith("OpenSim") ? label.charAt(0).toLowerCase() + label.slice(1) : label;
}
