// Assembles the page: markup, styles, script, and the blocks of data.

import { readFileSync } from "node:fs";
import { join } from "node:path";

import { transform } from "esbuild";

import { paper, version } from "./facts.mjs";
import { forms } from "./forms.mjs";
import { manual } from "./manual.mjs";
import { block, asciiSource, textBlock } from "./pack.mjs";
import { ROOT, WEB } from "./paths.mjs";
import { guard, policyElement } from "./policy.mjs";

const EXAMPLE = "fixtures/table1/human_62kg_smooth_sphere.osim";
// The first is that of the report's fragments, which the page shows.
const STYLES = ["crates/osim-view/src/html/style.css", "web/page/page.css", "web/page/forms.css", "web/page/panels.css", "web/page/bench.css"];

/** The text of the page, and the sizes of its parts. */
export async function assemble({ boot, script, worker, wasm, licences }) {
  const style = await styles();
  const blocks = [
    ["forms", textBlock("forms", asciiSource(JSON.stringify(forms()).replaceAll("<", "\\u003c")))],
    ["engine", block("engine", wasm)],
    ["example", block("example", readFileSync(join(ROOT, EXAMPLE)))],
    ["manual", block("manual-html", Buffer.from(manual()))],
    ["licences", block("licences-text", Buffer.from(licences))],
  ];
  // Inside an element, this would end it.
  if (/<\/(script|style)|<!--/i.test(boot + script + worker + style)) throw new Error("a script or a style holds an end tag");
  const html = inAscii(filled(readFileSync(join(WEB, "page/page.html"), "utf8"), {
    policy: policyElement({ scripts: [guard, boot, script], styles: [style] }),
    guard: `<script>${guard}</script>`,
    style: `<style>${style}</style>`,
    // The worker starts while the browser reads the large blocks, which are before the script that needs them.
    worker: textBlock("worker", worker),
    boot: `<script>${boot}</script>`,
    blocks: joined(blocks),
    script: `<script>${script}</script>`,
    version: version(),
    ...cited(paper()),
  }));
  const sizes = blocks.map(([name, text]) => [`block ${name}`, text.length]);
  return { html, sizes: [...sizes, ["worker", worker.length], ["script", script.length], ["style", style.length]] };
}

function joined(blocks) {
  return blocks.map(([, text]) => text).join("\n");
}

async function styles() {
  const parts = STYLES.map((name) => readFileSync(join(ROOT, name), "utf8"));
  const { code } = await transform(parts.join("\n"), { loader: "css", minify: true, charset: "ascii" });
  return code.trim();
}

function cited(paper) {
  return Object.fromEntries(Object.entries(paper).map(([name, text]) => [`paper-${name}`, escaped(text)]));
}

function escaped(text) {
  return text.replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);
}

/** Markup with all other letters as references; script and style have none. */
function inAscii(html) {
  return html.replace(/[^\0-\x7f]/gu, (letter) => `&#${letter.codePointAt(0)};`);
}

/** `{{name}}` is replaced by its value; a name without a value is an error. */
function filled(template, values) {
  return template.replace(/\{\{([a-z-]+)\}\}/g, (_, name) => {
    if (!(name in values)) throw new Error(`page.html: no value for ${name}`);
    return values[name];
  });
}
