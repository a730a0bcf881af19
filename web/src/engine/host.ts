// Runs the engine and stores its files: after a defect, a new engine starts with the same files.

import { __wbg_reset_state, Engine, initSync } from "osim-engine";

export class EngineHost {
  #engine: Engine | undefined;
  readonly #files = new Map<string, Uint8Array>();

  /** Starts the engine from the bytes of its module. */
  start(bytes: BufferSource): void {
    initSync({ module: bytes });
    this.#engine = new Engine();
  }

  /** Starts a new engine with the same files after the old one ended. The last change is lost. */
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

  /** Opens and changes an example in a separate engine, in steps, because browsers compile code when it first runs. */
  *warmUp(example: Uint8Array): Generator<void> {
    const engine = new Engine();
    engine.put("example.osim", example);
    engine.call(JSON.stringify({ do: "look", model: "example.osim", parts: ["feet", "scene"] }));
    const request = { verb: "rescale", models: ["example.osim"], target_mass: 500 };
    for (const part of ["changes", "plots", "scene", "falls"]) {
      yield;
      engine.call(JSON.stringify({ do: "change", request, parts: [part] }));
    }
    engine.free();
  }

  put(name: string, bytes: Uint8Array): void {
    // A file that makes the engine fail is not stored for the next engine.
    this.#runningEngine().put(name, bytes);
    this.#files.set(name, bytes);
  }

  remove(name: string): void {
    this.#files.delete(name);
    this.#runningEngine().remove(name);
  }

  bytes(name: string): Uint8Array | undefined {
    return this.#runningEngine().bytes(name);
  }

  result(index: number): Uint8Array | undefined {
    return this.#runningEngine().result(index);
  }

  call(call: string): string {
    const engine = this.#runningEngine();
    // The date in UTC, as in the other programs.
    engine.set_today(new Date().toISOString().slice(0, 10));
    return engine.call(call);
  }

  /** Stores files that the engine has made. */
  rememberFiles(names: string[]): void {
    for (const name of names) {
      const bytes = this.bytes(name);
      if (bytes) this.#files.set(name, bytes);
    }
  }

  #runningEngine(): Engine {
    if (!this.#engine) throw new Error("the engine has not started");
    return this.#engine;
  }
}
