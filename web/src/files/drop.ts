// Files and folders that are dropped on the window.

import type { Given } from "./read";

/** Calls `open` with what is dropped; the document shows that something is held over it. */
export function acceptDrops(open: (given: Given[]) => void): void {
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
    void dropped(event.dataTransfer).then(open);
  });
}

async function dropped(transfer: DataTransfer | null): Promise<Given[]> {
  // What was dropped can only be looked at until the event is over; what is made of it, later too.
  const entries = [...(transfer?.items ?? [])].map((item) => item.webkitGetAsEntry()).filter((entry) => entry !== null);
  if (entries.length > 0) return (await Promise.all(entries.map(within))).flat();
  return [...(transfer?.files ?? [])].map((file) => ({ name: file.name, file }));
}

/** The files in a folder, or the file. */
async function within(entry: FileSystemEntry): Promise<Given[]> {
  if (isFile(entry)) {
    const file = await new Promise<File>((resolve, reject) => entry.file(resolve, reject));
    return [{ name: entry.fullPath.replace(/^\//, ""), file }];
  }
  if (!isFolder(entry)) return [];
  return (await Promise.all((await all(entry.createReader())).map(within))).flat();
}

/** All entries of a folder: a reader gives them in portions. */
async function all(reader: FileSystemDirectoryReader): Promise<FileSystemEntry[]> {
  const portion = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject));
  return portion.length === 0 ? [] : [...portion, ...(await all(reader))];
}

function isFile(entry: FileSystemEntry): entry is FileSystemFileEntry {
  return entry.isFile;
}

function isFolder(entry: FileSystemEntry): entry is FileSystemDirectoryEntry {
  return entry.isDirectory;
}
