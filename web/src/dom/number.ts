// Formats numbers for people.

/** A number with `count` significant digits, without trailing zeros. */
export function digits(value: number, count = 4): string {
  if (value === 0 || !Number.isFinite(value)) return String(value);
  const size = Math.abs(value);
  if (size >= 1e7 || size < 1e-4) return value.toExponential(count - 1).replace(/\.?0+e/, "e").replace("e+", "e");
  return String(Number(value.toPrecision(count)));
}

/** A mass in kilograms. */
export function kilograms(value: number): string {
  return `${digits(value)} kg`;
}

/** "1 sphere", "2 spheres". */
export function counted(count: number, one: string, many = `${one}s`): string {
  return `${count} ${count === 1 ? one : many}`;
}

/** The size of a file. */
export function bytesText(bytes: number): string {
  if (bytes < 1000) return counted(bytes, "byte");
  return bytes < 1e6 ? `${digits(bytes / 1e3, 3)} kB` : `${digits(bytes / 1e6, 3)} MB`;
}

/** A unit with its exponents raised: N/m2 is N/m². */
export function unitText(unit: string): string {
  return unit.replace(/([a-z])2\b/g, "$1²").replace(/([a-z])3\b/g, "$1³");
}
