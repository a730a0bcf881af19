// Checks whether this browser has all features that the page needs.

/** The names of missing features; empty if there are none. */
export function missingSupport(): string[] {
  const needed: [boolean, string][] = [
    [typeof WebAssembly === "object", "WebAssembly"],
    [typeof Worker === "function", "workers"],
    [typeof HTMLDialogElement === "function", "dialogs"],
  ];
  return needed.filter(([isPresent]) => !isPresent).map(([, name]) => name);
}
