// Shows HTML of the engine's renderer, the only markup that is read as such: it is ours, and escaped.

// Headings in a section are one level below the section's, which is an h3 here and an h2 in reports.
const LOWERED: Readonly<Record<string, string>> = { H3: "h4", H4: "h5", H5: "h6" };

/** What `html` describes, with headings one level lower. */
export function parsed(html: string): DocumentFragment {
  const template = document.createElement("template");
  template.innerHTML = html;
  for (const heading of template.content.querySelectorAll("h3, h4, h5")) lower(heading);
  return template.content;
}

function lower(heading: Element): void {
  const lowered = document.createElement(LOWERED[heading.tagName] ?? "h6");
  for (const { name, value } of heading.attributes) lowered.setAttribute(name, value);
  lowered.append(...heading.childNodes);
  heading.replaceWith(lowered);
}
