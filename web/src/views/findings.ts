// What is wrong with a model, and what puts it right.

import { button, el } from "../dom/element";
import { findingAnchor } from "../engine/anchor";
import type { Finding } from "../engine/types";
import { sentence } from "./failure";

type Apply = (finding: Finding) => void;

/** The findings as a list; each that can be put right has a button for it. */
export function findingsList(findings: readonly Finding[], apply: Apply): HTMLElement {
  if (findings.length === 0) return el("p", { class: "quiet" }, "Nothing is wrong with the contacts.");
  return el("ul", { class: "findings" }, ...findings.map((finding) => item(finding, apply)));
}

function item(finding: Finding, apply: Apply): HTMLElement {
  const { code, severity, message, place, line, remedy } = finding;
  const where = [place, line === null ? null : `line ${line}`].filter(Boolean).join(", ");
  const text = el("p", {},
    el("span", { class: `tag ${severity}` }, severity), " ",
    el("a", { class: "code", href: `#${findingAnchor(code)}` }, code), " ", sentence(message),
    ...(where ? [" ", el("span", { class: "quiet" }, where)] : []));
  const act = remedy ? [el("p", {}, button(`Apply: ${remedy.text}`, () => apply(finding), { class: "apply" }))] : [];
  return el("li", {}, text, ...act);
}
