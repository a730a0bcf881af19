// Answers of the engine, as crates/osim-web writes them.

import type { Fall, Scene } from "./space";

/** Why a request failed. */
export interface Failure {
  code: string;
  message: string;
  model?: string | null;
  line?: number | null;
  column?: number | null;
  excerpt?: { before: string; marked: string; after: string } | null;
  needs_answer: boolean;
  /** Fields that would answer the question, most likely first. */
  fields: string[];
  /** The field whose value is wrong. */
  field?: string | null;
}

/** A piece of a report. */
export interface Section {
  id: string;
  title: string;
  html: string;
}

/** The explanation that a link in a section opens. */
export interface Explained {
  id: string;
  html: string;
}

export type Request = { verb: string; models?: string[] } & Record<string, unknown>;

export interface Finding {
  code: string;
  severity: "remark" | "warning" | "error";
  message: string;
  line: number | null;
  place: string | null;
  spheres: string[];
  details: string[];
  as_published: boolean;
  remedy: { text: string; request: Request } | null;
}

/** The fields of an inspection that the page reads; all are in schemas/results/inspection.schema.json. */
export interface Inspection {
  name: string | null;
  mass_kg: number | null;
  gravity_m_s2: number | null;
  contacts_mass_kg: { value: number; source: string } | null;
  /** Null if left and right cannot be distinguished. */
  limbs: { name: string; side: string | null; spheres: string[] }[] | null;
  spheres: { name: string; radius_m: number | null }[];
  forces: { name: string; type: string; applies: boolean; parameters: Record<string, number | null> }[];
  bodies: { name: string; mass_kg: number | null }[];
  known_contacts?: { title: string; made_for_kg: number } | null;
}

/** A question about a model and its answer. */
export interface Verdict {
  question: string;
  on: string;
  sign: "good" | "remark" | "warning" | "error" | "unknown";
  text: string;
  place: string | null;
  /** Codes of the findings about this question. */
  codes: string[];
}

export interface Inspected {
  inspection: Inspection;
  findings: Finding[];
  verdicts: Verdict[];
  sections: Section[];
  explained?: Explained[];
  files: string[];
  /** Only if the request asks for it. */
  scene: Scene | null;
  falls: Fall[];
}

/** The fields of a change that the page reads; all are in schemas/results/change.schema.json. */
export interface ChangeRecord {
  contacts_mass_kg: { value: number; source: string } | null;
  target_mass_kg: number | null;
  objects: { change: string; class: string; path: string }[];
  changes: { path: string; property: string; from: unknown; to: unknown; factor: number | null }[];
  remarks: string[];
}

interface ResultFile {
  name: string;
  bytes: number;
}

export interface Change {
  record: ChangeRecord;
  unchanged: boolean;
  results: ResultFile[];
  sections: Section[];
  explained?: Explained[];
  /** About the new model, if the request asks for findings. */
  verdicts: Verdict[] | null;
  findings: Finding[] | null;
  /** The new model in three dimensions, and falls on the contacts before and after, if the request asks for them. */
  scene: Scene | null;
  falls: Fall[];
}

export interface Kept {
  model: string;
  names: string[];
}

export interface Sheet {
  figures: {
    name: string;
    value: number | null;
    unit: string;
    equation: string;
    given: boolean;
    limit: { text: string; within_limit: boolean } | null;
  }[];
  remarks: string[];
}

export interface Spelled {
  command: string;
  python: string;
  matlab: string;
}

export interface Preset {
  name: string;
}

/** Bytes with the name of their file. */
export interface NamedBytes {
  name: string;
  bytes: Uint8Array;
}
