// Shows a failure: message, place, the line of the file, and the fields that would answer a question.

import { button, type Child, el } from "../dom/element";
import { digits } from "../dom/number";
import type { Failure } from "../engine/types";
import { findField } from "../forms/all";
import type { Context } from "../forms/context";
import { control } from "../forms/control";
import type { Field, Form } from "../forms/declaration";

export interface FailureView {
  element: HTMLElement;
  show(failure: Failure | undefined): void;
  /** Call this when other files are open: the fields may have other options. */
  refresh(): void;
}

/**
 * A place for failures. Their questions are fields of `form`, and `context` stores the answers; after an answer, `after` gets the
 * focus.
 */
export function failureView(form: () => Form, context: Context, after: HTMLElement): FailureView {
  const messageBox = el("div", { class: "what" });
  const answers = el("div", { class: "answers" });
  const element = el("div", { class: "failure", hidden: true }, messageBox, answers);
  let askedKey = "";
  let shownText = "";
  let end: () => void = () => undefined;
  let refresh: () => void = () => undefined;
  const show = (failure: Failure | undefined) => {
    if (!failure) {
      if (element.contains(document.activeElement)) after.focus();
      element.hidden = true;
      askedKey = shownText = "";
      end();
      messageBox.replaceChildren();
      answers.replaceChildren();
      return;
    }
    element.hidden = false;
    const text = JSON.stringify([failure.message, failure.model, failure.line, failure.column, failure.excerpt]);
    // A screen reader would repeat an alert that is created again.
    if (shownText !== text) messageBox.replaceChildren(el("div", { role: "alert" }, ...failureElements(failure)));
    shownText = text;
    const key = `${form().verb} ${failure.code} ${failure.fields.join(" ")}`;
    // The fields of an equal question stay, because the user may be typing in them.
    if (askedKey === key) return;
    askedKey = key;
    end();
    const parts = questionOfFailure(failure, form(), context);
    answers.replaceChildren(...parts.content);
    end = parts.end;
    refresh = parts.refresh;
  };
  return { element, show, refresh: () => refresh() };
}

/** The message, place and excerpt of a failure as elements. */
export function failureElements({ message, model, line, column, excerpt }: Failure): HTMLElement[] {
  const where = model ? [model, line, column].filter((part) => part != null).join(":") : "";
  const parts: HTMLElement[] = [el("p", { class: "message" }, el("span", { class: "tag error" }, "error"), " ", sentence(message))];
  if (where) parts.push(el("p", { class: "quiet" }, "In ", el("code", {}, where)));
  if (excerpt) {
    const { before, marked, after } = excerpt;
    const text: Child[] = [before, el("mark", {}, marked || " "), after];
    parts.push(el("pre", { class: "excerpt", tabindex: 0, "aria-label": "The line of the file" }, el("code", {}, ...text)));
  }
  return parts;
}

/** A message with a full stop. Its first letter does not change, because it may begin with a name. */
export function sentence(text: string): string {
  return /[.!?]$/.test(text) ? text : `${text}.`;
}

interface Question {
  content: HTMLElement[];
  refresh(): void;
  end(): void;
}

function questionOfFailure(failure: Failure, form: Form, context: Context): Question {
  const fields = failure.fields.filter((name) => name !== "yes").flatMap((name) => findField(name, form) ?? []);
  const controls = fields.map((field) => ({ field, fieldControl: control(field, context) }));
  const refresh = () => {
    for (const { fieldControl } of controls) fieldControl.refresh(true);
  };
  refresh();
  const end = context.values.watch((name) => {
    for (const { field, fieldControl } of controls) if (name === null || field.name === name) fieldControl.refresh(name === null);
  });
  const yes = failure.fields.includes("yes") ? [confirmButton(failure, context)] : [];
  const all = [...suggestionButtons(failure, fields[0], context), ...yes, ...controls.map(({ fieldControl }) => fieldControl.element)];
  if (all.length === 0) return { content: [], refresh, end };
  const legend = all.length === 1 ? "Your answer" : "Any one of these answers is enough";
  const title = el("p", { id: `${context.prefix}-asked` }, el("strong", {}, legend));
  return { content: [el("div", { class: "question", role: "group", "aria-labelledby": title.id }, title, ...all)], refresh, end };
}

/** A button for each number that the message proposes. */
function suggestionButtons({ message }: Failure, field: Field | undefined, { values }: Context): HTMLElement[] {
  if (!field || !["number", "rule"].includes(field.kind)) return [];
  const numbers = [...message.matchAll(/\bwrite ([\d.]+(?:e[+-]?\d+)?)/g)].flatMap(([, text]) => text ?? []);
  return numbers.map((text) => el("p", {}, button(`Use ${digits(Number(text))}${field.unit ? ` ${field.unit}` : ""}`, () => values.set(field.name, text))));
}

/** A button that confirms an unusual number. The confirmation ends when the number changes. */
function confirmButton({ code, fields }: Failure, { values }: Context): HTMLElement {
  const others = () => values.texts("yes").filter((one) => one !== code);
  const say = () => {
    values.set("yes", [...others(), code]);
    const end = values.watch((name) => {
      if (name === "yes" || (name !== null && !fields.includes(name))) return;
      end();
      if (name !== null) values.set("yes", others());
    });
  };
  return el("p", {}, button("This is correct: continue", say));
}
