// The six questions about a model in the rows and words of `check`: the worst first, what is good in one row.

import { el } from "../dom/element";
import type { Finding, Verdict } from "../engine/types";
import { findingItems } from "./findings";
import { sentence } from "./failure";

const WORST_FIRST = ["error", "warning", "remark"];

/** The rows; those in `open` are unfolded. */
export function verdictRows(verdicts: readonly Verdict[], findings: readonly Finding[], open: ReadonlySet<string>): HTMLElement[] {
  const isAsPublished = (finding: Finding) => finding.as_published;
  const answers = verdicts.map((verdict) => {
    const its = findings.filter(({ code }) => verdict.codes.includes(code));
    const published = its.length > 0 && its.every(isAsPublished);
    const order = ({ code }: Finding) => verdict.codes.indexOf(code);
    const [worst] = its.filter((finding) => !isAsPublished(finding)).sort((one, other) => order(one) - order(other));
    // The verdict has the text of the worst finding, which may be as published.
    const other = WORST_FIRST.includes(verdict.sign) && worst && order(worst) > 0 ? { sign: worst.severity, text: worst.message, place: worst.place } : {};
    return { ...verdict, ...other, its, worst, published };
  });
  const others = findings.filter((finding) => !isAsPublished(finding) && !verdicts.some(({ codes }) => codes.includes(finding.code)));
  const fileRows = others.map((finding) => ({ on: "file", sign: finding.severity, text: finding.message, place: finding.place, its: [finding], worst: finding }));
  const bad = [...answers.filter(({ sign, published }) => !published && WORST_FIRST.includes(sign)), ...fileRows];
  bad.sort((one, other) => WORST_FIRST.indexOf(one.sign) - WORST_FIRST.indexOf(other.sign));
  const good = answers.filter(({ sign, published }) => published || sign === "good");
  const unknown = answers.filter(({ sign }) => sign === "unknown");
  return [
    ...bad.map(({ on, sign, text, place, its, worst }) => verdictRow(sign, on, withPlace(text, place, worst), el("ul", { class: "findings" }, ...findingItems(its)), open)),
    ...rowOfAnswers("good", good, open), ...rowOfAnswers("unknown", unknown, open),
  ];
}

/** The rows that are unfolded in a box, before it is filled again. */
export function openRows(box: Element): Set<string> {
  return new Set([...box.querySelectorAll<HTMLDetailsElement>("details.verdict[open]")].map(({ dataset }) => dataset["on"] ?? ""));
}

interface Answer extends Verdict {
  its: readonly Finding[];
  published: boolean;
}

/** One row for several verdicts, such as "good floor, sides; solver as published". */
function rowOfAnswers(sign: Verdict["sign"], answers: readonly Answer[], open: ReadonlySet<string>): HTMLElement[] {
  if (answers.length === 0) return [];
  const names = (published: boolean) => answers.filter((one) => one.published === published).map(({ on }) => on).join(", ");
  const [why] = sign === "unknown" ? answers.map(({ text }) => `: ${text}`) : [];
  const parts = [names(false) && `${names(false)}${why ?? ""}`, names(true) && `${names(true)} as published`].filter(Boolean);
  const items = answers.map(({ question, text }) => el("li", {}, el("strong", {}, question), " ", sentence(text)));
  const remarks = findingItems(answers.flatMap(({ its }) => its));
  return [verdictRow(sign, sign, parts.join("; "), el("ul", { class: "findings" }, ...items, ...remarks), open)];
}

/** A message about spheres names the worst one, or says that it is about all. */
function withPlace(text: string, place: string | null, finding: Finding | undefined): string {
  const name = place?.split("/").pop() ?? "";
  return text.includes(name) || finding?.spheres.length ? text : `${text} (${name})`;
}

function verdictRow(sign: string, on: string, text: string, body: HTMLElement, open: ReadonlySet<string>): HTMLElement {
  const name = on === sign ? [] : [el("strong", {}, on), " "];
  const head = el("summary", {}, el("span", { class: `tag ${sign}` }, sign), " ", ...name, el("span", {}, text));
  return el("details", { class: "verdict", "data-on": on, open: open.has(on) }, head, body);
}
