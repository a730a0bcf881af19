// The model that is open: what it is, what is wrong, its feet, and what was changed.

import { close } from "../actions/close";
import { apply, goTo, redo, undo } from "../actions/apply";
import { downloadModel, downloadReport } from "../actions/download";
import { inspect } from "../actions/inspect";
import { button, byId, el, setText } from "../dom/element";
import type { Failure, Finding, Inspected } from "../engine/types";
import { QUESTIONS } from "../forms/all";
import type { Context } from "../forms/context";
import { answered } from "../state/answers";
import { fileOf, type OpenModel, stepOf } from "../state/model";
import type { Session } from "../state/session";
import { type Compared, comparedView } from "./compared";
import { contextOf } from "./context";
import { type FailureView, failureView } from "./failure";
import { findingsList } from "./findings";
import { type Place, place } from "./sections";
import { stepButtons, stepList } from "./steps";
import { summary } from "./summary";

const PREFIX = "model";
const FOLDED = ["contacts", "figures", "plots", "state", "model"];

export class ModelView {
  readonly #section = byId("model");
  readonly #title = el("h2", { id: "model-title", tabindex: -1 });
  readonly #buttons = el("div", { class: "buttons" });
  readonly #summary = el("div", { class: "summary-box" });
  readonly #steps = el("div", { class: "buttons", role: "group", "aria-label": "History" });
  readonly #history = el("div", { class: "history" });
  readonly #findings = el("div", { class: "findings-box" });
  readonly #applied = el("section", { class: "applied", id: "applied", "aria-labelledby": "applied-title", hidden: true });
  readonly #feet = place({ prefix: PREFIX, id: "feet" });
  readonly #folded: Place[] = FOLDED.map((id) => place({ prefix: PREFIX, id, folded: true }));
  readonly #compared: Compared;
  #failure: FailureView | undefined;
  #failureBox = el("div");
  #shown: OpenModel | undefined;
  #alone = false;

  constructor(readonly session: Session, readonly addFile: Context["addFile"]) {
    const findings = el("div", { class: "section" }, el("h3", { id: "findings-title" }, "Findings"), this.#findings);
    this.#compared = comparedView(session, addFile);
    const left = el("div", { class: "left" }, this.#summary, findings, this.#compared.element);
    const right = el("div", { class: "right" }, this.#feet.element, ...this.#folded.map(({ element }) => element));
    const head = el("div", { class: "head" }, this.#title, el("div", { class: "buttons" }, this.#steps, this.#buttons));
    this.#section.append(head, this.#history, this.#failureBox, this.#applied, el("div", { class: "columns" }, left, right));
    session.models.watch(() => this.#update());
    session.files.watch(() => this.#failure?.refresh());
    session.chosen.watch(() => this.#update());
  }

  #update(): void {
    const model = this.session.model();
    this.#section.hidden = !model;
    const alone = this.session.models.value.length === 1;
    if (model && alone !== this.#alone) this.#showButtons(model);
    this.#alone = alone;
    if (!model || model === this.#shown) return;
    // What stays is not made again: a reader may be in it.
    const before = model.id === this.#shown?.id ? this.#shown : undefined;
    this.#shown = model;
    if (!before) this.#takeAnswers(model);
    setText(this.#title, fileOf(model));
    const moved = before?.steps !== model.steps || before.at !== model.at;
    if (moved || (before.inspected === null) !== (model.inspected === null)) this.#showButtons(model);
    if (moved) this.#showHistory(model);
    if (before?.failure !== model.failure) this.#failure?.show(model.failure ?? undefined);
    this.#section.classList.toggle("broken", model.inspected === null);
    if (model.inspected) this.#showInspected(model, model.inspected, before?.inspected ?? null);
    if (moved) this.#showApplied(model);
  }

  #showHistory(model: OpenModel): void {
    const acts = {
      undo: () => this.#keepFocus("undo", () => undo(this.session)),
      redo: () => this.#keepFocus("redo", () => redo(this.session)),
      goTo: (at: number) => {
        void goTo(this.session, model.id, at);
        this.#title.focus();
      },
    };
    this.#steps.replaceChildren(...stepButtons(model, acts));
    this.#history.replaceChildren(...stepList(model, acts));
  }

  /** Questions about the model are answered here, and asked again then. */
  #takeAnswers(model: OpenModel): void {
    const context = contextOf(this.session, model.answers, { prefix: `answer-${model.id}`, commit: "change", addFile: this.addFile });
    this.#failure = failureView(() => QUESTIONS, context, this.#title);
    this.#failureBox.replaceChildren(this.#failure.element);
    this.#compared.about(model);
    model.answers.watch(() => void inspect(this.session, model.id));
  }

  #showButtons(model: OpenModel): void {
    const { session } = this;
    const request = () => ({ ...answered(model, QUESTIONS), verb: "inspect", models: [fileOf(model)] });
    this.#buttons.replaceChildren(
      ...(model.at > 0 ? [button(`Download ${fileOf(model)}`, () => void downloadModel(session, model), { class: "primary" })] : []),
      ...(model.inspected ? [button("Report about this model", () => void downloadReport(session, request()).then(this.#say))] : []),
      // Among several, each has this button in its row.
      ...(session.models.value.length === 1 ? [button("Close", () => this.#close(model), { "aria-label": `Close ${fileOf(model)}` })] : []),
    );
  }

  #close(model: OpenModel): void {
    close(this.session, model);
    byId("choose-files").focus();
  }

  #showInspected(model: OpenModel, seen: Inspected, before: Inspected | null): void {
    if (seen.inspection !== before?.inspection) this.#summary.replaceChildren(summary(seen));
    const act = (finding: Finding) => void this.#apply(model, finding);
    if (seen.findings !== before?.findings) this.#findings.replaceChildren(findingsList(seen.findings, act));
    const sections = new Map(seen.sections.map((section) => [section.id, section]));
    this.#feet.show(sections.get("feet"));
    for (const [index, id] of FOLDED.entries()) this.#folded[index]?.show(sections.get(id));
  }

  #showApplied(model: OpenModel): void {
    const step = stepOf(model);
    this.#applied.hidden = !step;
    if (!step) return;
    const changes = place({ prefix: "applied", id: "changes", title: "What it changed", folded: true });
    changes.element.setAttribute("open", "");
    changes.show(step.sections.find(({ id }) => id === "changes"));
    this.#applied.replaceChildren(
      el("h3", { id: "applied-title", tabindex: -1 }, `Done: ${step.text}`),
      el("p", { class: "quiet" }, `${step.counts}. The model is ${step.name} now; Undo takes it back.`),
      changes.element,
    );
  }

  async #apply(model: OpenModel, { remedy }: Finding): Promise<void> {
    if (!remedy || this.session.keeping.value) return;
    const failure = await apply(this.session, model.id, remedy.text, remedy.request);
    this.#say(failure);
    // The button is gone; what it did is where to read on.
    if (!failure) this.#applied.querySelector<HTMLElement>("h3")?.focus();
  }

  #say = (failure: Failure | undefined): void => {
    if (failure) this.#failure?.show(failure);
  };

  /** A button that is made again, or has nothing more to do, does not lose the reader's place. */
  #keepFocus(id: string, act: () => void): void {
    act();
    const made = byId(id) as HTMLButtonElement;
    (made.disabled ? this.#title : made).focus();
  }
}
