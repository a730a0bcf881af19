// Shows that the engine is working, if that takes longer than a moment.

import { byId, setAttribute } from "../dom/element";
import type { Client } from "../engine/client";

const SHOWN_AFTER_MS = 150;

export function showBusy(engine: Client): void {
  const working = byId("working");
  const content = byId("content");
  let timer: ReturnType<typeof setTimeout> | undefined;
  engine.onBusy((count) => {
    if (count > 0) {
      timer ??= setTimeout(() => show(true), SHOWN_AFTER_MS);
      return;
    }
    clearTimeout(timer);
    timer = undefined;
    show(false);
  });
  const show = (busy: boolean) => {
    working.hidden = !busy;
    setAttribute(content, "aria-busy", busy && "true");
  };
}
