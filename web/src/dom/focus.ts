// Keeps the focus in a box whose elements are created again.

const CONTROLS = "button:not(:disabled), input, select, summary, a[href], [tabindex='0']";

/** Calls `change`, then focuses the control with the same name, or the one at the same position, or `otherwise`. */
export function keepingFocus(box: HTMLElement, otherwise: () => HTMLElement, change: () => void): void {
  const before = controls(box);
  const index = before.findIndex((control) => control === document.activeElement);
  const focused = before[index];
  const name = focused && controlName(focused);
  change();
  if (index < 0 || box.contains(document.activeElement)) return;
  const after = controls(box);
  const next = after.find((control) => controlName(control) === name) ?? after[Math.min(index, after.length - 1)];
  next?.focus();
  const caret = focused instanceof HTMLInputElement ? focused.selectionStart : null;
  if (caret !== null && next instanceof HTMLInputElement && next.type === "text") next.setSelectionRange(caret, caret);
  if (!next || document.activeElement !== next) otherwise().focus();
}

function controls(box: HTMLElement): HTMLElement[] {
  return [...box.querySelectorAll<HTMLElement>(CONTROLS)];
}

function controlName(control: HTMLElement): string {
  return control.getAttribute("aria-label") ?? control.textContent ?? "";
}
