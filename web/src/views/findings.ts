// Shows the findings of a model.

import { el } from "../dom/element";
import { counted } from "../dom/number";
import { findingAnchor } from "../engine/anchor";
import type { Finding } from "../engine/types";
import { sentence } from "./failure";

/** The findings as items of a list. */
export function findingItems(findings: readonly Finding[]): HTMLElement[] {
  return findings.map(findingItem);
}

function findingItem({ code, severity, message, place, line, details }: Finding): HTMLElement {
  const where = [place, line === null ? null : `line ${line}`].filter(Boolean).join(", ");
  const text = el("p", {},
    el("span", { class: `tag ${severity}` }, severity), " ",
    el("a", { class: "code", href: `#${findingAnchor(code)}` }, code), " ", sentence(message),
    ...(where ? [" ", el("span", { class: "quiet" }, where)] : []));
  if (details.length < 2) return el("li", {}, text);
  const sentences = details.map((detail) => el("li", {}, sentence(detail)));
  return el("li", {}, text, el("details", {}, el("summary", {}, counted(details.length, "element")), el("ul", {}, ...sentences)));
}
