// Models in three dimensions, as the engine returns them (crates/osim-planning/src/scene). Lengths are in m, in ground.

export type Vector = readonly [number, number, number];

export interface PlacedSphere {
  name: string;
  path: string;
  body: string;
  side: "right" | "left" | null;
  centre_m: Vector;
  radius_m: number;
  /** The force on the sphere at rest, in body weights; null if it is not known. */
  force_bw: number | null;
  relative_indentation: number | null;
}

export interface Scene {
  /** Forward, up and to the right. */
  axes: readonly [Vector, Vector, Vector];
  /** Axes x, y and z of each body, and its origin. */
  bodies: readonly { name: string; frame: readonly [Vector, Vector, Vector, Vector] }[];
  spheres: readonly PlacedSphere[];
  planes: readonly { point_m: Vector; normal: Vector }[];
  /** Lines from joint to joint, in the frame of the body. */
  lines: readonly { body: string; from_m: Vector; to_m: Vector }[];
  why_not_placed: string | null;
}

/** The bones of a model, in the frames of their bodies. */
export interface Bones {
  /** Points in hundredths of a millimetre, three numbers each; triangles by the places of their points. */
  surfaces: readonly { body: string; mesh: string; points: readonly number[]; triangles: readonly number[] }[];
  /** Meshes that the model names and the page does not have. */
  missing: readonly string[];
  broken: readonly string[];
}

export interface Fall {
  name: string;
  step_s: number;
  radius_m: number;
  heights_m: readonly number[];
  forces_bw: readonly number[];
  why_not: string | null;
}

/** A force in each frame, in body weights, and its point on the floor, m. */
export interface PlayedForce {
  forces_bw: readonly (Vector | null)[];
  points_m: readonly (Vector | null)[];
}

/** A model along a recording. */
export interface PlayedMotion {
  time_s: readonly number[];
  bodies: readonly string[];
  /** The axes and the origin of each body in each frame, in hundred-thousandths. */
  poses: readonly number[];
  feet: readonly { name: string; side: "right" | "left" | null; model: PlayedForce; plates: PlayedForce | null }[];
  remarks: readonly string[];
}

/** A recording after the smallest correction that makes contacts and force plates agree. */
export interface CorrectedMotion {
  verdict: "agree" | "large-correction" | "disagree";
  why: string;
  remarks: readonly string[];
  /** The files that the command writes, with their texts; none if plates and motion cannot be compared. */
  files: readonly (readonly [name: string, text: string])[];
  played: PlayedMotion | null;
}

/** Two falls of an animal: heights of its spheres' lowest points in radii, at equal times in √(R/g). */
export interface AnimalFall {
  name: string;
  mass_kg: number;
  /** Heights on the contacts of a human. */
  left_behind: readonly number[];
  /** Heights on contacts that are scaled to the animal. */
  scaled: readonly number[];
}

export function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
