// Makes the declarations of the forms from the JSON Schemas of the requests, so that a field is declared once.

import { readFileSync } from "node:fs";
import { join } from "node:path";

import { field } from "./field.mjs";
import { labels } from "./labels.mjs";
import { CALCULATOR, GROUPS, GROUPS_LEFT_OUT, LEFT_OUT, ONLY_WITH_MODEL, VERBS } from "./layout.mjs";
import { ROOT } from "./paths.mjs";
import { relations } from "./relations.mjs";

/** The form of each verb in the page's order, the calculator's, and that of questions about a model. */
export function forms() {
  const names = labels();
  const changes = Object.entries(VERBS).map(([verb, { title, about, usual }]) => ({ title, about, ...form(verb, usual, names) }));
  const design = form("design", CALCULATOR, names, ONLY_WITH_MODEL);
  // Without a model there is no radius to keep or to multiply.
  const calculator = { ...design, fields: design.fields.map((field) => (field.kind === "rule" ? { ...field, kind: "number" } : field)) };
  const questions = form("inspect", [], names);
  // A model is compared with another one; presets are not models.
  questions.fields = questions.fields.map((field) => (field.name === "from" ? { ...field, source: "models", label: "Model that it was scaled from" } : field));
  return { changes, calculator, questions };
}

function form(verb, usual, names, without = []) {
  const schema = JSON.parse(readFileSync(join(ROOT, `schemas/requests/${verb}.schema.json`), "utf8"));
  const fields = Object.entries(properties(schema))
    .filter(([name, declared]) => name !== "verb" && !isLeftOut(name, declared) && !without.includes(name))
    .map(([name, declared]) => ({ ...field(name, declared, names), ...place(verb, name, usual) }));
  const known = new Set(fields.map(({ name }) => name));
  const required = (schema.required ?? []).filter((name) => known.has(name));
  return { verb, fields: ordered(fields, usual), required, ...relations(schema.allOf ?? [], known) };
}

/** The fields, with the definitions of their types in the place of references. */
function properties({ properties, $defs }) {
  const defined = (_, part) => (part?.$ref ? $defs[part.$ref.split("/").at(-1)] : part);
  return JSON.parse(JSON.stringify(properties), defined);
}

function isLeftOut(name, { "x-group": group }) {
  return name in LEFT_OUT || (group !== undefined && group in GROUPS_LEFT_OUT);
}

/** Usual fields stand first; every other one belongs to a group, one that no group names to the last. */
function place(verb, name, usual) {
  if (usual.includes(name)) return { group: "" };
  const group = Object.keys(GROUPS).find((title) => GROUPS[title].includes(name));
  // The questions about a model show single fields, without groups.
  return { group: group ?? (verb === "inspect" ? "" : Object.keys(GROUPS).at(-1)) };
}

function ordered(fields, usual) {
  const groups = Object.keys(GROUPS);
  const within = ({ name, group }) => (group in GROUPS && !GROUPS[group].includes(name) ? 999 : (GROUPS[group] ?? usual).indexOf(name));
  const rank = (field) => 1000 * (1 + groups.indexOf(field.group)) + within(field);
  return [...fields].sort((one, other) => rank(one) - rank(other));
}
