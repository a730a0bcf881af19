// The request in the address, after #: so that it can be kept and sent. Never a file's name, never what is in one.

import type { Field, Form } from "../forms/declaration";
import type { Value, Values } from "../forms/values";

export interface Addressed {
  verb: string;
  values: Map<string, Value>;
}

/** `rescale?target_mass=500&only=radius&only=stiffness`; `isFile` says which values name files. */
export function addressOf(form: Form, values: Values, isFile: (name: string) => boolean): string {
  const words = new URLSearchParams();
  for (const field of form.fields) {
    const value = values.get(field.name);
    if (value === undefined || field.kind === "codes") continue;
    for (const text of texts(value)) if (!(field.kind === "file" && isFile(text))) words.append(field.name, text);
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
    const said = words.getAll(field.name);
    if (said.length > 0) values.set(field.name, valueOf(field, said));
  }
  return { verb, values };
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
    case "lines":
    case "codes": return said;
    case "map": return Object.fromEntries(said.map((text) => text.split(/=(.*)/s).slice(0, 2) as [string, string]));
    default: return said[0] ?? "";
  }
}
