// The questions about a model, each with its answer in one line and its findings below, on demand.

import { el } from "../dom/element";
import type { Finding, Verdict } from "../engine/types";
import { type Apply, findingItems } from "./findings";
import { sentence } from "./failure";

const SIGNS: Readonly<Record<Verdict["sign"], [string, string]>> = {
  good: ["✓", "yes"], remark: ["i", "remark"], warning: ["!", "warning"], error: ["×", "no"], unknown: ["?", "not known"],
};

/** The verdicts with their findings, then the findings that belong to no verdict. */
export function verdictList(verdicts: readonly Verdict[], findings: readonly Finding[], apply: Apply, open: ReadonlySet<string>): HTMLElement {
  const otherFindings = findings.filter(({ code }) => !verdicts.some(({ codes }) => codes.includes(code)));
  const lines = verdicts.map((verdict) => verdictElement(verdict, findings.filter(({ code }) => verdict.codes.includes(code)), apply, open.has(verdict.on)));
  const others = otherFindings.length > 0 ? [el("h4", {}, "Also"), el("ul", { class: "findings" }, ...findingItems(otherFindings, apply))] : [];
  return el("div", { class: "verdicts" }, ...lines, ...others);
}

/** The verdicts that are open in a list, before it is created again. */
export function openVerdicts(box: Element): Set<string> {
  return new Set([...box.querySelectorAll<HTMLDetailsElement>("details.verdict[open]")].map(({ dataset }) => dataset["on"] ?? ""));
}

function verdictElement({ question, on, sign, text, place }: Verdict, findings: readonly Finding[], apply: Apply, open: boolean): HTMLElement {
  const [mark, signText] = SIGNS[sign];
  const where = place !== null && !text.includes(place) ? ` ${place}` : "";
  const head = el("summary", {},
    el("span", { class: `sign ${sign}`, role: "img", "aria-label": signText }, mark), " ",
    el("span", { class: "asked" }, question), " ", el("span", { class: "short quiet" }, text));
  // Findings with a button are open at first.
  const acts = findings.some(({ remedy, severity }) => remedy && severity !== "remark");
  const body = findings.length > 0
    ? el("ul", { class: "findings" }, ...findingItems(findings, apply))
    : el("p", {}, sentence(text), el("span", { class: "quiet" }, where));
  return el("details", { class: "verdict", "data-on": on, open: open || acts }, head, body);
}
