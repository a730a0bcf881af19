// The only place where text becomes markup. In browsers that support trusted types, the page's policy forbids all others.

interface Rules {
  createHTML(text: string): string;
}

interface Factory {
  createPolicy(name: string, rules: Rules): Rules;
}

const passThrough: Rules = { createHTML: (text) => text };
const { trustedTypes } = globalThis as { trustedTypes?: Factory };
// The name of the policy is also in web/build/policy.mjs.
const rules = trustedTypes?.createPolicy("osim", passThrough) ?? passThrough;

/** Marks HTML of the engine's renderer or of the manual as trusted. */
export const engineHtml = (html: string): string => rules.createHTML(html);
