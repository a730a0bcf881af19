// Lists the files in a folder that was dropped.

import type { GivenFile } from "./read";

/** An item with a function of newer browsers: it can read a folder even if the page is opened from a folder. */
export interface DroppedItem {
  getAsFileSystemHandle?(): Promise<FileSystemHandle | null>;
}

/** All files in a folder and its subfolders, with their paths. */
export async function filesInFolder(item: DroppedItem, entry: FileSystemDirectoryEntry): Promise<GivenFile[]> {
  const handle = await item.getAsFileSystemHandle?.();
  return isFolder(handle) ? filesOfHandle(handle, `${handle.name}/`) : filesOfEntry(entry);
}

function isFolder(handle: FileSystemHandle | null | undefined): handle is FileSystemDirectoryHandle {
  return handle?.kind === "directory";
}

async function filesOfHandle(folder: FileSystemDirectoryHandle, path: string): Promise<GivenFile[]> {
  const files: Promise<GivenFile[]>[] = [];
  for await (const handle of folder.values()) {
    files.push(isFolder(handle) ? filesOfHandle(handle, `${path}${handle.name}/`) : fileOfHandle(handle as FileSystemFileHandle, path));
  }
  return (await Promise.all(files)).flat();
}

async function fileOfHandle(handle: FileSystemFileHandle, path: string): Promise<GivenFile[]> {
  return [{ name: path + handle.name, file: await handle.getFile() }];
}

async function filesOfEntry(entry: FileSystemEntry): Promise<GivenFile[]> {
  if (entry.isFile) {
    const file = await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject));
    return [{ name: entry.fullPath.replace(/^\//, ""), file }];
  }
  return (await Promise.all((await allEntries((entry as FileSystemDirectoryEntry).createReader())).map(filesOfEntry))).flat();
}

/** All entries of a folder; a reader returns them in portions. */
async function allEntries(reader: FileSystemDirectoryReader): Promise<FileSystemEntry[]> {
  const portion = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject));
  return portion.length === 0 ? [] : [...portion, ...(await allEntries(reader))];
}
