// Shows HTML of the engine's renderer and of the manual, the only markup that is read as such: it is ours, and escaped.

import { engineHtml } from "./trusted";

const HEADINGS = "h2, h3, h4, h5, h6";

/** What `html` describes, with its highest headings at `level`. A section's own heading is an h3 here, so that those in it are h4. */
export function parsed(html: string, level = 4): DocumentFragment {
  const template = document.createElement("template");
  template.innerHTML = engineHtml(html);
  const headings = [...template.content.querySelectorAll(HEADINGS)];
  const highest = Math.min(...headings.map(levelOf));
  for (const heading of headings) move(heading, Math.min(6, levelOf(heading) - highest + level));
  // What is open here must not be left for another site.
  for (const link of template.content.querySelectorAll("a[href^='http']")) {
    link.setAttribute("target", "_blank");
    link.setAttribute("rel", "noopener noreferrer");
  }
  return template.content;
}

function levelOf(heading: Element): number {
  return Number(heading.tagName.slice(1));
}

function move(heading: Element, level: number): void {
  if (levelOf(heading) === level) return;
  const moved = document.createElement(`h${level}`);
  for (const { name, value } of heading.attributes) moved.setAttribute(name, value);
  moved.append(...heading.childNodes);
  heading.replaceWith(moved);
}
