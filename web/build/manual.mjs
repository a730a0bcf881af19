// The manual inside the page: docs/page.md as HTML, without its pictures. Links to other pages of the book become their names, because
// the page may be saved without the book.

import { readFileSync } from "node:fs";
import { join } from "node:path";

import { Marked } from "marked";

import { ROOT } from "./paths.mjs";

const SOURCE = "docs/page.md";

const outside = /^https?:/;
const marked = new Marked({
  renderer: {
    image: () => "",
    link({ href, tokens }) {
      const text = this.parser.parseInline(tokens);
      return outside.test(href) ? `<a href="${href}">${text}</a>` : `<em>${text}</em>`;
    },
  },
});

/** The manual without its title. */
export function manual() {
  const text = readFileSync(join(ROOT, SOURCE), "utf8").replace(/^# .*\n/, "");
  return marked.parse(text).replace(/<p>\s*<\/p>\n/g, "");
}
