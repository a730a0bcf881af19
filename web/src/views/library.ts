// The table of several open models, and what can be done with all of them.

import { close } from "../actions/close";
import { canChangeAll, changeAll, downloadAll, followAll } from "../actions/library";
import { findOriginal, inspectDetails } from "../actions/inspect";
import { button, byId, el, setAttribute, setText } from "../dom/element";
import { keepingFocus } from "../dom/focus";
import { counted, kilograms } from "../dom/number";
import { boxedTable } from "../dom/table";
import type { Failure } from "../engine/types";
import { CALCULATOR, findForm } from "../forms/all";
import { valueProblem } from "../forms/check";
import type { Context } from "../forms/context";
import { currentFile, isBare, type OpenModel, type Outcome } from "../state/model";
import type { Session } from "../state/session";
import { formContext } from "./context";
import { failureElements, failureView } from "./failure";

/** The columns with facts of a model; null is not known. */
const FACTS: readonly [title: string, fact: (model: OpenModel) => number | null | undefined][] = [
  ["mass", ({ inspected }) => inspected?.inspection.mass_kg],
  ["made for", ({ inspected }) => (inspected && !isBare(inspected) ? inspected.inspection.contacts_mass_kg?.value : null)],
  ["limbs", ({ inspected }) => inspected?.inspection.limbs?.length],
  ["spheres", ({ inspected }) => inspected?.inspection.spheres.length],
  ["findings", ({ inspected }) => inspected?.findings.length],
];
const MASS_COLUMNS = new Set(["mass", "made for"]);
const CAPTION = "Models that are open, those that failed first. A target mass in a row is for that model. Click a heading to sort.";

export class LibraryView {
  readonly #section = byId("library");
  readonly #box = el("details");
  readonly #heads = el("tr");
  readonly #rows = el("tbody");
  readonly #changeAll: HTMLButtonElement;
  readonly #zip: HTMLButtonElement;
  readonly #follow: HTMLButtonElement;
  readonly #original = el("select", { id: "library-original" });
  readonly #mass = el("input", { type: "text", inputmode: "decimal", id: "library-mass", class: "mass", autocomplete: "off" });
  readonly #massField = el("span", {}, el("label", { for: "library-mass" }, "Target mass of all (kg) "), this.#mass);
  readonly #title = el("h2", { id: "library-title" });
  readonly #shownRows = new Map<number, { model: OpenModel; chosen: boolean; mass: boolean; row: HTMLElement }>();
  readonly #question;
  /** The original that the user has chosen for all. */
  #saidOriginal = "";
  #isPair: boolean | undefined;
  #sorted = { column: "", down: false };

  constructor(readonly session: Session, addFile: Context["addFile"]) {
    this.#changeAll = button("Show what would change in all models", () => void changeAll(session), { id: "change-all" });
    this.#zip = button("Change all and download a ZIP", () => void downloadAll(session), { id: "download-all" });
    this.#follow = button("", () => void followAll(session, this.#original.value), { id: "follow-all" });
    const context = formContext(session, session.values, { prefix: "library-question", commit: "change", addFile });
    this.#question = failureView(() => findForm(session.verb.value) ?? CALCULATOR, context, this.#changeAll);
    const box = boxedTable("Models", CAPTION, this.#heads, this.#rows);
    const original = el("span", {}, el("label", { for: "library-original" }, "All were scaled from "), this.#original);
    const follow = el("div", { class: "buttons", role: "group", "aria-label": "Scaled models" }, original, this.#follow);
    const buttons = el("div", { class: "buttons", role: "group", "aria-label": "All models" }, this.#massField, this.#changeAll, this.#zip);
    this.#box.append(el("summary", {}, this.#title), follow, buttons, this.#question.element, box);
    this.#section.append(this.#box);
    this.#original.addEventListener("change", () => {
      this.#saidOriginal = this.#original.value;
      this.#updateButtons();
    });
    this.#mass.addEventListener("input", () => session.values.set("target_mass", this.#mass.value.trim()));
    session.models.watch(() => this.#update());
    session.chosen.watch((id) => {
      this.#update();
      if (id === null) return;
      void inspectDetails(session, id);
      void findOriginal(session, id);
    });
    session.changingAll.watch(() => this.#updateButtons());
    session.verb.watch(() => this.#clearOutcomes());
    session.values.watch(() => {
      // One answer is for all models.
      const isAnswer = this.#question.element.contains(document.activeElement);
      this.#clearOutcomes();
      if (isAnswer) void changeAll(session);
    });
  }

  #update(): void {
    const models = this.session.models.value;
    this.#section.hidden = models.length < 2;
    if (this.#section.hidden) return;
    setText(this.#title, counted(models.length, "model"));
    // A model and its original are no library: the steps stay in sight.
    const isPair = models.length === 2 && models.some(({ answers }) => models.some((other) => currentFile(other) === answers.text("from")));
    if (isPair !== this.#isPair) this.#box.open = !isPair;
    this.#isPair = isPair;
    const mass = findForm(this.session.verb.value)?.fields.some(({ name }) => name === "target_mass") ?? false;
    this.#massField.hidden = !mass;
    if (document.activeElement !== this.#mass) this.#mass.value = this.session.values.text("target_mass");
    this.#showHeads(mass);
    const rows = this.#inOrder(models).map((model) => this.#row(model, mass));
    const isSameOrder = rows.length === this.#rows.children.length && rows.every((row, index) => row === this.#rows.children[index]);
    if (!isSameOrder) keepingFocus(this.#rows, () => byId("model-title"), () => this.#rows.replaceChildren(...rows));
    const failures = models.flatMap(({ outcome }) => (outcome?.state === "failed" ? outcome.failure : []));
    this.#question.show(failures.find((failure) => failure.needs_answer));
    this.#updateOriginals(models);
    this.#updateButtons();
  }

  /** Models that failed first, then by the column that was clicked. */
  #inOrder(models: readonly OpenModel[]): OpenModel[] {
    const { column, down } = this.#sorted;
    const fact = FACTS.find(([title]) => title === column)?.[1];
    const compare = (one: OpenModel, other: OpenModel): number => {
      if (fact) return (fact(one) ?? Infinity) - (fact(other) ?? Infinity) || 0;
      const text = column === "result" ? ({ outcome }: OpenModel) => outcomeText(outcome) : currentFile;
      return column === "" ? 0 : text(one).localeCompare(text(other), undefined, { numeric: true });
    };
    const rank = (model: OpenModel) => (failureOf(model) ? 0 : 1);
    return [...models].sort((one, other) => rank(one) - rank(other) || (down ? -1 : 1) * compare(one, other));
  }

  #showHeads(mass: boolean): void {
    const head = (title: string, kind?: string) => {
      const { column, down } = this.#sorted;
      const sort = () => {
        this.#sorted = { column: title, down: column === title && !down };
        this.#update();
      };
      const order = column !== title ? undefined : down ? "descending" : "ascending";
      return el("th", { scope: "col", class: kind, "aria-sort": order }, button(title, sort, { class: "link" }));
    };
    const massHead = mass ? [el("th", { scope: "col" }, "target mass (kg)")] : [];
    const last = el("th", { scope: "col" }, el("span", { class: "hidden" }, "close"));
    const heads = [head("model", "words"), ...FACTS.map(([title]) => head(title)), ...massHead, head("result", "words"), last];
    keepingFocus(this.#heads, () => this.#title, () => this.#heads.replaceChildren(...heads));
  }

  /** Lists the models; the one that others were found to be scaled from is chosen. */
  #updateOriginals(models: readonly OpenModel[]): void {
    const names = models.map(currentFile);
    const found = models.map(({ answers }) => answers.text("from")).find((name) => names.includes(name)) ?? "";
    const key = names.join("\n");
    if (this.#original.dataset["names"] !== key) {
      this.#original.replaceChildren(el("option", { value: "" }, "not set"), ...names.map((name) => el("option", { value: name }, name)));
      this.#original.dataset["names"] = key;
    }
    this.#original.value = names.includes(this.#saidOriginal) ? this.#saidOriginal : found;
  }

  /** Removes the outcomes of all models after the user edited the change in the form. */
  #clearOutcomes(): void {
    const models = this.session.models.value;
    if (models.some(({ outcome }) => outcome)) this.session.models.set(models.map((model) => ({ ...model, outcome: null })));
    else this.#update();
  }

  #updateButtons(): void {
    const can = canChangeAll(this.session);
    const withContacts = this.session.models.value.filter(({ inspected }) => inspected && !isBare(inspected));
    const scaled = Math.max(0, withContacts.length - 1);
    setText(this.#follow, `Move the spheres of ${counted(scaled, "model")} with the bones, and download a ZIP`);
    this.#follow.disabled = this.#original.value === "";
    // Its own change is in the form after it was clicked.
    const follows = !this.#follow.disabled && (!can || this.session.values.text("from") === this.#original.value);
    this.#follow.classList.toggle("primary", follows);
    this.#changeAll.classList.toggle("primary", can && !follows);
    setAttribute(this.#follow, "aria-disabled", this.session.changingAll.value && "true");
    for (const one of [this.#changeAll, this.#zip]) {
      one.disabled = !can;
      // `disabled` would take the focus away from the button.
      setAttribute(one, "aria-disabled", this.session.changingAll.value && "true");
    }
  }

  /** The row of a model. In an old row, only cells that differ are replaced. */
  #row(model: OpenModel, mass: boolean): HTMLElement {
    const chosen = model.id === this.session.chosen.value;
    const shownRow = this.#shownRows.get(model.id);
    if (shownRow && shownRow.model === model && shownRow.chosen === chosen && shownRow.mass === mass) return shownRow.row;
    const massCells = mass ? [this.#massCell(model)] : [];
    const all = [this.#nameCell(model), ...factCells(model), ...massCells, outcomeCell(model), this.#closeCell(model)];
    const row = shownRow?.mass === mass ? shownRow.row : el("tr");
    setAttribute(row, "aria-current", chosen && "true");
    keepingFocus(row, () => byId("model-title"), () => updateRow(row, all));
    this.#shownRows.set(model.id, { model, chosen, mass, row });
    return row;
  }

  #nameCell(model: OpenModel): HTMLElement {
    const open = button(currentFile(model), () => this.session.chosen.set(model.id), { class: "link" });
    return el("th", { scope: "row" }, open);
  }

  #massCell(model: OpenModel): HTMLElement {
    const name = `Target mass of ${currentFile(model)} (kg)`;
    const input = el("input", { type: "text", inputmode: "decimal", class: "mass", "aria-label": name, autocomplete: "off" });
    input.value = model.targetMass;
    input.placeholder = "as above";
    const field = findForm(this.session.verb.value)?.fields.find(({ name: one }) => one === "target_mass");
    const problem = (field && model.targetMass !== "" && valueProblem(field, model.targetMass)) || "";
    const problemText = el("p", { class: "problem", id: `mass-problem-${model.id}`, role: "alert" }, problem);
    setAttribute(input, "aria-invalid", problem !== "" && "true");
    setAttribute(input, "aria-describedby", problemText.id);
    input.addEventListener("change", () => this.session.update(model.id, (open) => ({ ...open, targetMass: input.value.trim(), outcome: null })));
    return el("td", { class: "own" }, input, problemText);
  }

  #closeCell(model: OpenModel): HTMLElement {
    const { session } = this;
    const pressed = button("Close", () => {
      close(session, model);
      if (this.#section.hidden) byId("model-title").focus();
    }, { class: "small", "aria-label": `Close ${currentFile(model)}` });
    return el("td", { class: "acts" }, pressed);
  }
}

/** Replaces cells that differ. Equal cells stay, because the user may be typing in a cell or reading it. */
function updateRow(row: HTMLElement, cells: readonly HTMLElement[]): void {
  if (row.children.length === 0) row.append(...cells);
  for (const [index, cell] of cells.entries()) {
    const oldCell = row.children[index];
    if (oldCell && !oldCell.isEqualNode(cell)) oldCell.replaceWith(cell);
  }
}

/** The cells with the facts of a model; dashes for what is not known. */
function factCells(model: OpenModel): HTMLElement[] {
  return FACTS.map(([title, fact]) => {
    const value = fact(model);
    return el("td", {}, value == null ? "–" : MASS_COLUMNS.has(title) ? kilograms(value) : String(value));
  });
}

/** Why a model could not be opened or changed. */
function failureOf({ failure, outcome }: OpenModel): Failure | undefined {
  return failure ?? (outcome?.state === "failed" ? outcome.failure : undefined);
}

function outcomeCell(model: OpenModel): HTMLElement {
  const failed = failureOf(model);
  return el("td", { class: "words outcome" }, ...(failed ? failureElements(failed) : [outcomeText(model.outcome)]));
}

function outcomeText(outcome: Outcome | null): string {
  return outcome && outcome.state !== "failed" ? outcome.text : "";
}
