// The colours of the page around the view, and what bones and spheres look like in them.

import { Color, DoubleSide, LineBasicMaterial, MeshLambertMaterial } from "three";

export interface Colours {
  accent: string;
  bone: string;
  old: string;
  force: string;
  floor: string;
}

export function materials({ accent, bone, old }: Colours) {
  return {
    ball: new MeshLambertMaterial({ color: new Color(accent), transparent: true, opacity: 0.85 }),
    bone: new MeshLambertMaterial({ color: new Color(bone), side: DoubleSide }),
    // The spheres inside a foot are seen through it.
    foot: new MeshLambertMaterial({ color: new Color(bone), side: DoubleSide, transparent: true, opacity: 0.4, depthWrite: false }),
    // Old spheres are drawn over everything around them.
    old: new LineBasicMaterial({ color: new Color(old), depthTest: false }),
  };
}

/** The colours of the page around the canvas. */
export function readColours(element: Element): Colours {
  const style = getComputedStyle(element);
  const colour = (name: string) => style.getPropertyValue(name).trim();
  return { accent: colour("--accent"), bone: colour("--bone"), old: colour("--text"), force: colour("--error"), floor: colour("--quiet") };
}
