// Finds the kind of a file from its name and its first kilobytes.

export type FileKind = "model" | "forces" | "geometry" | "scales" | "xml" | "mesh" | "table" | "presets" | "motion" | "plates" | "loads" | "other";

export interface FileEntry {
  name: string;
  bytes: number;
  kind: FileKind;
}

/** The name of each kind of file. */
export const KIND_TEXTS: Readonly<Record<FileKind, string>> = {
  model: "model", forces: "force set", geometry: "contact geometry set", scales: "scale set", xml: "XML file",
  mesh: "mesh", table: "table", presets: "presets", motion: "motion", plates: "force plates", loads: "external loads", other: "unknown kind",
};

const BY_ENDING: Readonly<Record<string, FileKind>> = {
  osim: "model", vtp: "mesh", stl: "mesh", obj: "mesh", csv: "table", tsv: "table", txt: "table", toml: "presets", mot: "motion", sto: "motion",
};

// The kind of an XML file by the first element inside OpenSimDocument.
const BY_ELEMENT: readonly [RegExp, FileKind][] = [
  [/<ForceSet[\s>]/, "forces"],
  [/<ContactGeometrySet[\s>]/, "geometry"],
  [/<ScaleSet[\s>]/, "scales"],
  [/<ExternalLoads[\s>]/, "loads"],
  [/<Model[\s>]/, "model"],
];

/** Bytes of a file that are read to find its kind. */
export const HEAD_BYTES = 4096;

/** The kind of a file whose content begins with `head`. */
export function kindOf(name: string, head: string): FileKind {
  const ending = /\.([^./\\]+)$/.exec(name)?.[1]?.toLowerCase() ?? "";
  const kind = BY_ENDING[ending] ?? "other";
  // A table over time belongs to force plates if its columns have the three components of a force.
  if (kind === "motion") return /\S*(v|f\d*)x\s+\S*(v|f\d*)y\s+\S*(v|f\d*)z/i.test(head) ? "plates" : "motion";
  if (ending !== "xml") return kind;
  const matches = BY_ELEMENT.map(([element, kind]) => ({ at: head.search(element), kind })).filter(({ at }) => at >= 0);
  return matches.sort((one, other) => one.at - other.at)[0]?.kind ?? "xml";
}

/**
 * Whether a file is worth reading. Folders have many large files beside models. A single file is always read, because a model may
 * include a file of any name.
 */
export function isUseful(name: string): boolean {
  return !name.includes("/") || kindOf(name, "") !== "other";
}
