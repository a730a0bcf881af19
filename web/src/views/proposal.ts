// The second step: the model's original, if it was scaled, and one button for the change that `check` proposes.

import { button, byId, el, setText } from "../dom/element";
import type { Request } from "../engine/types";
import { findForm, QUESTIONS } from "../forms/all";
import type { Context } from "../forms/context";
import { control } from "../forms/control";
import { describeRequest, valuesOf } from "../forms/describe";
import { isBare, lacksContacts, type OpenModel, proposedRequest } from "../state/model";
import type { Session } from "../state/session";
import { formContext } from "./context";
import { wayPicture } from "./ways";

const WAYS: readonly [title: string, about: string, field: string][] = [
  ["From a reference", "spheres of another model or a preset", "from"],
  ["Under its own bones", "spheres below the meshes of the feet", "feet"],
  ["From a table", "places of your own", "contacts"],
];

const NOTHING_WRONG = "Nothing has to be corrected. For another mass or other numbers, use “Change this model”.";

export class ProposalView {
  readonly #section = byId("proposal");
  readonly #title = el("h2", { id: "proposal-title" });
  readonly #original = el("div", { class: "original" });
  readonly #offers = el("div", { class: "offers", role: "group", "aria-label": "Most likely" });
  readonly #note = el("p", { class: "quiet" });
  #model: OpenModel | undefined;
  /** The verb of the first button. */
  #verb = "";
  /** Whether the next result is that of the button, which may be below what is seen. */
  #showsResult = false;
  #refreshFields: (choices: boolean) => void = () => undefined;
  #end: () => void = () => undefined;

  constructor(readonly session: Session, readonly addFile: Context["addFile"]) {
    const head = el("div", { class: "head" }, el("span", { class: "step", "aria-hidden": "true" }, "2"), this.#title);
    this.#section.append(head, this.#original, this.#offers, this.#note);
    session.models.watch(() => this.#update());
    session.chosen.watch(() => this.#update());
    session.files.watch(() => this.#refreshFields(true));
    session.preview.watch((preview) => {
      // After its result, the next button to press is that of the download.
      const isDone = preview.state === "done" && preview.request.verb === this.#verb;
      this.#offers.firstElementChild?.classList.toggle("primary", !isDone);
      if (!this.#showsResult || !(preview.state === "failed" || (preview.state === "done" && preview.complete))) return;
      this.#showsResult = false;
      // Beside the body, the steps scroll in their own box.
      const block = matchMedia("(min-width:62rem)").matches ? "nearest" : "start";
      requestAnimationFrame(() => byId("outcome").scrollIntoView({ block }));
    });
  }

  #update(): void {
    const model = this.session.model();
    this.#section.hidden = !model?.inspected;
    if (!model?.inspected || model === this.#model) return;
    if (model.id !== this.#model?.id) {
      this.#showsResult = false;
      this.#showFields(model);
    }
    if (model.inspected.findings !== this.#model?.inspected?.findings || model.originals !== this.#model.originals) this.#show(model);
    this.#model = model;
  }

  #show(model: OpenModel): void {
    const { inspection, findings } = model.inspected ?? { inspection: undefined, findings: [] };
    const bare = model.inspected !== null && isBare(model.inspected);
    const request = model.inspected === null ? undefined : proposedRequest(model.inspected);
    const mass = inspection?.mass_kg;
    // The scaled bones show that there is an original, and nothing else shows whether the spheres followed.
    const unsure = model.originals.length > 1 && model.answers.text("from") === "";
    const asks = !request && !unsure && findings.some(({ code }) => code === "spheres-not-compared");
    this.#original.classList.toggle("asks", asks);
    this.#original.hidden = bare;
    const lacks = model.inspected !== null && lacksContacts(model.inspected);
    setText(this.#title, lacks ? "Give it contacts" : bare ? "First correct the file" : "Scaled from another model?");
    this.#verb = request?.verb ?? "add";
    this.#offers.replaceChildren(...(lacks ? this.#ways() : request ? [this.#offer(request, mass)] : []));
    const isWrong = findings.some(({ severity }) => severity !== "remark");
    const advice = unsure ? `Several open models may be its original: choose ${model.originals.join(" or ")}.` : asks ? "Open its original to see whether the spheres followed the bones." : isWrong ? "Click a row above to see what to do." : NOTHING_WRONG;
    setText(this.#note, this.#offers.hasChildNodes() && !unsure ? "" : advice);
  }

  /** The fields that say from which model this one was scaled. */
  #showFields(model: OpenModel): void {
    this.#end();
    const context = formContext(this.session, model.answers, { prefix: `original-${model.id}`, commit: "change", addFile: this.addFile });
    const fields = ["from", "body_scale_file"].flatMap((name) => QUESTIONS.fields.find((field) => field.name === name) ?? []);
    const controls = fields.map((field) => control(field, context));
    this.#refreshFields = (choices) => {
      for (const each of controls) each.refresh(choices);
      const scales = this.session.files.value.some(({ kind }) => kind === "scales");
      if (controls[1]) controls[1].element.hidden = !scales;
    };
    this.#end = model.answers.watch(() => this.#refreshFields(false));
    this.#original.replaceChildren(...controls.map(({ element }) => element));
    this.#refreshFields(true);
  }

  #offer(request: Request, mass: number | null | undefined): HTMLElement {
    const text = describeRequest(request, findForm(request.verb), mass);
    const act = () => {
      this.#showsResult = true;
      this.session.setVerb(request.verb, valuesOf(request));
    };
    return button(text, act, { class: "primary" });
  }

  /** Buttons for three ways to add contacts to a model that has none. */
  #ways(): HTMLElement[] {
    return WAYS.map(([title, about, field], index) => {
      const act = () => {
        this.session.setVerb("add");
        focusField(field);
      };
      const offer = button("", act, { class: index === 0 ? "primary way" : "way" });
      offer.append(wayPicture(field), el("strong", {}, title), " ", el("span", {}, about));
      return offer;
    });
  }
}

/** Moves the focus to the field that the user has to fill first. */
function focusField(name: string): void {
  const field = document.getElementById(`form-${name}`);
  if (field instanceof HTMLDetailsElement) field.open = true;
  field?.scrollIntoView({ block: "center" });
  (field?.querySelector("summary") ?? field)?.focus({ preventScroll: true });
}
