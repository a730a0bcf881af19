// Declarations of forms. The build makes them from the JSON Schemas of the requests.

export type Source = "properties" | "forces" | "bodies" | "references" | "presets" | "scales" | "tables" | "geometries" | "models";

export type Kind = "number" | "integer" | "flag" | "choice" | "text" | "texts" | "lines" | "codes" | "map" | "rule" | "file";

interface Choice {
  value: string;
  text: string;
}

export interface Limits {
  least?: number;
  most?: number;
  above?: number;
  below?: number;
}

export interface Field {
  name: string;
  label: string;
  help: string;
  unit?: string;
  kind: Kind;
  choices?: Choice[];
  /** Whether a factor such as x1.5 may be given. */
  factor?: boolean;
  limits?: Limits;
  /** The source of its options. */
  source?: Source;
  /** The value that is used if the user gives none. */
  default?: string;
  /** The group of the field; empty for main fields. */
  group: string;
}

export interface Form {
  verb: string;
  fields: Field[];
  required: string[];
  /** Pairs of fields of which one or the other must be given. */
  either: [string, string][];
  excludes: [string, string][];
  needs: [string, string[]][];
}

export interface ChangeForm extends Form {
  title: string;
  about: string;
}

export interface Forms {
  changes: ChangeForm[];
  calculator: Form;
  questions: Form;
}
