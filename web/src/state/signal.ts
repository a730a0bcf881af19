// A value whose listeners are called when it changes.

type Listener<T> = (value: T) => void;

export class Signal<T> {
  readonly #listeners = new Set<Listener<T>>();
  #value: T;

  constructor(value: T) {
    this.#value = value;
  }

  get value(): T {
    return this.#value;
  }

  set(value: T): void {
    if (Object.is(value, this.#value)) return;
    this.#value = value;
    for (const listener of [...this.#listeners]) listener(value);
  }

  /** Calls `listener` now, and whenever the value changes. */
  watch(listener: Listener<T>): void {
    this.#listeners.add(listener);
    listener(this.#value);
  }
}
