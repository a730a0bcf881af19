// Finds how far the model must be lifted to stand on the floor, because its default pose may be elsewhere.

import { dot, type Scene } from "../engine/space";

/** The height of the floor along the up direction; undefined if the model has no floor, or several. */
export function floorHeight({ planes, axes: [, up] }: Scene): number | undefined {
  const heights = new Set(planes.filter(({ normal }) => dot(normal, up) > 0.7).map(({ point_m: point }) => dot(point, up)));
  const [height] = heights;
  return heights.size === 1 ? height : undefined;
}

/** The gap between the floor and the lowest sphere, m; negative if the sphere is inside the floor. */
export function lowestGap(scene: Scene): number | undefined {
  const floor = floorHeight(scene);
  if (floor === undefined || scene.spheres.length === 0) return undefined;
  const [, up] = scene.axes;
  return Math.min(...scene.spheres.map(({ centre_m: centre, radius_m: radius }) => dot(centre, up) - radius)) - floor;
}

/** How far the model must be lifted to rest on its spheres, m; if the weight is not known, until it touches the floor. */
export function liftToRest(scene: Scene): number | undefined {
  const [floor, gap] = [floorHeight(scene), lowestGap(scene)];
  if (floor === undefined || gap === undefined) return undefined;
  const [, up] = scene.axes;
  const pressed = scene.spheres.filter(({ relative_indentation: x }) => x !== null && x > 0);
  const lifts = pressed.map(({ centre_m: centre, radius_m: radius, relative_indentation: x }) =>
    floor - (dot(centre, up) - radius) - (x ?? 0) * radius);
  return lifts.length > 0 ? Math.max(...lifts) : -gap;
}
