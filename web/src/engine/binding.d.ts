// What wasm-bindgen makes of crates/osim-web, and what the build puts into scripts.

declare module "osim-engine" {
  export class Engine {
    constructor();
    free(): void;
    set_today(date: string): void;
    put(name: string, bytes: Uint8Array): void;
    remove(name: string): void;
    bytes(name: string): Uint8Array | undefined;
    result(index: number): Uint8Array | undefined;
    call(question: string): string;
  }
  export function initSync(options: { module: BufferSource }): unknown;
  /** A new instance of the module; what was made before belongs to the old one. */
  export function __wbg_reset_state(): void;
}
