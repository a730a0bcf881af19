// Opens files and folders that are dropped on the window.

import { toFailure } from "../engine/failure";
import { type DroppedItem, filesInFolder } from "./folder";
import type { GivenFile } from "./read";

/** Calls `open` with the dropped files, or `refuse` with the reason if they cannot be read. The page looks different during the drag. */
export function acceptDrops(open: (itemFiles: GivenFile[]) => void, refuse: (why: string) => void): void {
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
    droppedFiles(event.dataTransfer).then(open, (error) => refuse(toFailure(error).message));
  });
}

/** The dropped files. The browser only allows access to the items until the event is over, so that this is called at once. */
function droppedFiles(transfer: DataTransfer | null): Promise<GivenFile[]> {
  const items = [...(transfer?.items ?? [])].filter(({ kind }) => kind === "file");
  return Promise.all(items.map(itemFiles)).then((all) => all.flat());
}

/** The files of an item. A single file is read directly: if the page is opened from a folder, Chromium cannot read it by its entry. */
function itemFiles(item: DataTransferItem & DroppedItem): Promise<GivenFile[]> {
  const entry = item.webkitGetAsEntry();
  if (entry?.isDirectory) return filesInFolder(item, entry as FileSystemDirectoryEntry);
  const file = item.getAsFile();
  return Promise.resolve(file ? [{ name: file.name, file }] : []);
}
