// Anchors of explanations, as crates/osim-view/src/html/explained.rs spells them, and the topics that they are about.

export function equationAnchor(label: string): string {
  return `equation-${label.toLowerCase().replace(/[^a-z0-9]/g, "-")}`;
}

export function findingAnchor(code: string): string {
  return `finding-${code}`;
}

/** `equation-c-2` is about C.2, `finding-beyond-hertz` about beyond-hertz. */
export function topicOf(anchor: string): string {
  const equation = /^equation-(.+)$/.exec(anchor)?.[1];
  if (equation !== undefined) return equation.toUpperCase().replace("-", ".");
  return anchor.replace(/^(finding|error)-/, "");
}
