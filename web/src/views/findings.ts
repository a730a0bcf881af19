// Shows the findings of a model.

import { el } from "../dom/element";
import { counted } from "../dom/number";
import { findingAnchor } from "../engine/anchor";
import type { Finding } from "../engine/types";
import { sentence } from "./failure";

/** The findings as items of a list; equal findings about many places are one item. */
export function findingItems(findings: readonly Finding[]): HTMLElement[] {
  const groups = new Map<string, Finding[]>();
  for (const finding of findings) {
    const key = JSON.stringify([finding.code, finding.severity, finding.remedy]);
    groups.set(key, [...(groups.get(key) ?? []), finding]);
  }
  return [...groups.values()].flatMap((group) => (group.length >= MIN_GROUP ? [groupItem(group)] : group.map((finding) => findingItem(finding))));
}

/** The number of equal findings about different places from which on they are one item. */
const MIN_GROUP = 3;

function groupItem(findings: readonly Finding[]): HTMLElement {
  const [first, ...others] = findings;
  if (!first) return el("li");
  const element = findingItem(first);
  const furtherItems = others.map(({ message, line }) => el("li", {}, sentence(message), ...(line === null ? [] : [" ", el("span", { class: "quiet" }, `line ${line}`)])));
  element.append(el("details", {}, el("summary", {}, `The same ${counted(others.length, "more time", "more times")}`), el("ul", {}, ...furtherItems)));
  return element;
}

function findingItem({ code, severity, message, place, line }: Finding): HTMLElement {
  const where = [place, line === null ? null : `line ${line}`].filter(Boolean).join(", ");
  const text = el("p", {},
    el("span", { class: `tag ${severity}` }, severity), " ",
    el("a", { class: "code", href: `#${findingAnchor(code)}` }, code), " ", sentence(message),
    ...(where ? [" ", el("span", { class: "quiet" }, where)] : []));
  return el("li", {}, text);
}
