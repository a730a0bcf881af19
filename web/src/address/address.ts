// The request in the address, after #: so that it can be kept and sent. Never a file's name, never a name that is in one.

import type { Field, Form } from "../forms/declaration";
import type { Value, Values } from "../forms/values";

interface Addressed {
  verb: string;
  values: Map<string, Value>;
}

/** `rescale?target_mass=500&only=radius&only=stiffness`; `isPreset` says which values name presets that every page has. */
export function addressOf(form: Form, values: Values, isPreset: (name: string) => boolean): string {
  const words = new URLSearchParams();
  for (const field of form.fields) {
    const value = values.get(field.name);
    if (value === undefined || field.kind === "codes") continue;
    for (const text of texts(value)) if (isPublic(field, text, isPreset)) words.append(field.name, text);
  }
  const query = words.toString();
  return query === "" ? form.verb : `${form.verb}?${query}`;
}

/** What an address asks for; nothing where it is not one of ours. */
export function readAddress(hash: string, forms: readonly Form[]): Addressed | undefined {
  const [verb = "", query = ""] = hash.replace(/^#/, "").split(/\?(.*)/s);
  const form = forms.find((one) => one.verb === verb);
  if (!form) return undefined;
  const words = new URLSearchParams(query);
  const values = new Map<string, Value>();
  for (const field of form.fields) {
    // A question about safety is for the user of this page, not for the one who made the link.
    if (field.kind === "codes") continue;
    const said = words.getAll(field.name);
    if (said.length > 0) values.set(field.name, valueOf(field, said));
  }
  return { verb, values };
}

/** Files have names of people, models have names of files: of these, only what the user typed as a pattern is in the address. */
function isPublic({ kind, source, choices = [] }: Field, text: string, isPreset: (name: string) => boolean): boolean {
  if (kind === "file") return isPreset(text) || choices.some(({ value }) => value === text);
  const isName = kind === "lines" || kind === "text" || source === "forces" || source === "bodies";
  return !isName || /[*?]/.test(text);
}

function texts(value: Value): readonly string[] {
  if (typeof value === "string") return [value];
  if (typeof value === "boolean") return ["true"];
  if (Array.isArray(value)) return value as readonly string[];
  return Object.entries(value).map(([name, text]) => `${name}=${text}`);
}

function valueOf({ kind }: Field, said: string[]): Value {
  switch (kind) {
    case "flag": return said[0] === "true";
    case "texts":
    case "lines": return said;
    case "map": return Object.fromEntries(said.map(entry).filter(([, text]) => text !== ""));
    default: return said[0] ?? "";
  }
}

/** `stiffness=x2`; programs that pass links on may have changed it. */
function entry(text: string): [string, string] {
  const [name = "", value = ""] = text.split(/=(.*)/s);
  return [name, value.trim()];
}
