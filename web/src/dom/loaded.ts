// Waits until the whole page is loaded: over a slow line, large blocks come long after the script.

/** A promise that is resolved when everything after the script is loaded, too. */
export function pageLoaded(): Promise<void> {
  if (document.readyState !== "loading") return Promise.resolve();
  return new Promise((resolve) => document.addEventListener("DOMContentLoaded", () => resolve(), { once: true }));
}
