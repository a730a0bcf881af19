// Whether all of the page was read: over a slow line, large blocks come long after the script.

/** Settled once everything after the script is there, too. */
export function wholePage(): Promise<void> {
  if (document.readyState !== "loading") return Promise.resolve();
  return new Promise((resolve) => document.addEventListener("DOMContentLoaded", () => resolve(), { once: true }));
}
