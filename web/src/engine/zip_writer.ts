// Builds a ZIP file by file, so that the results of many models are in memory only once and compressed.

import { Zip, ZipDeflate, ZipPassThrough } from "fflate";

// All files have this date, so that equal results give equal archives.
const DATE_OF_FILES = new Date(1980, 0, 1);

export class Archive {
  readonly #chunks: Uint8Array[] = [];
  readonly #files = new Map<string, string>();
  readonly #zip = new Zip((error, chunk) => {
    if (error) throw error;
    this.#chunks.push(chunk);
  });

  /** Whether the archive has a different file of this name. */
  hasOther(name: string, bytes: Uint8Array): boolean {
    const existing = this.#files.get(name);
    return existing !== undefined && existing !== digestOfFile(name, bytes);
  }

  /** Adds a file, unless the archive has it already. */
  add(name: string, bytes: Uint8Array): void {
    if (this.#files.has(name)) return;
    this.#files.set(name, digestOfFile(name, bytes));
    const file = new ZipDeflate(name, { level: 6 });
    file.mtime = DATE_OF_FILES;
    this.#zip.add(file);
    file.push(bytes, true);
  }

  /** Ends the archive and returns its bytes. */
  end(): Uint8Array {
    this.#zip.end();
    const size = this.#chunks.reduce((sum, chunk) => sum + chunk.length, 0);
    const all = new Uint8Array(size);
    let at = 0;
    for (const chunk of this.#chunks) {
      all.set(chunk, at);
      at += chunk.length;
    }
    return all;
  }
}

/** Size and CRC-32 of a file, to compare files without storing their contents. */
function digestOfFile(name: string, bytes: Uint8Array): string {
  const read = new ZipPassThrough(name);
  read.ondata = () => undefined;
  read.push(bytes, true);
  return `${bytes.length} ${read.crc}`;
}
