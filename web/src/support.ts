// Whether this browser has what the page needs.

/** What is missing, in plain words; nothing where all is there. */
export function missingSupport(): string[] {
  const needed: [boolean, string][] = [
    [typeof WebAssembly === "object", "WebAssembly"],
    [typeof Worker === "function", "workers"],
    [typeof HTMLDialogElement === "function", "dialogs"],
  ];
  return needed.filter(([there]) => !there).map(([, name]) => name);
}
