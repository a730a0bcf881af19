// The manual of the page, for the page itself: docs/page.md as HTML. Its pictures show what the reader has before them; other pages of
// the manual are named, because a file that was saved alone has nothing beside it.

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
