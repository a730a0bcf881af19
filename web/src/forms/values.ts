// The values of a form as the user has typed them.

export type Value = string | boolean | readonly string[] | Readonly<Record<string, string>>;

type Listener = (name: string | null) => void;

export class Values {
  readonly #listeners = new Set<Listener>();
  readonly #chosen = new Set<string>();
  #values = new Map<string, Value>();

  get(name: string): Value | undefined {
    return this.#values.get(name);
  }

  /** The value of a field with one text. */
  text(name: string): string {
    const value = this.#values.get(name);
    return typeof value === "string" ? value : "";
  }

  /** The value of a field with several texts. */
  texts(name: string): readonly string[] {
    const value = this.#values.get(name);
    if (Array.isArray(value)) return value;
    return typeof value === "string" && value !== "" ? [value] : [];
  }

  /** The value of a field with named texts. */
  entries(name: string): Readonly<Record<string, string>> {
    const value = this.#values.get(name);
    return typeof value === "object" && !Array.isArray(value) ? (value as Readonly<Record<string, string>>) : {};
  }

  /** The values of all fields that have one. */
  all(): ReadonlyMap<string, Value> {
    return new Map(this.#values);
  }

  /** Whether a slider or a button has set the field, so that its unit is certain. */
  isChosen(name: string): boolean {
    return this.#chosen.has(name);
  }

  /** Sets a field by a slider or a button. */
  choose(name: string, value: Value): void {
    this.#chosen.add(name);
    this.#store(name, value);
  }

  /** Sets a field; an empty value removes it. */
  set(name: string, value: Value): void {
    this.#chosen.delete(name);
    this.#store(name, value);
  }

  #store(name: string, value: Value): void {
    if (isEmptyValue(value)) this.#values.delete(name);
    else this.#values.set(name, value);
    this.#notify(name);
  }

  /** Replaces all values, then calls `beforeNotify`, then the listeners. */
  replace(values: ReadonlyMap<string, Value>, beforeNotify: () => void = () => undefined): void {
    this.#chosen.clear();
    this.#values = new Map([...values].filter(([, value]) => !isEmptyValue(value)));
    beforeNotify();
    this.#notify(null);
  }

  clear(): void {
    this.replace(new Map());
  }

  /** Calls `listener` with the name of each field that changes, or with null if all change; returns a function that ends this. */
  watch(listener: Listener): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  #notify(name: string | null): void {
    for (const listener of [...this.#listeners]) listener(name);
  }
}

function isEmptyValue(value: Value): boolean {
  if (typeof value === "string") return value.trim() === "";
  if (typeof value === "boolean") return !value;
  return (Array.isArray(value) ? value : Object.keys(value)).length === 0;
}
