// Makes the declaration of one field of a form from its JSON Schema.

import { ALL_UNLESS_TICKED, CHOICE_TEXTS, SOURCES, WORDS } from "./layout.mjs";

const UNIT = /,? \[?(kg|m\/s2|m\/s|N\/m2|N\/m|N|m|1\/m|s\/m)(?=$|\s|[:;,(])/;
const FILES = new Set(["from", "presets", "body_scale_file", "contacts", "geometry", "model"]);
const LINES = new Set(["body_map", "body_scale", "reference_select"]);

/** The declaration of a field: name, label, kind and help. */
export function field(name, schema, names) {
  const label = names.get(name) ?? (name === "set" ? "new values" : undefined);
  if (!label) throw new Error(`no label for ${name}`);
  const { help, unit } = helpAndUnit(schema.description, names);
  const helpText = help === `${capital(label)}.` ? "" : help;
  const kind = fieldKind(name, schema);
  // A file has no unit, though what is in it may have one.
  const fieldUnit = kind.kind === "file" ? undefined : unit;
  return withoutUndefined({ name, label: capital(label), help: helpText, unit: fieldUnit, ...kind, source: SOURCES[name], default: defaultText(name, schema) });
}

/** The kind of a field, with its choices and limits. */
function fieldKind(name, schema) {
  const parts = allParts(schema);
  const types = new Set(parts.flatMap((part) => part.type ?? []));
  const choices = parts.flatMap((part) => part.enum ?? []).filter((text) => typeof text === "string");
  const number = parts.find((part) => [part.type].flat().some((type) => type === "number" || type === "integer"));
  if (FILES.has(name)) return { kind: "file", ...fileSource(schema) };
  if (name === "set") return { kind: "map" };
  if (name === "yes") return { kind: "codes" };
  if (LINES.has(name)) return { kind: "lines" };
  if (types.has("boolean")) return { kind: "flag" };
  if (types.has("array")) return { kind: "texts" };
  if (choices.length > 0) return { kind: "choice", choices: choices.map(choice) };
  if (number && types.has("string")) return { kind: "rule", ...rule(parts), limits: limits(number), unit: "m" };
  if (number) return { kind: types.has("integer") ? "integer" : "number", limits: limits(number) };
  if (types.has("string")) return { kind: "text" };
  throw new Error(`forms do not know what ${name} takes: ${JSON.stringify(schema)}`);
}

/** Presets that a description names because they have places; the engine lists those that have numbers. */
function fileSource({ description }) {
  const names = /a preset with places: ([\w, -]+)$/.exec(description)?.[1]?.split(", ");
  return names ? { choices: names.map(choice) } : {};
}

/** The schema and its parts, without the form of a file name in bytes. */
function allParts(schema) {
  const parts = (schema.anyOf ?? []).filter((part) => !part.properties?.bytes);
  return [schema, ...parts.flatMap(allParts)];
}

/** The choices of a field that takes words, factors or numbers: its pattern is `^(isometric|keep|[xX]…)$`. */
function rule(parts) {
  const pattern = parts.find((part) => part.pattern)?.pattern ?? "";
  const words = pattern.replace(/^\^\(|\)\$$/g, "").split("|").filter((word) => /^\w+$/.test(word));
  return { choices: words.map(choice), factor: pattern.includes("[xX]") };
}

function choice(value) {
  return { value, text: CHOICE_TEXTS[value] ?? value };
}

function limits({ minimum, maximum, exclusiveMinimum, exclusiveMaximum }) {
  return withoutUndefined({ least: minimum, most: maximum, above: exclusiveMinimum, below: exclusiveMaximum });
}

/** The default value, if a form can show it. */
function defaultText(name, { default: value }) {
  if (Array.isArray(value)) return ALL_UNLESS_TICKED.includes(name) ? "all" : "none";
  if (typeof value === "number") return String(value);
  return typeof value === "string" ? (CHOICE_TEXTS[value] ?? value) : undefined;
}

/** The description in the words of a page, and the unit in it. */
function helpAndUnit(description, names) {
  let text = description.replace(/\s+/g, " ").trim();
  for (const [from, to] of WORDS) text = text.replace(from, to);
  const unit = UNIT.exec(text)?.[1];
  text = text.replace(/`(\w+)`/g, (_, name) => (names.has(name) ? `“${names.get(name)}”` : name));
  text = text.replace(/ ?\[default: ([^\]]+)\]/, ". Without it: $1");
  text = text.replace(/ ?\[default with ([^:]+): ([^\]]+)\]/, ". Without it, with $1: $2");
  text = superscript(`${text.trim().replace(/\.$/, "")}.`);
  return { help: text, unit: unit && superscript(unit) };
}

function superscript(text) {
  return text.replace(/\b(m\/s|N\/m)2\b/g, "$1²");
}

function capital(text) {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

function withoutUndefined(object) {
  return Object.fromEntries(Object.entries(object).filter(([, value]) => value !== undefined));
}
