// The only place where text becomes markup or the address of a script. In browsers that support trusted types, the page's policy
// forbids all others.

interface Rules {
  createHTML(text: string): string;
  createScriptURL(text: string): string;
}

interface Factory {
  createPolicy(name: string, rules: Rules): Rules;
}

const passThrough: Rules = { createHTML: (text) => text, createScriptURL: (text) => text };
const { trustedTypes } = globalThis as { trustedTypes?: Factory };
// The name of the policy is also in web/build/policy.mjs.
const rules = trustedTypes?.createPolicy("osim", passThrough) ?? passThrough;

/** Marks HTML of the engine's renderer or of the manual as trusted. */
export const engineHtml = (html: string): string => rules.createHTML(html);

/** Marks the address of the worker's script, which is part of this page, as trusted. */
export const workerAddress = (address: string): string => rules.createScriptURL(address);
