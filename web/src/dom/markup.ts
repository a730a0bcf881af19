// Parses the HTML of the engine's renderer and of the manual. No other markup is parsed; this one is ours and escaped.

import { engineHtml } from "./trusted";

const HEADINGS = "h2, h3, h4, h5, h6";

/** The elements of `html`, with its highest headings at `level`. The page's heading of a section is an h3, so those inside are h4. */
export function parseHtml(html: string, level = 4): DocumentFragment {
  const template = document.createElement("template");
  template.innerHTML = engineHtml(html);
  const headings = [...template.content.querySelectorAll(HEADINGS)];
  const highest = Math.min(...headings.map(levelOf));
  for (const heading of headings) setLevel(heading, Math.min(6, levelOf(heading) - highest + level));
  // Links open a new tab, so that open models are not lost.
  for (const link of template.content.querySelectorAll("a[href^='http']")) {
    link.setAttribute("target", "_blank");
    link.setAttribute("rel", "noopener noreferrer");
  }
  return template.content;
}

function levelOf(heading: Element): number {
  return Number(heading.tagName.slice(1));
}

function setLevel(heading: Element, level: number): void {
  if (levelOf(heading) === level) return;
  const replacement = document.createElement(`h${level}`);
  for (const { name, value } of heading.attributes) replacement.setAttribute(name, value);
  replacement.append(...heading.childNodes);
  heading.replaceWith(replacement);
}
