// Anchors of explanations, as in crates/osim-view/src/html/explained.rs, and their topics.

export function equationAnchor(label: string): string {
  return `equation-${label.toLowerCase().replace(/[^a-z0-9]/g, "-")}`;
}

export function findingAnchor(code: string): string {
  return `finding-${code}`;
}

/** The topic of an anchor: C.2 for `equation-c-2`, beyond-hertz for `finding-beyond-hertz`. */
export function anchorTopic(anchor: string): string {
  const equation = /^equation-(.+)$/.exec(anchor)?.[1];
  if (equation !== undefined) return equation.toUpperCase().replace("-", ".");
  return anchor.replace(/^(finding|error)-/, "");
}
