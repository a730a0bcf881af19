// The files in a folder that was dropped.

import type { Given } from "./read";

/** What newer browsers have: a folder that can be read on a page from a folder, too. */
export interface Dropped {
  getAsFileSystemHandle?(): Promise<FileSystemHandle | null>;
}

/** All files in it and in the folders within, with their paths. */
export async function inFolder(item: Dropped, entry: FileSystemDirectoryEntry): Promise<Given[]> {
  const handle = await item.getAsFileSystemHandle?.();
  return isFolder(handle) ? ofHandle(handle, `${handle.name}/`) : ofEntry(entry);
}

function isFolder(handle: FileSystemHandle | null | undefined): handle is FileSystemDirectoryHandle {
  return handle?.kind === "directory";
}

async function ofHandle(folder: FileSystemDirectoryHandle, path: string): Promise<Given[]> {
  const found: Promise<Given[]>[] = [];
  for await (const handle of folder.values()) {
    found.push(isFolder(handle) ? ofHandle(handle, `${path}${handle.name}/`) : ofFile(handle as FileSystemFileHandle, path));
  }
  return (await Promise.all(found)).flat();
}

async function ofFile(handle: FileSystemFileHandle, path: string): Promise<Given[]> {
  return [{ name: path + handle.name, file: await handle.getFile() }];
}

async function ofEntry(entry: FileSystemEntry): Promise<Given[]> {
  if (entry.isFile) {
    const file = await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject));
    return [{ name: entry.fullPath.replace(/^\//, ""), file }];
  }
  return (await Promise.all((await all((entry as FileSystemDirectoryEntry).createReader())).map(ofEntry))).flat();
}

/** All entries of a folder: a reader gives them in portions. */
async function all(reader: FileSystemDirectoryReader): Promise<FileSystemEntry[]> {
  const portion = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject));
  return portion.length === 0 ? [] : [...portion, ...(await all(reader))];
}
