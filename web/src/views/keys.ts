// Download, undo and redo by keys. In text fields the browser handles undo and redo.

import { byId } from "../dom/element";

const TEXT_INPUT = /^(text|search|number)$/;

export function wireKeys(undo: () => void, redo: () => void): void {
  addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
    // The page under an open dialog does not change.
    if (document.querySelector("dialog[open]")) return;
    const key = event.key.toLowerCase();
    const save = byId("download");
    const edit = key === "z" ? (event.shiftKey ? redo : undo) : key === "y" && !event.shiftKey ? redo : undefined;
    const act = key === "s" && save.offsetParent !== null ? () => save.click() : isTyping(event.target) ? undefined : edit;
    if (!act) return;
    event.preventDefault();
    act();
  });
}

function isTyping(target: EventTarget | null): boolean {
  if (target instanceof HTMLTextAreaElement) return true;
  return target instanceof HTMLInputElement && TEXT_INPUT.test(target.type);
}
