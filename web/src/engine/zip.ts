// A ZIP that grows file by file, so that the results of many models are in memory once, compressed.

import { Zip, ZipDeflate, ZipPassThrough } from "fflate";

// Results have no date of their own, and equal results should give equal archives.
const DATE = new Date(1980, 0, 1);

export class Archive {
  readonly #chunks: Uint8Array[] = [];
  readonly #files = new Map<string, string>();
  readonly #zip = new Zip((error, chunk) => {
    if (error) throw error;
    this.#chunks.push(chunk);
  });

  /** Whether another file of this name is there already. */
  hasOther(name: string, bytes: Uint8Array): boolean {
    const there = this.#files.get(name);
    return there !== undefined && there !== digest(name, bytes);
  }

  /** Adds a file; an equal one is there once. */
  add(name: string, bytes: Uint8Array): void {
    if (this.#files.has(name)) return;
    this.#files.set(name, digest(name, bytes));
    const file = new ZipDeflate(name, { level: 6 });
    file.mtime = DATE;
    this.#zip.add(file);
    file.push(bytes, true);
  }

  /** The whole archive. */
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

/** Size and CRC-32: what archives themselves compare contents by. Contents are not kept for a comparison. */
function digest(name: string, bytes: Uint8Array): string {
  const read = new ZipPassThrough(name);
  read.ondata = () => undefined;
  read.push(bytes, true);
  return `${bytes.length} ${read.crc}`;
}
