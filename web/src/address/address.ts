// Writes the request into the address after #, so that it can be stored and sent. It never has names of files, or names from files.

import type { Field, Form } from "../forms/declaration";
import type { Value, Values } from "../forms/values";

interface AddressRequest {
  verb: string;
  values: Map<string, Value>;
}

/** `rescale?target_mass=500&only=radius&only=stiffness`; `isPreset` says which values name presets that every page has. */
export function toAddress(form: Form, values: Values, isPreset: (name: string) => boolean): string {
  const parameters = new URLSearchParams();
  for (const field of form.fields) {
    const value = values.get(field.name);
    if (value === undefined || field.kind === "codes") continue;
    for (const text of valueTexts(value)) if (isPublic(field, text, isPreset)) parameters.append(field.name, text);
  }
  const query = parameters.toString();
  return query === "" ? form.verb : `${form.verb}?${query}`;
}

/** The request in an address; undefined if the address has none. */
export function readAddress(hash: string, forms: readonly Form[]): AddressRequest | undefined {
  const [verb = "", query = ""] = hash.replace(/^#/, "").split(/\?(.*)/s);
  const form = forms.find((one) => one.verb === verb);
  if (!form) return undefined;
  const parameters = new URLSearchParams(query);
  const values = new Map<string, Value>();
  for (const field of form.fields) {
    // The user of this page answers safety questions, not the author of the link.
    if (field.kind === "codes") continue;
    const valueTexts = parameters.getAll(field.name);
    if (valueTexts.length > 0) values.set(field.name, parseValue(field, valueTexts));
  }
  return { verb, values };
}

/** Whether a text may be in the address. Names from files may be private: of these, only patterns that the user typed are public. */
function isPublic({ kind, source, choices = [] }: Field, text: string, isPreset: (name: string) => boolean): boolean {
  if (kind === "file") return isPreset(text) || choices.some(({ value }) => value === text);
  const isName = kind === "lines" || kind === "text" || source === "forces" || source === "bodies";
  return !isName || /[*?]/.test(text);
}

function valueTexts(value: Value): readonly string[] {
  if (typeof value === "string") return [value];
  if (typeof value === "boolean") return ["true"];
  if (Array.isArray(value)) return value as readonly string[];
  return Object.entries(value).map(([name, text]) => `${name}=${text}`);
}

function parseValue({ kind }: Field, valueTexts: string[]): Value {
  switch (kind) {
    case "flag": return valueTexts[0] === "true";
    case "texts":
    case "lines": return valueTexts;
    case "map": return Object.fromEntries(valueTexts.map(entry).filter(([, text]) => text !== ""));
    default: return valueTexts[0] ?? "";
  }
}

/** Name and value of `stiffness=x2`. Programs that forward links may have added blanks. */
function entry(text: string): [string, string] {
  const [name = "", value = ""] = text.split(/=(.*)/s);
  return [name, value.trim()];
}
