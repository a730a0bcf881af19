// Shows ground reactions along a recording as arrows: the forces of the contacts and the forces of the force plates.

import { ArrowHelper, Group, Vector3 } from "three";

import type { PlayedMotion, PlayedForce } from "../engine/space";

/** The longest arrow, in body weights. */
const LONGEST_ARROW_BW = 3;

export class ForceArrows {
  readonly group = new Group();
  /** Two arrows for each foot: the force of its contacts, then the force of its plates. */
  #arrows: ArrowHelper[] = [];
  #played: PlayedMotion | undefined;

  /** Shows the forces of a frame; `unit` is the length of one body weight. */
  show(played: PlayedMotion, frame: number, unit: number, colours: { model: string; plates: string }): void {
    if (played !== this.#played) this.#begin(played, colours);
    const forces = played.feet.flatMap(({ model, plates }) => [model, plates]);
    for (const [index, force] of forces.entries()) {
      const arrow = this.#arrows[index];
      if (arrow) setArrow(arrow, force, frame, unit);
    }
    this.group.visible = true;
  }

  hide(): void {
    this.group.visible = false;
  }

  #begin(played: PlayedMotion, colours: { model: string; plates: string }): void {
    for (const arrow of this.#arrows) {
      arrow.removeFromParent();
      arrow.dispose();
    }
    // Arrows are drawn over spheres and bones.
    const newArrow = (colour: string) => {
      const arrow = new ArrowHelper(new Vector3(0, 1, 0), new Vector3(), 1, colour);
      for (const part of [arrow.line, arrow.cone]) {
        part.renderOrder = 2;
        for (const material of [part.material].flat()) material.depthTest = false;
      }
      return arrow;
    };
    this.#arrows = played.feet.flatMap(() => [newArrow(colours.model), newArrow(colours.plates)]);
    this.group.add(...this.#arrows);
    this.#played = played;
  }
}

function setArrow(arrow: ArrowHelper, force: PlayedForce | null, frame: number, unit: number): void {
  const [push, at] = [force?.forces_bw[frame], force?.points_m[frame]];
  arrow.visible = push != null && at != null;
  if (!push || !at) return;
  const along = new Vector3(...push);
  // Contacts that are far too stiff have forces of many body weights; the curves show them.
  const length = unit * Math.min(along.length(), LONGEST_ARROW_BW);
  arrow.position.set(...at);
  arrow.setDirection(along.normalize());
  arrow.setLength(Math.max(length, 1e-6), Math.min(0.2 * length, 0.12 * unit), Math.min(0.1 * length, 0.06 * unit));
}
