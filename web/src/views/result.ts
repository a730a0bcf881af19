// The third step: the result of the change in the form with its own verdicts; and beside it what would change.

import { changeText } from "../actions/apply";
import { byId, el, setText } from "../dom/element";
import { CALCULATOR, findForm } from "../forms/all";
import type { Context } from "../forms/context";
import type { Preview, Session } from "../state/session";
import { formContext } from "./context";
import { diffView } from "./diff";
import { failureView } from "./failure";
import { type SectionPlace, placeSection } from "./sections";
import { openRows, verdictRows } from "./verdicts";

const SECTIONS = ["changes", "reference", "plots", "state", "feet", "findings", "figures"];
const PREFIX = "result";
// The title of the report would say that the change was made.
const TITLES: Readonly<Record<string, { title: string }>> = { changes: { title: "In detail" } };

export class ResultView {
  readonly #section = byId("result");
  readonly #status = el("p", { class: "status", id: "result-status", tabindex: -1 });
  readonly #outcome = byId("outcome");
  readonly #verdicts = el("div", { class: "verdicts" });
  readonly #places = new Map<string, SectionPlace>(SECTIONS.map((id) => [id, placeSection({ prefix: PREFIX, id, ...TITLES[id] })]));
  readonly #doneBox = el("div", { class: "done", hidden: true });
  readonly #live = el("p", { class: "hidden", role: "status", "aria-live": "polite" });
  readonly #failure;
  readonly #diff;
  #updates = 0;
  #announceTimer: ReturnType<typeof setTimeout> | undefined;

  constructor(readonly session: Session, addFile: Context["addFile"]) {
    const context = formContext(session, session.values, { prefix: "question", commit: "change", addFile });
    this.#failure = failureView(() => findForm(session.verb.value) ?? CALCULATOR, context, this.#status);
    this.#diff = diffView(session);
    this.#doneBox.append(...[...this.#places.values()].map(({ element }) => element), this.#diff.element);
    const head = el("div", { class: "head" }, el("span", { class: "step", "aria-hidden": "true" }, "3"), el("h2", { id: "outcome-title" }, "The result"));
    this.#outcome.append(head, this.#status, this.#failure.element, this.#verdicts, this.#live);
    this.#section.append(el("h2", { id: "result-title" }, "What would change"), this.#doneBox);
    session.files.watch(() => this.#failure.refresh());
    this.#watchPlots();
    session.preview.watch((preview) => this.#show(preview));
    const update = () => (this.#outcome.hidden = !session.model()?.inspected);
    session.models.watch(update);
    session.chosen.watch(update);
  }

  #show(preview: Preview): void {
    const done = preview.state === "done";
    this.#section.dataset["state"] = preview.state;
    // Styles show that sections are outdated, if the update takes a moment.
    this.#section.dataset["complete"] = String(done && preview.complete);
    // Sections of another model or verb are removed.
    if (preview.state === "none") for (const { show } of this.#places.values()) show(undefined);
    setText(this.#status, statusText(preview));
    this.#failure.show(preview.state === "failed" ? preview.failure : undefined);
    this.#doneBox.hidden = this.#section.hidden = !done;
    this.#verdicts.hidden = !done || preview.change.unchanged;
    if (done) this.#showDone(preview);
    this.#updates += 1;
    this.#section.dataset["update"] = String(this.#updates);
    this.#announce(preview);
  }

  #showDone(preview: Extract<Preview, { state: "done" }>): void {
    const sections = new Map(preview.sections.map((section) => [section.id, section]));
    for (const [id, { show }] of this.#places) {
      // An outdated section stays until the new one comes.
      if (sections.has(id) || preview.complete) show(sections.get(id));
    }
    const { verdicts, findings } = preview.change;
    if (verdicts && findings) this.#verdicts.replaceChildren(...verdictRows(verdicts, findings, openRows(this.#verdicts)));
    this.#outcome.dataset["complete"] = String(preview.complete);
    this.#diff.ask(preview.request);
  }

  /** Announces the outcome to screen readers after the preview has not changed for a moment. */
  #announce(preview: Preview): void {
    clearTimeout(this.#announceTimer);
    this.#announceTimer = setTimeout(() => setText(this.#live, preview.state === "none" ? "" : statusText(preview)), 600);
  }

  /** Records which sections are on the screen: these are updated with every step of a slider. */
  #watchPlots(): void {
    const observer = new IntersectionObserver((entries) => {
      for (const { target, isIntersecting } of entries) {
        if (isIntersecting) this.session.visible.add(target.id.replace(`${PREFIX}-`, ""));
        else this.session.visible.delete(target.id.replace(`${PREFIX}-`, ""));
      }
    });
    for (const { element } of this.#places.values()) observer.observe(element);
  }
}

function statusText(preview: Preview): string {
  switch (preview.state) {
    case "none": return "";
    case "hint": return preview.text;
    case "failed": return "This cannot be done yet.";
    case "done": return changeText(preview.change);
  }
}
