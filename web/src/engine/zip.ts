// A ZIP that grows file by file, so that the results of many models are in memory once, compressed.

import { Zip, ZipDeflate } from "fflate";

// Results have no date of their own, and equal results should give equal archives.
const DATE = new Date(1980, 0, 1);

export class Archive {
  readonly #chunks: Uint8Array[] = [];
  readonly #names = new Set<string>();
  readonly #zip = new Zip((error, chunk) => {
    if (error) throw error;
    this.#chunks.push(chunk);
  });

  /** Adds a file; one that is there already stays as it is. */
  add(name: string, bytes: Uint8Array): void {
    if (this.#names.has(name)) return;
    this.#names.add(name);
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
