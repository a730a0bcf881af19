// Drawings of the ways to add contacts to a model.

const SVG_NAMESPACE = "http://www.w3.org/2000/svg";
const OUTLINE_OF_SOLE = "M4 20 Q6 8 14 9 Q30 12 44 19 L44 22 L6 22 Z";
/** Drawings: a foot with spheres from another foot; spheres below a bone; a table. */
const PICTURES: Readonly<Record<string, readonly [shape: string, kind: "line" | "ball"][]>> = {
  from: [[OUTLINE_OF_SOLE, "line"], ["M9 22 a4 4 0 1 0 8 0 a4 4 0 1 0 -8 0", "ball"], ["M32 22 a4 4 0 1 0 8 0 a4 4 0 1 0 -8 0", "ball"], ["M22 3 L22 14 M18 10 L22 14 L26 10", "line"]],
  feet: [[OUTLINE_OF_SOLE, "line"], ["M7 26 a3 3 0 1 0 6 0 a3 3 0 1 0 -6 0", "ball"], ["M21 26 a3 3 0 1 0 6 0 a3 3 0 1 0 -6 0", "ball"], ["M36 26 a3 3 0 1 0 6 0 a3 3 0 1 0 -6 0", "ball"]],
  contacts: [["M6 4 H42 V28 H6 Z M6 12 H42 M6 20 H42 M18 4 V28 M30 4 V28", "line"]],
};

export function wayPicture(way: string): SVGSVGElement {
  const picture = document.createElementNS(SVG_NAMESPACE, "svg");
  for (const [name, value] of [["viewBox", "0 0 48 32"], ["class", "way-picture"], ["aria-hidden", "true"]] as const) picture.setAttribute(name, value);
  for (const [shape, kind] of PICTURES[way] ?? []) {
    const path = document.createElementNS(SVG_NAMESPACE, "path");
    path.setAttribute("d", shape);
    path.setAttribute("class", kind);
    picture.append(path);
  }
  return picture;
}
