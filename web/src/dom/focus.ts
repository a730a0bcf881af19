// A reader's place in a box whose elements are made again.

const CONTROLS = "button:not(:disabled), input, select, summary, a[href], [tabindex='0']";

/** Calls `change`, after which the focus is at the same control as before, at the one in its place, or at `otherwise`. */
export function keepingFocus(box: HTMLElement, otherwise: () => HTMLElement, change: () => void): void {
  const before = controls(box);
  const at = before.findIndex((control) => control === document.activeElement);
  const was = before[at];
  const name = was && nameOf(was);
  change();
  if (at < 0 || box.contains(document.activeElement)) return;
  const now = controls(box);
  const next = now.find((control) => nameOf(control) === name) ?? now[Math.min(at, now.length - 1)];
  next?.focus();
  const caret = was instanceof HTMLInputElement ? was.selectionStart : null;
  if (caret !== null && next instanceof HTMLInputElement && next.type === "text") next.setSelectionRange(caret, caret);
  if (!next || document.activeElement !== next) otherwise().focus();
}

function controls(box: HTMLElement): HTMLElement[] {
  return [...box.querySelectorAll<HTMLElement>(CONTROLS)];
}

function nameOf(control: HTMLElement): string {
  return control.getAttribute("aria-label") ?? control.textContent ?? "";
}
