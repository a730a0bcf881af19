// The animation of the start page: a mouse, a human and a giraffe fall on contacts of a human and on scaled contacts.

import { button, byId, el, setText } from "../dom/element";
import { kilograms } from "../dom/number";
import type { AnimalFall } from "../engine/space";
import type { Session } from "../state/session";

const SVG_NAMESPACE = "http://www.w3.org/2000/svg";
/** Sizes in the picture: radius of a ball, height of the ground, width of a column, height below the ground. */
const BALL_RADIUS = 13;
const GROUND_Y = 118;
const COLUMN_WIDTH = 200;
const HEIGHT_BELOW_GROUND = 64;
const FALL_MS = 2600;
const CAPTION = "Feet of three animals fall from a quarter of the radius of their spheres. Hollow: on the contacts of a human, left as they are: \
the mouse floats, the giraffe sinks. Full: on contacts scaled by mass. Lengths are in sphere radii, and times in √(R/g).";

/** Shows the animation, after the engine has started. */
export async function showFalls(session: Session): Promise<void> {
  const falls = await session.engine.animals().catch(() => []);
  if (falls.length === 0) return;
  const { picture, showMoment } = fallsPicture(falls);
  const moments = falls[0]?.scaled.length ?? 1;
  const again = button("Let them fall again", () => fall(), { class: "small" });
  let running = 0;
  const fall = () => {
    cancelAnimationFrame(running);
    const start = performance.now();
    const step = (now: number) => {
      const share = Math.min(1, (now - start) / FALL_MS);
      showMoment(Math.round(share * (moments - 1)));
      if (share < 1 && !byId("start").hidden) running = requestAnimationFrame(step);
    };
    running = requestAnimationFrame(step);
  };
  byId("falls").replaceChildren(picture, el("p", { class: "quiet" }, CAPTION), el("p", {}, again));
  showMoment(moments - 1);
  // Users who prefer no motion see the end of the falls.
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) fall();
}

interface Picture {
  picture: SVGSVGElement;
  /** Shows one moment of the falls. */
  showMoment(moment: number): void;
}

function fallsPicture(falls: readonly AnimalFall[]): Picture {
  const width = COLUMN_WIDTH * falls.length;
  const picture = svgElement("svg", { viewBox: `0 0 ${width} ${GROUND_Y + HEIGHT_BELOW_GROUND}`, role: "img", class: "animals" });
  picture.setAttribute("aria-label", `Falls of ${falls.map(describeFall).join("; ")}`);
  picture.append(svgElement("rect", { x: 0, y: GROUND_Y, width, height: 40, class: "ground" }));
  const balls = falls.flatMap(({ name, mass_kg: mass, left_behind: left, scaled }, index) => {
    const middle = COLUMN_WIDTH * (index + 0.5);
    const [wrong, right] = [ballCircle("old", middle - 24), ballCircle("new", middle + 24)];
    picture.append(wrong, right, labelElement(`${name}, ${kilograms(mass)}`, middle));
    return [{ circle: wrong, heights: left }, { circle: right, heights: scaled }];
  });
  const showMoment = (moment: number) => {
    for (const { circle, heights } of balls) {
      circle.setAttribute("cy", (GROUND_Y - BALL_RADIUS * (1 + (heights[moment] ?? 0))).toFixed(2));
    }
  };
  return { picture, showMoment };
}

function describeFall({ name, left_behind: left, scaled }: AnimalFall): string {
  const end = (heights: readonly number[]) => {
    const height = heights[heights.length - 1] ?? 0;
    return height > 0 ? `it floats ${height.toFixed(1)} radii above the ground` : `it is ${(-height).toFixed(2)} radii deep at the end`;
  };
  return `a ${name}: on contacts of a human ${end(left)}, on its own ${end(scaled)}`;
}

function ballCircle(kind: string, x: number): SVGCircleElement {
  return svgElement("circle", { r: BALL_RADIUS, cx: x, class: kind });
}

function labelElement(text: string, x: number): SVGTextElement {
  const label = svgElement("text", { x, y: GROUND_Y + HEIGHT_BELOW_GROUND - 14, "text-anchor": "middle" });
  setText(label, text);
  return label;
}

function svgElement<K extends keyof SVGElementTagNameMap>(tag: K, attributes: Readonly<Record<string, string | number>>): SVGElementTagNameMap[K] {
  const element = document.createElementNS(SVG_NAMESPACE, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  return element;
}
