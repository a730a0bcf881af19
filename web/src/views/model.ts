// The first step: the open model, what is wrong with it, and the steps that changed it. Its facts and details are beside.

import { close } from "../actions/close";
import { goTo } from "../actions/apply";
import { inspect } from "../actions/inspect";
import { button, byId, el, setText } from "../dom/element";
import type { Inspected } from "../engine/types";
import { QUESTIONS } from "../forms/all";
import type { Context } from "../forms/context";
import { currentFile, type OpenModel } from "../state/model";
import type { Session } from "../state/session";
import { formContext } from "./context";
import { type FailureView, failureView } from "./failure";
import { type SectionPlace, placeSection } from "./sections";
import { stepList } from "./steps";
import { describeModel, summary } from "./summary";
import { openRows, verdictRows } from "./verdicts";

const PREFIX = "model";
const FOLDED_SECTIONS = ["contacts", "figures", "plots", "state", "model"];

export class ModelView {
  readonly #section = byId("model");
  readonly #details = byId("details");
  readonly #title = el("h2", { id: "model-title", tabindex: -1 });
  readonly #close = el("div", { class: "buttons" });
  readonly #says = el("p", { class: "says" });
  readonly #summary = el("div", { class: "summary-box" });
  readonly #history = el("div", { class: "history" });
  readonly #verdicts = el("div", { class: "verdicts" });
  readonly #feet: SectionPlace;
  readonly #folded: SectionPlace[] = FOLDED_SECTIONS.map((id) => placeSection({ prefix: PREFIX, id, folded: true }));
  #failure: FailureView | undefined;
  #failureBox = el("div");
  #shownModel: OpenModel | undefined;
  #end: () => void = () => undefined;
  #isOnlyModel = false;

  /** `stage`: the body is shown in three dimensions, so that the drawings of the feet are folded. */
  constructor(readonly session: Session, readonly addFile: Context["addFile"], stage: boolean) {
    this.#feet = placeSection({ prefix: PREFIX, id: "feet", folded: stage });
    const head = el("div", { class: "head" }, el("span", { class: "step", "aria-hidden": "true" }, "1"), this.#title, this.#close);
    this.#section.append(head, this.#history, this.#failureBox, this.#says, this.#verdicts);
    this.#details.append(
      el("h2", { id: "details-title" }, "The model in detail"), this.#summary, this.#feet.element, ...this.#folded.map(({ element }) => element));
    session.models.watch(() => this.#update());
    session.files.watch(() => this.#failure?.refresh());
    session.chosen.watch(() => this.#update());
    session.failed.watch((failure) => this.#failure?.show(failure ?? this.#shownModel?.failure ?? undefined));
  }

  #update(): void {
    const model = this.session.model();
    this.#section.hidden = !model;
    this.#details.hidden = !model?.inspected;
    if (!model) return;
    this.#showClose(model);
    if (model === this.#shownModel) return;
    // Parts that stay are not created again, because they may have the focus.
    const before = model.id === this.#shownModel?.id ? this.#shownModel : undefined;
    this.#shownModel = model;
    if (!before) this.#takeAnswers(model);
    setText(this.#title, currentFile(model));
    if (before?.steps !== model.steps || before.stepCount !== model.stepCount) this.#showHistory(model);
    if (before?.failure !== model.failure || before.inspected !== model.inspected) this.#failure?.show(model.failure ?? undefined);
    this.#section.classList.toggle("broken", model.inspected === null);
    if (model.inspected) this.#showInspected(model.inspected, before?.inspected ?? null);
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
    this.#end();
    this.#end = model.answers.watch(() => void inspect(this.session, model.id));
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

  #showInspected(inspected: Inspected, before: Inspected | null): void {
    if (inspected.inspection !== before?.inspection) {
      setText(this.#says, describeModel(inspected.inspection));
      this.#summary.replaceChildren(summary(inspected));
    }
    if (inspected.findings !== before?.findings) {
      const open = before ? openRows(this.#verdicts) : new Set<string>();
      this.#verdicts.replaceChildren(...verdictRows(inspected.verdicts, inspected.findings, open));
    }
    const sections = new Map(inspected.sections.map((section) => [section.id, section]));
    this.#feet.show(sections.get("feet"));
    for (const [index, id] of FOLDED_SECTIONS.entries()) this.#folded[index]?.show(sections.get(id));
  }
}
