// A field for a rule, a number or a factor, such as the radius: the user first chooses which, then types the amount.

import { el, setAttribute } from "../dom/element";
import type { Context, Control } from "./context";
import type { Field } from "./declaration";
import { frame, inputId } from "./frame";

const NUMBER = "#number";
const FACTOR = "#factor";

export function ruleControl(field: Field, context: Context): Control {
  const id = inputId(field, context);
  const select = el("select", { name: field.name }, ...options(field));
  const amount = el("input", { type: "text", inputmode: "decimal", autocomplete: "off", id: `${id}-amount`, hidden: true });
  const { element, check } = frame(field, context, select, el("div", { class: "box" }, select, amount));
  setAttribute(amount, "aria-describedby", select.getAttribute("aria-describedby") ?? undefined);
  const value = () => {
    const kind = select.value;
    if (kind !== NUMBER && kind !== FACTOR) return kind;
    const text = amount.value.trim();
    return kind === FACTOR && text !== "" ? `x${text.replace(/^[xX×]/, "")}` : text;
  };
  const show = (kind: string) => {
    amount.hidden = kind !== NUMBER && kind !== FACTOR;
    amount.setAttribute("aria-label", kind === FACTOR ? `${field.label}: factor` : `${field.label} in metres`);
  };
  select.addEventListener("change", () => {
    show(select.value);
    context.values.set(field.name, value());
    if (!amount.hidden) amount.focus();
  });
  amount.addEventListener(context.commit, () => context.values.set(field.name, value()));
  const refresh = () => {
    const text = context.values.text(field.name);
    check();
    setAttribute(amount, "aria-invalid", select.getAttribute("aria-invalid") ?? undefined);
    if (text === value()) return;
    select.value = ruleKind(field, text);
    amount.value = select.value === FACTOR ? text.slice(1) : select.value === NUMBER ? text : "";
    show(select.value);
  };
  return { element, refresh };
}

function options({ choices = [], factor, default: defaultText }: Field): HTMLOptionElement[] {
  const words = choices.map(({ value, text }) => el("option", { value }, text));
  const factors = factor ? [el("option", { value: FACTOR }, "a factor…")] : [];
  return [
    el("option", { value: "" }, defaultText ? `default: ${defaultText}` : "default"), ...words,
    el("option", { value: NUMBER }, "a radius in metres…"), ...factors,
  ];
}

function ruleKind({ choices = [], factor }: Field, text: string): string {
  if (text === "" || choices.some(({ value }) => value === text)) return text;
  return factor && /^[xX×]/.test(text) ? FACTOR : NUMBER;
}
