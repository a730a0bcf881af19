// Shapes for a body without bones: a capsule from joint to joint, and a wedge for each foot.

import { CapsuleGeometry, type Material, Mesh, Vector3 } from "three";
import { ConvexGeometry } from "three/examples/jsm/geometries/ConvexGeometry.js";

import type { PlacedSphere, Vector } from "../engine/space";

/** Spheres of one foot are closer together than this many radii. */
const FOOT_DISTANCE_IN_RADII = 8;

/** A capsule between two joints, at most `thickest` m thick. */
export function limb(from: Vector, to: Vector, thickest: number, material: Material): Mesh {
  const [start, end] = [new Vector3(...from), new Vector3(...to)];
  const length = start.distanceTo(end);
  const mesh = new Mesh(new CapsuleGeometry(Math.min(0.1 * length, thickest / 2), length, 3, 10), material);
  mesh.position.addVectors(start, end).multiplyScalar(0.5);
  mesh.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), end.sub(start).normalize());
  return mesh;
}

/** The spheres of each foot: on one side, and near each other. */
export function spheresOfFeet(spheres: readonly PlacedSphere[]): PlacedSphere[][] {
  const feet: PlacedSphere[][] = [];
  for (const sphere of spheres) {
    const isNear = (other: PlacedSphere) => other.side === sphere.side
      && new Vector3(...other.centre_m).distanceTo(new Vector3(...sphere.centre_m)) < FOOT_DISTANCE_IN_RADII * Math.max(sphere.radius_m, other.radius_m);
    const joined = feet.filter((foot) => foot.some(isNear));
    for (const foot of joined) feet.splice(feet.indexOf(foot), 1);
    feet.push([...joined.flat(), sphere]);
  }
  return feet;
}

/** A wedge around the spheres of a foot, in ground: from the heel to the toes, and up to the highest of the `joints` above it. */
export function footWedge(foot: readonly PlacedSphere[], joints: readonly Vector3[], axes: readonly [Vector, Vector, Vector]): ConvexGeometry {
  const [forward, up, right] = axes.map((axis) => new Vector3(...axis)) as [Vector3, Vector3, Vector3];
  const places = foot.map(({ centre_m: centre, radius_m: radius }) => ({ centre: new Vector3(...centre), radius }));
  const middle = places.reduce((sum, { centre }) => sum.addScaledVector(centre, 1 / places.length), new Vector3());
  const range = (axis: Vector3, some = places): [number, number] => {
    const at = some.map(({ centre }) => centre.dot(axis));
    return [Math.min(...at), Math.max(...at)];
  };
  const radius = Math.max(...places.map((one) => one.radius));
  const [back, front] = [range(forward)[0] - radius, range(forward)[1] + radius];
  const length = front - back;
  const sole = range(up)[0];
  const isOver = (joint: Vector3) => joint.distanceTo(middle) < 0.9 * length && joint.dot(up) > sole;
  const over = joints.filter(isOver).sort((one, other) => other.dot(up) - one.dot(up));
  const ankle = over[0] ?? middle.clone().addScaledVector(up, radius + 0.3 * length);
  const at = (ahead: number, height: number, aside: number) =>
    new Vector3().addScaledVector(forward, ahead).addScaledVector(up, height).addScaledVector(right, aside);
  const heel = range(right, places.filter(({ centre }) => centre.dot(forward) <= middle.dot(forward)));
  const toes = range(right, places.filter(({ centre }) => centre.dot(forward) >= middle.dot(forward)));
  const edge = (ahead: number, height: number, [least, most]: readonly [number, number], wider: number) =>
    [at(ahead, height, least - wider), at(ahead, height, most + wider)];
  const [ahead, height, aside] = [ankle.dot(forward), ankle.dot(up), ankle.dot(right)];
  return new ConvexGeometry([
    ...edge(back, sole, heel, radius / 2), ...edge(back, sole + 0.6 * (height - sole), heel, 0), ...edge(front, sole, toes, radius / 2),
    ...edge(front, sole + radius / 2, toes, 0), ...edge(ahead - radius / 2, height, [aside, aside], radius / 2), ...edge(ahead + radius, height, [aside, aside], radius / 2),
  ]);
}
