// Files and folders that are dropped on the window.

import { failureOf } from "../engine/failure";
import { type Dropped, inFolder } from "./folder";
import type { Given } from "./read";

/** Calls `open` with what is dropped, or `refuse` with why it cannot be read; the document shows that something is held over it. */
export function acceptDrops(open: (given: Given[]) => void, refuse: (why: string) => void): void {
  let depth = 0;
  const show = (change: number) => {
    depth = Math.max(0, depth + change);
    document.documentElement.classList.toggle("dropping", depth > 0);
  };
  const holdsFiles = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;
  addEventListener("dragenter", (event) => holdsFiles(event) && show(1));
  addEventListener("dragleave", (event) => holdsFiles(event) && show(-1));
  addEventListener("dragover", (event) => holdsFiles(event) && event.preventDefault());
  addEventListener("drop", (event) => {
    if (!holdsFiles(event)) return;
    event.preventDefault();
    show(-depth);
    dropped(event.dataTransfer).then(open, (error) => refuse(failureOf(error).message));
  });
}

/** What was dropped can only be asked for until the event is over; what is made of it, later too. */
function dropped(transfer: DataTransfer | null): Promise<Given[]> {
  const items = [...(transfer?.items ?? [])].filter(({ kind }) => kind === "file");
  return Promise.all(items.map(given)).then((all) => all.flat());
}

/** A file as it is: on a page that was opened from a folder, Chromium gives no file that is asked for by its entry. */
function given(item: DataTransferItem & Dropped): Promise<Given[]> {
  const entry = item.webkitGetAsEntry();
  if (entry?.isDirectory) return inFolder(item, entry as FileSystemDirectoryEntry);
  const file = item.getAsFile();
  return Promise.resolve(file ? [{ name: file.name, file }] : []);
}
