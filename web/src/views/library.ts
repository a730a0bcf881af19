// The table of several open models.

import { close } from "../actions/close";
import { canChangeAll, changeAll, downloadAll } from "../actions/library";
import { findOriginals, inspectDetails } from "../actions/inspect";
import { button, byId, el, setAttribute, setText } from "../dom/element";
import { keepingFocus } from "../dom/focus";
import { counted, kilograms } from "../dom/number";
import { boxedTable, type Head, headCells } from "../dom/table";
import { findForm } from "../forms/all";
import { valueProblem } from "../forms/check";
import { currentFile, type OpenModel, type Outcome } from "../state/model";
import type { Session } from "../state/session";
import { failureElements } from "./failure";

const FACTS = ["mass", "made for", "limbs", "spheres", "findings"];
const CAPTION = "Models that are open. The change in the form below can be done to all of them; a target mass in a row is for that model.";

export class LibraryView {
  readonly #section = byId("library");
  readonly #heads = el("tr");
  readonly #rows = el("tbody");
  readonly #changeAll: HTMLButtonElement;
  readonly #zip: HTMLButtonElement;
  readonly #title = el("h2", { id: "library-title" });
  readonly #shownRows = new Map<number, { model: OpenModel; chosen: boolean; mass: boolean; row: HTMLElement }>();

  constructor(readonly session: Session) {
    this.#changeAll = button("Show what would change in all models", () => void changeAll(session), { class: "primary", id: "change-all" });
    this.#zip = button("Change all and download a ZIP", () => void downloadAll(session), { id: "download-all" });
    const box = boxedTable("Models", CAPTION, this.#heads, this.#rows);
    const buttons = el("div", { class: "buttons", role: "group", "aria-label": "All models" }, this.#changeAll, this.#zip);
    this.#section.append(this.#title, box, buttons);
    session.models.watch(() => this.#update());
    session.chosen.watch((id) => {
      this.#update();
      if (id === null) return;
      void inspectDetails(session, id);
      void findOriginals(session, id);
    });
    session.changingAll.watch(() => this.#updateButtons());
    session.verb.watch(() => this.#clearOutcomes());
    session.values.watch(() => this.#clearOutcomes());
  }

  #update(): void {
    const models = this.session.models.value;
    this.#section.hidden = models.length < 2;
    if (this.#section.hidden) return;
    setText(this.#title, counted(models.length, "model"));
    const mass = findForm(this.session.verb.value)?.fields.some(({ name }) => name === "target_mass") ?? false;
    this.#heads.replaceChildren(...headCells(heads(mass)));
    const rows = models.map((model) => this.#row(model, mass));
    const isSameCell = rows.length === this.#rows.children.length && rows.every((row, index) => row === this.#rows.children[index]);
    if (!isSameCell) keepingFocus(this.#rows, () => byId("model-title"), () => this.#rows.replaceChildren(...rows));
    this.#updateButtons();
  }

  /** Removes the outcomes of all models after the user edited the change in the form. */
  #clearOutcomes(): void {
    const models = this.session.models.value;
    if (models.some(({ outcome }) => outcome)) this.session.models.set(models.map((model) => ({ ...model, outcome: null })));
    else this.#update();
  }

  #updateButtons(): void {
    const can = canChangeAll(this.session);
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
    const all = [this.#nameCell(model), ...cells(model), ...massCells, outcomeCell(model), this.#closeCell(model)];
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
    input.placeholder = "as in the form";
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
    if (oldCell && !isSameCell(oldCell, cell)) oldCell.replaceWith(cell);
  }
}

function isSameCell(one: Element, other: Element): boolean {
  // An open error is equal to a closed one.
  const closed = one.cloneNode(true) as Element;
  closed.querySelector("details")?.removeAttribute("open");
  return closed.isEqualNode(other);
}

function heads(mass: boolean): Head[] {
  const massHead = mass ? [{ text: "target mass (kg)" }] : [];
  const facts = FACTS.map((text) => ({ text }));
  return [{ text: "model", words: true }, ...facts, ...massHead, { text: "result", words: true }, { text: "close", hidden: true }];
}

/** The cells with the facts of a model; dashes if it could not be opened. */
function cells({ inspected }: OpenModel): HTMLElement[] {
  if (!inspected) return FACTS.map(() => el("td", {}, "–"));
  const { mass_kg: mass, contacts_mass_kg: contactsMass, limbs, spheres } = inspected.inspection;
  const counts = [limbs?.length, spheres.length, inspected.findings.length].map((count) => (count === undefined ? "–" : String(count)));
  const masses = [mass, contactsMass?.value].map((kg) => (kg == null ? "–" : kilograms(kg)));
  return [...masses, ...counts].map((text) => el("td", {}, text));
}

function outcomeCell({ failure, outcome }: OpenModel): HTMLElement {
  const failed = failure ?? (outcome?.state === "failed" ? outcome.failure : undefined);
  if (!failed) return el("td", { class: "words outcome" }, outcomeText(outcome));
  const summary = el("summary", {}, el("span", { class: "tag error" }, "error"), " ", short(failed.message));
  return el("td", { class: "words outcome" }, el("details", {}, summary, ...failureElements(failed)));
}

function outcomeText(outcome: Outcome | null): string {
  return outcome && outcome.state !== "failed" ? outcome.text : "";
}

function short(message: string): string {
  return message.length > 70 ? `${message.slice(0, 70)}…` : message;
}
