// Fields for the model that the open one was scaled from: findings then compare the two.

import { el } from "../dom/element";
import { QUESTIONS } from "../forms/all";
import type { Context } from "../forms/context";
import { control } from "../forms/control";
import type { OpenModel } from "../state/model";
import type { Session } from "../state/session";
import { formContext } from "./context";

const FIELDS = ["from", "body_scale_file"];

export interface ComparedView {
  element: HTMLElement;
  /** Shows the fields of another model. */
  setModel(model: OpenModel): void;
}

export function comparedView(session: Session, addFile: Context["addFile"]): ComparedView {
  const body = el("div");
  const element = el("details", { class: "section compared" },
    el("summary", {}, el("h3", {}, "Was this model scaled from another one?")),
    el("p", { class: "quiet" }, "Say from which: the findings then show spheres that the scaling left behind, and what to do about them."), body);
  let refresh: (choices: boolean) => void = () => undefined;
  let end: () => void = () => undefined;
  const setModel = (model: OpenModel) => {
    end();
    const context = formContext(session, model.answers, { prefix: `compared-${model.id}`, commit: "change", addFile });
    const controls = QUESTIONS.fields.filter(({ name }) => FIELDS.includes(name)).map((field) => control(field, context));
    refresh = (choices) => {
      for (const each of controls) each.refresh(choices);
    };
    end = model.answers.watch(() => refresh(false));
    body.replaceChildren(...controls.map((each) => each.element));
    refresh(true);
  };
  session.files.watch(() => refresh(true));
  return { element, setModel };
}
