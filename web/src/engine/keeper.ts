// Keeps the engine, and the files that were given to it: a defect in the engine ends it, and loses nothing.

import { __wbg_reset_state, Engine, initSync } from "osim-engine";

export class Keeper {
  #engine: Engine | undefined;
  readonly #files = new Map<string, Uint8Array>();

  /** Starts the engine from the bytes of its module. */
  start(bytes: BufferSource): void {
    initSync({ module: bytes });
    this.#engine = new Engine();
  }

  /** Starts it again after it ended, with the same files. The last change is forgotten. */
  restart(): void {
    if (!this.#engine) return;
    __wbg_reset_state();
    const engine = new Engine();
    this.#engine = engine;
    for (const [name, bytes] of this.#files) {
      try {
        engine.put(name, bytes);
      } catch {
        this.#files.delete(name);
        return this.restart();
      }
    }
  }

  /** Does to an example what users do first, in an engine of its own: browsers compile what runs for the first time. */
  warmUp(example: Uint8Array): void {
    const engine = new Engine();
    engine.put("example.osim", example);
    engine.call(JSON.stringify({ do: "look", model: "example.osim", parts: ["feet", "scene"] }));
    const request = { verb: "rescale", models: ["example.osim"], target_mass: 500 };
    engine.call(JSON.stringify({ do: "change", request, parts: ["changes", "plots", "scene", "falls"] }));
    engine.free();
  }

  put(name: string, bytes: Uint8Array): void {
    // One that ends the engine is not given to the next one.
    this.#started().put(name, bytes);
    this.#files.set(name, bytes);
  }

  remove(name: string): void {
    this.#files.delete(name);
    this.#started().remove(name);
  }

  bytes(name: string): Uint8Array | undefined {
    return this.#started().bytes(name);
  }

  result(index: number): Uint8Array | undefined {
    return this.#started().result(index);
  }

  call(question: string): string {
    const engine = this.#started();
    // At Greenwich, as the other programs have it.
    engine.set_today(new Date().toISOString().slice(0, 10));
    return engine.call(question);
  }

  /** Remembers files that the engine made for itself. */
  kept(names: string[]): void {
    for (const name of names) {
      const bytes = this.bytes(name);
      if (bytes) this.#files.set(name, bytes);
    }
  }

  #started(): Engine {
    if (!this.#engine) throw new Error("the engine has not started");
    return this.#engine;
  }
}
