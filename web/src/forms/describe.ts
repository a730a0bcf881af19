// Describes a request by what the person gets, for buttons and for the list of steps.

import { kilograms } from "../dom/number";
import type { Request } from "../engine/types";
import type { ChangeForm } from "./declaration";
import type { Value } from "./values";

const MAX_LENGTH = 60;
/** Fields that say nothing about what the person gets. */
const UNSAID = new Set(["contacts_mass", "yes", "target_mass", "from", "follow_bodies", "level"]);

/** "Make the contacts right for 52 kg"; `bodyMass` is the mass of the model, kg. */
export function describeRequest(request: Request, form: ChangeForm | undefined, bodyMass?: number | null): string {
  const mass = typeof request["target_mass"] === "number" ? request["target_mass"] : bodyMass;
  const job = jobText(request, mass, form);
  const others = otherParts(request, form);
  if (others === "") return job;
  return `${job}: ${others.length > MAX_LENGTH ? `${others.slice(0, MAX_LENGTH)}…` : others}`;
}

function jobText(request: Request, mass: number | null | undefined, form: ChangeForm | undefined): string {
  const right = mass == null ? "" : `make the contacts right for ${kilograms(mass)}`;
  if (request.verb === "rescale" && "target_mass" in request) return right.replace("make", "Make");
  if (request.verb === "transfer" && request["follow_bodies"] === true) return ["Move the spheres with the bones", right].filter(Boolean).join(" and ");
  if (request.verb === "transfer") return `Take over the contacts of ${String(request["from"])}`;
  if (request.verb === "add") return ["Give it contacts", request["from"]].filter(Boolean).join(" of ");
  if (request.verb === "design" || request.verb === "set") return "Change the contacts";
  return form?.title ?? request.verb;
}

function otherParts(request: Request, form: ChangeForm | undefined): string {
  const parts = (form?.fields ?? []).flatMap(({ name, label, unit, group }) => {
    const value = request[name];
    // Files that belong to the model are in every request.
    if (value === undefined || group === "Files" || UNSAID.has(name)) return [];
    return [`${lower(label)}${valueText(value)}${unit && typeof value === "number" ? ` ${unit}` : ""}`];
  });
  return parts.join(", ");
}

/** The values of a form that make this request. */
export function valuesOf(request: Request): Map<string, Value> {
  const values = Object.entries(request).filter(([name]) => name !== "verb" && name !== "models");
  return new Map(values.map(([name, value]) => [name, formValue(value)]));
}

function formValue(value: unknown): Value {
  if (typeof value === "boolean") return value;
  if (Array.isArray(value)) return value.map(String);
  if (typeof value !== "object" || value === null) return String(value);
  return Object.fromEntries(Object.entries(value).map(([name, one]) => [name, String(one)]));
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
