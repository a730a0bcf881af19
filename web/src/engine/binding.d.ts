// Types of the binding that wasm-bindgen generates for crates/osim-web.

declare module "osim-engine" {
  export class Engine {
    constructor();
    free(): void;
    set_today(date: string): void;
    put(name: string, bytes: Uint8Array): void;
    remove(name: string): void;
    bytes(name: string): Uint8Array | undefined;
    result(index: number): Uint8Array | undefined;
    call(call: string): string;
  }
  export function initSync(options: { module: BufferSource }): unknown;
  /** Creates a new instance of the module; older objects belong to the old instance. */
  export function __wbg_reset_state(): void;
}
