// The part of the page for a change: a verb and its form.

import { button, byId, el } from "../dom/element";
import { CHANGES, findForm } from "../forms/all";
import type { Context } from "../forms/context";
import { showForm, type FormView } from "../forms/form";
import type { Session } from "../state/session";
import { formContext } from "./context";

export function changeView(session: Session, addFile: Context["addFile"]): void {
  const section = byId("change");
  const about = el("p", { class: "quiet about", id: "verb-about" });
  const place = el("div", { id: "form" });
  const clear = button("Clear the form", () => session.values.clear(), { class: "small", id: "clear" });
  section.append(el("h2", { id: "change-title" }, "Change this model"), verbButtons(session), about, place, el("p", { class: "clear" }, clear));
  const context = formContext(session, session.values, { prefix: "form", commit: "input", addFile });
  let formView: FormView | undefined;
  session.verb.watch((verb) => {
    const form = findForm(verb);
    if (!form) return;
    formView?.end();
    formView = showForm(form, context);
    about.textContent = form.about;
    place.replaceChildren(formView.element);
  });
  const updateClear = () => (clear.hidden = session.values.all().size === 0);
  session.values.watch(updateClear);
  updateClear();
  const refresh = () => formView?.refresh();
  session.chosen.watch(refresh);
  session.models.watch(refresh);
  session.files.watch(refresh);
  session.presets.watch(refresh);
  const update = () => (section.hidden = !session.model()?.inspected);
  session.models.watch(update);
  session.chosen.watch(update);
}

/** Radio buttons for the verbs. */
function verbButtons(session: Session): HTMLElement {
  const radios = CHANGES.map(({ verb, title, about }) => {
    const input = el("input", { type: "radio", name: "verb", value: verb, title: about });
    input.addEventListener("change", () => session.setVerb(verb));
    return { input, element: el("label", { class: "verb" }, input, el("span", {}, title)) };
  });
  session.verb.watch((verb) => {
    for (const { input } of radios) input.checked = input.value === verb;
  });
  return el("fieldset", { class: "verbs" }, el("legend", { class: "hidden" }, "What to do"), ...radios.map(({ element }) => element));
}
