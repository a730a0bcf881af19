// The calculator: parameters of a contact without a model.

import { button, byId, el, setAttribute } from "../dom/element";
import { digits, unitText } from "../dom/number";
import { boxedTable, headCells } from "../dom/table";
import { equationAnchor } from "../engine/anchor";
import { toFailure } from "../engine/failure";
import type { Sheet } from "../engine/types";
import { CALCULATOR } from "../forms/all";
import type { Context } from "../forms/context";
import { showForm } from "../forms/form";
import { givenFields, problems } from "../forms/request";
import type { Session } from "../state/session";
import { formContext } from "./context";
import { failureView, sentence } from "./failure";

const REST_BEFORE_ANSWER_MS = 200;

export function calculatorView(session: Session, addFile: Context["addFile"]): void {
  const section = byId("calculator");
  const toggle = byId("calculate");
  const title = el("h2", { id: "calculator-title", tabindex: -1 }, "Calculate without a model");
  const context = formContext(session, session.calculation, { prefix: "calculator", commit: "input", addFile });
  const form = showForm(CALCULATOR, context);
  const answers = formContext(session, session.calculation, { prefix: "calculator-question", commit: "change", addFile });
  const failure = failureView(() => CALCULATOR, answers, title);
  const sheet = el("div", { class: "sheet", "aria-live": "polite" });
  const submit = el("button", { type: "submit", class: "primary", id: "calculate-now" }, "Calculate");
  const clear = button("Clear the form", () => session.calculation.clear(), { class: "small" });
  const formElement = el("form", { novalidate: true }, form.element, el("p", { class: "buttons" }, submit, clear));
  const about = el("p", { class: "quiet" },
    "Say what you know and what you want, such as radius, mass, spheres and relative indentation. All the rest follows.");
  section.append(title, about, el("div", { class: "columns" }, formElement, el("div", {}, failure.element, sheet)));
  formElement.addEventListener("submit", (event) => {
    event.preventDefault();
    void calculate();
  });
  const calculate = async () => {
    const fieldProblems = problems(CALCULATOR, session.calculation);
    if (fieldProblems.size > 0) {
      failure.show(undefined);
      // Each problem is shown beside its field.
      formElement.querySelector<HTMLElement>("[aria-invalid=true]")?.focus();
      return sheet.replaceChildren();
    }
    try {
      const answer = await session.engine.calculate({ verb: "design", ...givenFields(CALCULATOR, session.calculation) });
      failure.show(undefined);
      sheet.replaceChildren(sheetTable(answer.sheet), textOfResult(answer.text));
    } catch (error) {
      sheet.replaceChildren();
      failure.show(toFailure(error));
    }
  };
  // After the first calculation, the result follows the form.
  let timer: ReturnType<typeof setTimeout> | undefined;
  session.calculation.watch(() => {
    clearTimeout(timer);
    if (session.calculating.value && (sheet.hasChildNodes() || !failure.element.hidden)) timer = setTimeout(() => void calculate(), REST_BEFORE_ANSWER_MS);
  });
  toggle.addEventListener("click", () => session.calculating.set(!session.calculating.value));
  session.calculating.watch((calculating) => {
    section.hidden = !calculating;
    setAttribute(toggle, "aria-expanded", String(calculating));
    if (calculating) title.focus();
  });
}

function sheetTable({ figures, remarks }: Sheet): HTMLElement {
  const heads = ["quantity", "value", "unit", "equation", "remark"].map((text) => ({ text, words: text !== "value" }));
  const [head, body] = [el("tr", {}, ...headCells(heads)), el("tbody", {}, ...figures.map(figureRow))];
  const box = boxedTable("Result of the calculation", "What follows for one contact sphere.", head, body);
  return el("div", {}, box, el("ul", {}, ...remarks.map((remark) => el("li", {}, sentence(remark)))));
}

function figureRow({ name, value, unit, equation, given, limit }: Sheet["figures"][number]): HTMLElement {
  const outside = limit !== null && !limit.within_limit;
  const remarks = [given ? "given" : "", limit ? `${outside ? "! outside" : "within"}: ${limit.text}` : ""].filter(Boolean).join("; ");
  const links = equation.split(/, /).filter(Boolean).flatMap((label, index) => [index > 0 ? ", " : "", equationLink(label)]);
  return el("tr", {},
    el("th", { scope: "row" }, quantityName(name, unit)),
    el("td", { class: outside ? "outside" : undefined }, value === null ? "–" : digits(value)),
    el("td", { class: "words" }, unitText(unit)), el("td", { class: "words" }, ...links), el("td", { class: "words" }, remarks));
}

function equationLink(label: string): HTMLElement {
  return el("a", { href: `#${equationAnchor(label)}` }, `(${label})`);
}

/** `contact_stiffness_n_m` with the unit N/m is "contact stiffness". */
function quantityName(name: string, unit: string): string {
  const ending = `_${unit.toLowerCase().replace("/", "_")}`;
  const stem = unit !== "" && name.endsWith(ending) ? name.slice(0, -ending.length) : name;
  return stem.replace(/_/g, " ");
}

function textOfResult(text: string): HTMLElement {
  const lines = el("pre", { tabindex: 0, "aria-label": "The result as text" }, text);
  return el("details", {}, el("summary", {}, "As text, to copy"), lines);
}
