// The one place where text becomes markup or the address of a script: the page's policy lets no other do that, in browsers
// that know of it.

interface Rules {
  createHTML(text: string): string;
  createScriptURL(text: string): string;
}

interface Factory {
  createPolicy(name: string, rules: Rules): Rules;
}

const asItIs: Rules = { createHTML: (text) => text, createScriptURL: (text) => text };
const { trustedTypes } = globalThis as { trustedTypes?: Factory };
// Its name is in web/build/policy.mjs, too.
const rules = trustedTypes?.createPolicy("osim", asItIs) ?? asItIs;

/** HTML of the engine's renderer, and of the manual, to be read as markup. */
export const engineHtml = (html: string): string => rules.createHTML(html);

/** The address of the worker's script, which is in this page. */
export const workerAddress = (address: string): string => rules.createScriptURL(address);
