// Gives forms the options and values of the open models and files.

import { digits } from "../dom/number";
import type { FileKind } from "../files/kinds";
import type { Context, SelectOption } from "../forms/context";
import type { Source } from "../forms/declaration";
import type { Values } from "../forms/values";
import { currentFile } from "../state/model";
import type { Session } from "../state/session";

// OpenSim's names, for models without forces.
const SETTABLE_PROPERTIES = [
  "radius", "stiffness", "dissipation", "static_friction", "dynamic_friction", "viscous_friction", "transition_velocity",
  "constant_contact_force", "hertz_smoothing", "hunt_crossley_smoothing",
];

const KINDS: Readonly<Partial<Record<Source, readonly FileKind[]>>> = {
  references: ["model"], presets: ["presets"], scales: ["scales", "xml"], tables: ["table"],
  geometries: ["geometry", "model", "xml"], models: ["model"],
};

const ACCEPTED: Readonly<Partial<Record<Source, string>>> = {
  references: ".osim,.xml", presets: ".toml", scales: ".xml", tables: ".csv,.tsv,.txt", geometries: ".xml,.osim", models: ".osim",
};

/** File name endings for the chooser of a field. */
export function acceptedFor(source: Source): string {
  return ACCEPTED[source] ?? "";
}

interface FormOptions {
  prefix: string;
  commit: "input" | "change";
  addFile: Context["addFile"];
}

/** The context of a form whose values are `values`. */
export function formContext(session: Session, values: Values, { prefix, commit, addFile }: FormOptions): Context {
  return {
    values, prefix, commit, addFile,
    options: (source) => optionsOfSource(session, source),
    currentValue: (property) => currentValue(session, property),
    modelMass: () => session.model()?.inspected?.inspection.mass_kg ?? session.model()?.inspected?.inspection.contacts_mass_kg?.value ?? undefined,
  };
}

/** The value that all spheres or forces have; undefined if they differ. */
function currentValue(session: Session, property: string): string | undefined {
  const inspection = session.model()?.inspected?.inspection;
  const radii = inspection?.spheres.map(({ radius_m: radius }) => radius);
  const values = property === "radius" ? radii : inspection?.forces.map(({ parameters }) => parameters[property]);
  const [first, ...others] = new Set(values);
  return typeof first === "number" && others.length === 0 ? digits(first, 6) : undefined;
}

function optionsOfSource(session: Session, source: Source): SelectOption[] {
  const inspection = session.model()?.inspected?.inspection;
  switch (source) {
    case "properties": {
      const names = new Set(["radius", ...(inspection?.forces ?? []).flatMap(({ parameters }) => Object.keys(parameters))]);
      return nameOptions(names.size > 1 ? SETTABLE_PROPERTIES.filter((name) => names.has(name)) : SETTABLE_PROPERTIES);
    }
    case "forces": return nameOptions((inspection?.forces ?? []).map(({ name }) => name));
    case "bodies": return nameOptions((inspection?.bodies ?? []).map(({ name }) => name));
    case "references": return [...fileOptions(session, source, "Files"), ...presetOptions(session)];
    default: return fileOptions(session, source);
  }
}

function nameOptions(names: readonly string[]): SelectOption[] {
  return [...new Set(names)].map((name) => ({ value: name, text: name }));
}

function fileOptions(session: Session, source: Source, heading?: string): SelectOption[] {
  const model = session.model();
  const current = model && currentFile(model);
  const kinds = KINDS[source] ?? [];
  const fitting = session.files.value.filter(({ name, kind }) => kinds.includes(kind) && name !== current);
  // The most likely kind comes first.
  fitting.sort((one, other) => kinds.indexOf(one.kind) - kinds.indexOf(other.kind));
  return fitting.map(({ name }) => ({ value: name, text: name, ...(heading === undefined ? {} : { heading }) }));
}

function presetOptions(session: Session): SelectOption[] {
  return session.presets.value.map(({ name, file }) => {
    const option = { value: name, text: name, heading: "Presets" };
    return file === undefined ? option : { ...option, alsoSets: { presets: file } };
  });
}
