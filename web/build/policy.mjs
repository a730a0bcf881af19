// The Content-Security-Policy of the page: what it may do. Tests build another page with it, to see that nothing leaves.

import { createHash } from "node:crypto";

/**
 * The first script of a page: it takes away two ways out that no policy governs, which are another window and a connection
 * between browsers. Links still lead elsewhere, when somebody clicks one.
 */
export const guard =
  'for(const name of["open","RTCPeerConnection","webkitRTCPeerConnection"])Object.defineProperty(window,name,{value:undefined,writable:false,configurable:false});';

/** The policy under which these scripts and styles run, and nothing else. */
export function policy({ scripts, styles }) {
  return [
    "default-src 'none'",
    "connect-src 'none'",
    "img-src 'none'",
    "form-action 'none'",
    "base-uri 'none'",
    // The engine is WebAssembly: compiling it needs a word of its own, which allows no JavaScript from text.
    `script-src ${scripts.map(hash).join(" ")} 'wasm-unsafe-eval'`,
    `style-src ${styles.map(hash).join(" ")}`,
    "worker-src blob:",
    // Text becomes markup in one place of the script only, src/dom/trusted.ts: browsers that know of this let no other do it.
    "require-trusted-types-for 'script'",
    "trusted-types osim osim-worker",
  ].join("; ");
}

/** The policy as the first element of a page's head. */
export function policyElement(allowed) {
  return `<meta http-equiv="Content-Security-Policy" content="${policy(allowed)}">`;
}

function hash(text) {
  return `'sha256-${createHash("sha256").update(text, "utf8").digest("base64")}'`;
}
