// The open model: its facts, the form for a change, its findings, and its steps.

import { close } from "../actions/close";
import { apply, goTo } from "../actions/apply";
import { inspect } from "../actions/inspect";
import { button, byId, el, setText } from "../dom/element";
import type { Failure, Finding, Inspected } from "../engine/types";
import { QUESTIONS } from "../forms/all";
import type { Context } from "../forms/context";
import { currentFile, type OpenModel, currentStep } from "../state/model";
import type { Session } from "../state/session";
import { changeView } from "./change";
import { type ComparedView, comparedView } from "./compared";
import { formContext } from "./context";
import { type FailureView, failureView } from "./failure";
import { questionView } from "./question";
import { type SectionPlace, place } from "./sections";
import { stepList } from "./steps";
import { summary } from "./summary";
import { openVerdicts, verdictList } from "./verdicts";

const PREFIX = "model";
const FOLDED = ["contacts", "figures", "plots", "state", "model"];

export class ModelView {
  readonly #section = byId("model");
  readonly #details = byId("details");
  readonly #title = el("h2", { id: "model-title", tabindex: -1 });
  readonly #close = el("div", { class: "buttons" });
  readonly #question = el("div", { class: "question-box" });
  readonly #summary = el("div", { class: "summary-box" });
  readonly #history = el("div", { class: "history" });
  readonly #verdicts = el("div", { class: "findings-box" });
  readonly #applied = el("section", { class: "applied", id: "applied", "aria-labelledby": "applied-title", hidden: true });
  readonly #change: HTMLElement;
  readonly #feet: SectionPlace;
  readonly #folded: SectionPlace[] = FOLDED.map((id) => place({ prefix: PREFIX, id, folded: true }));
  readonly #compared: ComparedView;
  #failure: FailureView | undefined;
  #failureBox = el("div");
  #shownModel: OpenModel | undefined;
  #isOnlyModel = false;
  #openModels = "";

  /** `stage`: the body is shown in three dimensions, so that the drawings of the feet are folded. */
  constructor(readonly session: Session, readonly addFile: Context["addFile"], stage: boolean) {
    this.#feet = place({ prefix: PREFIX, id: "feet", folded: stage });
    this.#change = changeView(session, addFile);
    this.#compared = comparedView(session, addFile);
    const verdicts = el("div", { class: "section" }, el("h3", { id: "findings-title" }, "Is it right?"), this.#verdicts);
    const facts = el("details", { class: "section", open: true }, el("summary", {}, el("h3", {}, "What is in it")), this.#summary);
    const head = el("div", { class: "head" }, this.#title, this.#close);
    this.#section.append(head, this.#history, this.#failureBox, this.#question, this.#change, this.#applied, verdicts, facts, this.#compared.element);
    this.#details.append(
      el("h2", { id: "details-title" }, "The model in detail"), this.#feet.element, ...this.#folded.map(({ element }) => element));
    session.models.watch(() => this.#update());
    session.files.watch(() => this.#failure?.refresh());
    session.chosen.watch(() => this.#update());
    session.failed.watch((failure) => {
      if (failure) this.#failure?.show(failure);
    });
  }

  #update(): void {
    const model = this.session.model();
    this.#section.hidden = !model;
    this.#details.hidden = !model?.inspected;
    this.#change.hidden = !model?.inspected;
    if (!model) return;
    this.#showClose(model);
    this.#showQuestion(model);
    if (model === this.#shownModel) return;
    // Parts that stay are not created again, because they may have the focus.
    const before = model.id === this.#shownModel?.id ? this.#shownModel : undefined;
    this.#shownModel = model;
    if (!before) this.#takeAnswers(model);
    setText(this.#title, currentFile(model));
    const stepsChanged = before?.steps !== model.steps || before.stepCount !== model.stepCount;
    if (stepsChanged) this.#showHistory(model);
    if (before?.failure !== model.failure) this.#failure?.show(model.failure ?? undefined);
    this.#section.classList.toggle("broken", model.inspected === null);
    if (model.inspected) this.#showInspected(model, model.inspected, before?.inspected ?? null);
    if (stepsChanged) this.#showApplied(model);
  }

  #showHistory(model: OpenModel): void {
    const go = (at: number) => {
      void goTo(this.session, model.id, at);
      this.#title.focus();
    };
    this.#history.replaceChildren(...stepList(model, go));
  }

  /** Shows questions about the model; after an answer, the model is inspected again. */
  #takeAnswers(model: OpenModel): void {
    const context = formContext(this.session, model.answers, { prefix: `answer-${model.id}`, commit: "change", addFile: this.addFile });
    this.#failure = failureView(() => QUESTIONS, context, this.#title);
    this.#failureBox.replaceChildren(this.#failure.element);
    this.#compared.setModel(model);
    model.answers.watch(() => void inspect(this.session, model.id));
  }

  /** The button that closes a single model; several models have it in their rows. */
  #showClose(model: OpenModel): void {
    const isOnlyModel = this.session.models.value.length === 1;
    if (isOnlyModel === this.#isOnlyModel && model.id === this.#shownModel?.id && currentFile(model) === currentFile(this.#shownModel)) return;
    this.#isOnlyModel = isOnlyModel;
    const act = () => {
      close(this.session, model);
      byId("choose-files").focus();
    };
    this.#close.replaceChildren(...(isOnlyModel ? [button("Close", act, { class: "small", "aria-label": `Close ${currentFile(model)}` })] : []));
  }

  /** The sentence about the model, and the likely changes, which depend on the other open models. */
  #showQuestion(model: OpenModel): void {
    const openModels = this.session.models.value.map((one) => `${currentFile(one)} ${one.inspected !== null}`).join("\n");
    const shown = this.#shownModel;
    const isSame = model.id === shown?.id && model.inspected?.inspection === shown.inspected?.inspection && model.originals === shown.originals;
    if (openModels === this.#openModels && isSame) return;
    this.#openModels = openModels;
    this.#question.replaceChildren(...(model.inspected ? questionView(this.session, model, model.inspected.inspection) : []));
  }

  #showInspected(model: OpenModel, inspected: Inspected, before: Inspected | null): void {
    if (inspected.inspection !== before?.inspection) this.#summary.replaceChildren(summary(inspected));
    const act = (finding: Finding) => void this.#apply(model, finding);
    if (inspected.findings !== before?.findings) {
      const open = before ? openVerdicts(this.#verdicts) : new Set<string>();
      this.#verdicts.replaceChildren(verdictList(inspected.verdicts, inspected.findings, act, open));
    }
    const sections = new Map(inspected.sections.map((section) => [section.id, section]));
    this.#feet.show(sections.get("feet"));
    for (const [index, id] of FOLDED.entries()) this.#folded[index]?.show(sections.get(id));
  }

  #showApplied(model: OpenModel): void {
    const step = currentStep(model);
    this.#applied.hidden = !step;
    if (!step) return;
    const changes = place({ prefix: "applied", id: "changes", title: "What it changed", folded: true });
    changes.show(step.sections.find(({ id }) => id === "changes"));
    this.#applied.replaceChildren(
      el("h3", { id: "applied-title", tabindex: -1 }, `Done: ${step.text}`),
      el("p", { class: "quiet" }, `${step.counts}. The model is ${step.name} now; Undo takes it back.`),
      changes.element,
    );
  }

  async #apply(model: OpenModel, { remedy }: Finding): Promise<void> {
    if (!remedy || this.session.keeping.value) return;
    const failure: Failure | undefined = await apply(this.session, model.id, remedy.text, remedy.request);
    if (failure) this.#failure?.show(failure);
    // The button does not exist any more; its effect gets the focus.
    else this.#applied.querySelector<HTMLElement>("h3")?.focus();
  }
}
