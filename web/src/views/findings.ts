// Shows the findings of a model with their remedies.

import { button, el } from "../dom/element";
import { counted } from "../dom/number";
import { findingAnchor } from "../engine/anchor";
import type { Finding } from "../engine/types";
import { sentence } from "./failure";

export type Apply = (finding: Finding) => void;

/** The findings as items of a list. Errors and warnings with a remedy have a button; remarks have none. */
export function findingItems(findings: readonly Finding[], apply: Apply): HTMLElement[] {
  const groups = new Map<string, Finding[]>();
  for (const finding of findings) {
    const key = JSON.stringify([finding.code, finding.severity, finding.remedy]);
    groups.set(key, [...(groups.get(key) ?? []), finding]);
  }
  return [...groups.values()].flatMap((group) => (group.length >= MIN_GROUP ? [groupItem(group, apply)] : group.map((finding) => item(finding, apply))));
}

/** The number of equal findings about different places from which on they are one item. */
const MIN_GROUP = 3;

function groupItem(findings: readonly Finding[], apply: Apply): HTMLElement {
  const [first, ...others] = findings;
  if (!first) return el("li");
  const element = item(first, apply);
  const furtherItems = others.map(({ message, line }) => el("li", {}, sentence(message), ...(line === null ? [] : [" ", el("span", { class: "quiet" }, `line ${line}`)])));
  element.append(el("details", {}, el("summary", {}, `The same ${counted(others.length, "more time", "more times")}`), el("ul", {}, ...furtherItems)));
  return element;
}

function item(finding: Finding, apply: Apply): HTMLElement {
  const { code, severity, message, place, line, remedy } = finding;
  const where = [place, line === null ? null : `line ${line}`].filter(Boolean).join(", ");
  const text = el("p", {},
    el("span", { class: `tag ${severity}` }, severity), " ",
    el("a", { class: "code", href: `#${findingAnchor(code)}` }, code), " ", sentence(message),
    ...(where ? [" ", el("span", { class: "quiet" }, where)] : []));
  const act = remedy && severity !== "remark" ? [el("p", {}, button(`Apply: ${remedy.text}`, () => apply(finding), { class: "apply" }))] : [];
  return el("li", {}, text, ...act);
}
