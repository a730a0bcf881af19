// Draws curves of force against time, with a line at the current moment.

import { digits } from "../dom/number";

const SVG_NAMESPACE = "http://www.w3.org/2000/svg";
const PICTURE_WIDTH = 600;
const LEFT_MARGIN = 34;
const BOTTOM_MARGIN = 24;
const LETTER_PX = 11.5;
const MOST_MARKED_WITH_1 = 4;

/** A curve: `kind` is its look, null is a gap. */
export interface Curve {
  kind: "new" | "before" | "old";
  values: readonly (number | null)[];
}

export class Curves {
  readonly element = document.createElementNS(SVG_NAMESPACE, "svg");
  readonly #cursor = lineElement("cursor", LEFT_MARGIN, 4, LEFT_MARGIN, 4);
  #count = 1;

  constructor(readonly height: number) {
    this.element.setAttribute("viewBox", `0 0 ${PICTURE_WIDTH} ${height}`);
    this.element.setAttribute("role", "img");
    this.element.setAttribute("class", "curves");
    // The picture is as large as its place; its letters stay as large.
    const scale = () => Math.min(this.element.clientWidth / PICTURE_WIDTH, this.element.clientHeight / height) || 1;
    new ResizeObserver(() => (this.element.style.fontSize = `${LETTER_PX / scale()}px`)).observe(this.element);
  }

  /** Draws curves over the time from `start` to `end`; `about` describes them for screen readers. */
  show(curves: readonly Curve[], title: string, about: string, start: number, end: number): void {
    const numbers = curves.flatMap(({ values }) => values.filter((value) => value !== null));
    const [most, least] = [Math.max(1.2, ...numbers) * 1.05, Math.min(0, ...numbers)];
    const floor = this.height - BOTTOM_MARGIN;
    const y = (value: number) => floor - ((floor - 6) * (value - least)) / (most - least);
    this.#count = Math.max(1, ...curves.map(({ values }) => values.length));
    const highest = Math.floor(most);
    // A mark at 1 would be written over the one at 0 if the curve is high.
    const marks = highest > MOST_MARKED_WITH_1 ? [0, highest] : [...new Set([0, 1, highest])];
    const axes = marks.flatMap((mark) => [lineElement("grid", LEFT_MARGIN, y(mark), PICTURE_WIDTH, y(mark)), labelElement(String(mark), LEFT_MARGIN - 6, y(mark) + 4, "end")]);
    const ends = [
      labelElement(title, LEFT_MARGIN, this.height - 4, "start"), labelElement(`${digits(start, 3)} to ${digits(end, 3)} s`, PICTURE_WIDTH - 2, this.height - 4, "end"),
    ];
    this.#cursor.setAttribute("y2", String(floor));
    this.element.setAttribute("aria-label", about);
    this.element.replaceChildren(...axes, ...ends, ...curves.flatMap((curve) => this.#pieces(curve, y)), this.#cursor);
    this.moveCursor(0);
  }

  /** Moves the line to a moment. */
  moveCursor(moment: number): void {
    for (const end of ["x1", "x2"]) this.#cursor.setAttribute(end, String(this.#x(moment)));
  }

  #x(index: number): number {
    return LEFT_MARGIN + ((PICTURE_WIDTH - LEFT_MARGIN) * index) / Math.max(1, this.#count - 1);
  }

  #pieces({ kind, values }: Curve, y: (value: number) => number): SVGElement[] {
    const pieces: string[][] = [[]];
    for (const [index, value] of values.entries()) {
      if (value === null) pieces.push([]);
      else pieces[pieces.length - 1]?.push(`${this.#x(index).toFixed(1)},${y(value).toFixed(1)}`);
    }
    return pieces.filter((points) => points.length > 1).map((points) => {
      const curve = document.createElementNS(SVG_NAMESPACE, "polyline");
      curve.setAttribute("points", points.join(" "));
      curve.setAttribute("class", kind);
      return curve;
    });
  }
}

function lineElement(kind: string, x1: number, y1: number, x2: number, y2: number): SVGLineElement {
  const element = document.createElementNS(SVG_NAMESPACE, "line");
  for (const [name, value] of Object.entries({ x1, y1, x2, y2, class: kind })) element.setAttribute(name, String(value));
  return element;
}

function labelElement(text: string, x: number, y: number, anchor: string): SVGTextElement {
  const element = document.createElementNS(SVG_NAMESPACE, "text");
  for (const [name, value] of Object.entries({ x, y, "text-anchor": anchor })) element.setAttribute(name, String(value));
  element.textContent = text;
  return element;
}
