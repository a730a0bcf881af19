// Draws the model in three dimensions: bones, spheres before and after the change, the floor, and the forces.

import {
  AmbientLight, ArrowHelper, BufferAttribute, BufferGeometry, DirectionalLight, GridHelper, Group, LineSegments, Matrix4, Mesh,
  type MeshLambertMaterial, Object3D, PerspectiveCamera, Raycaster, Scene as World, SphereGeometry, Vector2, Vector3, WebGLRenderer,
} from "three";

import type { Bones, PlacedSphere, PlayedMotion, Scene, Vector } from "../engine/space";
import { type Colours, materials, readColours } from "./colours";
import { ForceArrows } from "./force_arrows";
import { footWedge, limb, spheresOfFeet } from "./limbs";
import { floorHeight, liftToRest } from "./rest";

/** The part of the model in the view. */
export type ViewTarget = "feet" | "right" | "left" | "body";
export type ViewDirection = "side" | "top" | "front" | "corner";

export interface ShownModel {
  /** The current model. */
  now: Scene;
  /** The model after the change; undefined without a change. */
  after: Scene | undefined;
  standing: boolean;
}

const BALL = new SphereGeometry(1, 20, 14);
const RINGS = rings();
const POINTS_PER_M = 1e5;
/** Pixel ratio without a graphics card: while the picture moves, and after it has not moved for `REST_MS`. */
const MOVING_PIXEL_RATIO = 0.4;
const RESTING_PIXEL_RATIO = 1;
const REST_MS = 350;
/** Length of an arrow for one body weight along a recording, in body heights. */
const ARROW_PER_BW = 0.25;
/** Frames of a recording in which the distance of the feet is measured. */
const SAMPLES = 12;
/** Ratio of width and height of the picture of feet. */
const FEET_ASPECT_RATIO = 1.4;
/** Cells of the floor's grid along each side. */
const FLOOR_CELLS = 24;
/** Length of the longest arrow, in units of the visible part's size. */
const LONGEST_ARROW = 0.45;

export class Stage {
  readonly camera = new PerspectiveCamera(30, 1, 0.001, 200);
  readonly target = new Vector3();
  readonly #renderer: WebGLRenderer;
  readonly #world = new World();
  /** The parts that fall together: bones or limbs, and the current or new spheres. */
  readonly #body = new Group();
  readonly #oldSpheres = new Group();
  readonly #floor = new Group();
  readonly #forceArrows = new ForceArrows();
  /** The middle of the spheres in the last frame of a recording. */
  #followedMiddle: Vector3 | undefined;
  readonly #bodyGroups = new Map<string, Group>();
  readonly #balls = new Map<string, Mesh>();
  /** Arrows are kept, because new ones would have to be compiled again. */
  readonly #arrows = new Map<string, ArrowHelper>();
  #forces = true;
  readonly #sun = new DirectionalLight(0xffffff, 2);
  #colours: Colours;
  #shown: ShownModel | undefined;
  #bones: Bones | undefined;
  #materials;
  #drawRequested = false;
  readonly #slow: boolean;
  #fineTimer: ReturnType<typeof setTimeout> | undefined;
  #restLift = 0;

  constructor(readonly canvas: HTMLCanvasElement, drawer: Drawer) {
    this.#slow = drawer === "processor";
    this.#renderer = new WebGLRenderer({ canvas, antialias: !this.#slow, alpha: true, powerPreference: "low-power" });
    this.#renderer.setPixelRatio(this.#slow ? MOVING_PIXEL_RATIO : Math.min(devicePixelRatio, 2));
    this.#colours = readColours(canvas);
    this.#materials = materials(this.#colours);
    this.#world.add(this.#body, this.#oldSpheres, this.#floor, this.#forceArrows.group, this.#sun, new AmbientLight(0xffffff, 1.4));
  }

  /** Draws one object of each kind, because the first drawing takes long: its shaders are compiled. */
  warmUp(): void {
    const all = new Group();
    const { ball, bone, foot, old } = this.#materials;
    const arrow = new ArrowHelper(new Vector3(0, 1, 0), new Vector3(), 1, this.#colours.force);
    all.add(new Mesh(BALL, ball), new Mesh(BALL, bone), new Mesh(BALL, foot), new LineSegments(RINGS, old), arrow, grid(1, this.#colours.floor));
    this.#world.add(all);
    this.#renderer.render(this.#world, this.camera);
    clearGroup(all).removeFromParent();
    arrow.dispose();
  }

  /** Shows other bones. */
  setBones(bones: Bones | undefined): void {
    this.#bones = bones;
    this.#rebuildBodies();
    this.render();
  }

  /** Shows the model before and after the change. */
  show(model: ShownModel): void {
    const before = this.#scene;
    this.#shown = model;
    const moved = this.#scene !== before;
    if (moved) this.#rebuildBodies();
    this.#showSpheres(model);
    if (moved) this.#showFloor(this.#scene ?? model.now);
    this.lift(0, 0);
  }

  /** What floor, feet and view are taken from: the model, or its change, if that gives it its first spheres. */
  get #scene(): Scene | undefined {
    return this.#shown?.now.spheres.length === 0 ? (this.#shown.after ?? this.#shown.now) : this.#shown?.now;
  }

  /** Lifts the new and the old spheres above their places at rest, m, for a fall. */
  lift(body: number, old: number): void {
    const { axes: [, up] } = this.#shown?.now ?? { axes: [0, [0, 1, 0] as Vector] };
    const along = new Vector3(...up);
    this.#body.position.copy(along).multiplyScalar(this.#restLift + body);
    this.#oldSpheres.position.copy(along).multiplyScalar(this.#oldRestLift() + old);
    this.render();
  }

  /** Shows or hides the arrows of the forces at rest. */
  showForces(isVisible: boolean): void {
    this.#forces = isVisible;
    for (const arrow of this.#arrows.values()) arrow.visible = isVisible && arrow.userData["carries"] === true;
  }

  /** Shows a frame of a recording; `unpose` ends this. */
  pose(played: PlayedMotion, frame: number): void {
    const scene = this.#shown?.now;
    if (!scene) return;
    this.#body.position.set(0, 0, 0);
    this.#oldSpheres.visible = false;
    this.showForces(false);
    if (!this.#followedMiddle) this.#widenView(played, scene);
    const { middle } = extent(this.#placeSpheres(played, frame, scene));
    this.#forceArrows.show(played, frame, ARROW_PER_BW * bodyHeight(scene), { model: this.#colours.force, plates: this.#colours.old });
    this.#follow(middle, new Vector3(...scene.axes[1]));
    this.render();
  }

  /** Moves bodies and spheres to their places in a frame; returns the centres of the spheres. */
  #placeSpheres(played: PlayedMotion, frame: number, { spheres }: Scene): Vector3[] {
    for (const [index, name] of played.bodies.entries()) {
      const group = this.#bodyGroups.get(name);
      if (group) placeBody(group, played.poses, 12 * (frame * played.bodies.length + index));
    }
    return spheres.flatMap(({ path, body, centre_m: centre }) => {
      const [group, ball] = [this.#bodyGroups.get(body), this.#balls.get(path)];
      const restMatrix = group?.userData["rest"] as Matrix4 | undefined;
      if (!group || !ball || !restMatrix) return [];
      return [ball.position.set(...centre).applyMatrix4(restMatrix.clone().invert()).applyMatrix4(group.matrix).clone()];
    });
  }

  /** Moves the camera back until all spheres of the whole recording are visible: feet are further apart in a stride. */
  #widenView(played: PlayedMotion, scene: Scene): void {
    const frames = Array.from({ length: SAMPLES }, (_, index) => Math.floor((index * (played.time_s.length - 1)) / (SAMPLES - 1)));
    const reach = Math.max(...frames.map((frame) => extent(this.#placeSpheres(played, frame, scene)).reach));
    const distance = (1.15 * reach) / this.#visibleHalf(FEET_ASPECT_RATIO);
    const from = this.camera.position.clone().sub(this.target);
    if (from.length() < distance) this.camera.position.copy(this.target).addScaledVector(from, distance / from.length());
  }

  /** Half of the visible width at a distance of 1. The narrower side of the window counts; an object that is `flat` needs less height. */
  #visibleHalf(flat: number): number {
    return Math.tan((this.camera.fov * Math.PI) / 360) * Math.min(flat, this.camera.aspect);
  }

  /** Moves bodies back to the pose of the file. */
  unpose(): void {
    if (!this.#followedMiddle) return;
    this.#followedMiddle = undefined;
    this.#forceArrows.hide();
    this.#oldSpheres.visible = true;
    this.showForces(true);
    this.#floor.position.set(0, 0, 0);
    for (const group of this.#bodyGroups.values()) {
      group.matrix.copy(group.userData["rest"] as Matrix4);
      group.matrixWorldNeedsUpdate = true;
    }
    const model = this.#shown;
    if (model) this.show(model);
  }

  /** Moves the camera and the floor's grid along the floor with the feet. */
  #follow(middle: Vector3, up: Vector3): void {
    const shift = middle.clone().sub(this.#followedMiddle ?? this.#middleAtRest());
    shift.addScaledVector(up, -shift.dot(up));
    this.#followedMiddle = middle;
    this.camera.position.add(shift);
    this.target.add(shift);
    const cell = Number(this.#floor.children[0]?.userData["cell"] ?? 0);
    if (!(cell > 0)) return;
    const travelled = middle.clone().sub(this.#middleAtRest());
    travelled.addScaledVector(up, -travelled.dot(up));
    this.#floor.position.set(...(travelled.toArray().map((part) => Math.round(part / cell) * cell) as [number, number, number]));
  }

  #middleAtRest(): Vector3 {
    return extent((this.#shown?.now.spheres ?? []).map(({ centre_m: centre }) => new Vector3(...centre))).middle;
  }

  /** Turns the camera to a part of the model, from a direction. */
  look(at: ViewTarget, from: ViewDirection): void {
    const scene = this.#scene;
    if (!scene) return;
    const spheres = scene.spheres.filter(({ side }) => at === "feet" || at === "body" || side === at || side === null);
    const points = spheres.map(({ centre_m: [x, y, z] }) => new Vector3(x, y, z));
    if (at === "body" || points.length === 0) points.push(...scene.bodies.map(({ frame }) => new Vector3(...frame[3])));
    const largest = Math.max(0, ...spheres.map(({ radius_m: radius }) => radius));
    const around = extent(points);
    const [middle, reach] = [around.middle, Math.max(around.reach, 0.001) + 1.5 * largest];
    const [forward, up, right] = scene.axes.map((axis) => new Vector3(...axis)) as [Vector3, Vector3, Vector3];
    this.target.copy(middle).addScaledVector(up, this.#restLift + (at === "body" ? 0 : 0.25 * reach));
    const direction = {
      side: right.clone().addScaledVector(up, 0.06), top: up.clone().addScaledVector(forward, -0.001),
      front: forward.clone().addScaledVector(up, 0.06), corner: right.clone().addScaledVector(forward, 0.8).addScaledVector(up, 0.45),
    }[from].normalize();
    const half = this.#visibleHalf(at === "body" || from === "top" ? 1 : FEET_ASPECT_RATIO);
    this.camera.up.copy(from === "top" ? forward : up);
    this.camera.position.copy(this.target).addScaledVector(direction, (1.15 * reach) / half);
    this.camera.near = reach / 50;
    this.camera.far = 400 * reach;
    this.camera.lookAt(this.target);
    this.camera.updateProjectionMatrix();
    this.render();
  }

  /** The path of the sphere at a place of the picture, in shares of its width and height. */
  sphereAt(x: number, y: number): string | undefined {
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2(2 * x - 1, 1 - 2 * y), this.camera);
    const [hit] = ray.intersectObjects([...this.#balls.values()], false);
    return [...this.#balls].find(([, ball]) => ball === hit?.object)?.[0];
  }

  resize(width: number, height: number): void {
    if (width === 0 || height === 0) return;
    this.#renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.render();
  }

  /** Reads the colours of the page again, after its colour scheme has changed. */
  recolour(): void {
    this.#colours = readColours(this.canvas);
    this.#materials = materials(this.#colours);
    const model = this.#shown;
    this.#shown = undefined;
    if (model) this.show(model);
  }

  /** Draws once before the next frame of the screen, however often it is called. */
  render(): void {
    if (this.#drawRequested) return;
    this.#drawRequested = true;
    requestAnimationFrame(() => {
      this.#drawRequested = false;
      this.#draw(MOVING_PIXEL_RATIO);
      clearTimeout(this.#fineTimer);
      if (this.#slow) this.#fineTimer = setTimeout(() => this.#draw(RESTING_PIXEL_RATIO), REST_MS);
      this.canvas.dataset["drawn"] = String(Number(this.canvas.dataset["drawn"] ?? 0) + 1);
    });
  }

  /** Draws; without a graphics card, with this pixel ratio. */
  #draw(ratio: number): void {
    if (this.#slow && this.#renderer.getPixelRatio() !== ratio) this.#renderer.setPixelRatio(ratio);
    this.#sun.position.copy(this.camera.position).sub(this.target).addScaledVector(this.camera.up, this.camera.position.length());
    this.#renderer.render(this.#world, this.camera);
  }

  #oldRestLift(): number {
    const { now, standing } = this.#shown ?? {};
    return (now && standing && liftToRest(now)) || 0;
  }

  #rebuildBodies(): void {
    for (const group of this.#bodyGroups.values()) clearGroup(group).removeFromParent();
    this.#bodyGroups.clear();
    const scene = this.#scene;
    if (!scene) return;
    for (const { name, frame: [x, y, z, origin] } of scene.bodies) {
      const group = new Group();
      group.matrix.copy(new Matrix4().makeBasis(new Vector3(...x), new Vector3(...y), new Vector3(...z)).setPosition(...origin));
      group.matrixAutoUpdate = false;
      group.userData["rest"] = group.matrix.clone();
      this.#bodyGroups.set(name, group);
      this.#body.add(group);
    }
    const surfaces = this.#bones?.surfaces ?? [];
    for (const { body, points, triangles } of surfaces) this.#bodyGroups.get(body)?.add(boneMesh(points, triangles, this.#materials.bone));
    this.#addLimbs(scene, new Set(surfaces.map(({ body }) => body)));
  }

  /** Adds a capsule to each body without bones, and a wedge to each foot without bones. */
  #addLimbs(scene: Scene, withBones: ReadonlySet<string>): void {
    const joints = scene.lines.flatMap(({ body, from_m: from, to_m: to }) => {
      const rest = this.#bodyGroups.get(body)?.matrix;
      return rest ? [from, to].map((end) => new Vector3(...end).applyMatrix4(rest)) : [];
    });
    const inWedge = new Set<string>();
    let [wedges, capsules] = [0, 0];
    for (const foot of spheresOfFeet(scene.spheres)) {
      const [group, bodies] = [this.#bodyGroups.get(foot[0]?.body ?? ""), foot.map(({ body }) => body)];
      // A single ball is no foot.
      if (!group || foot.length < 2 || bodies.some((body) => withBones.has(body))) continue;
      const wedge = new Mesh(footWedge(foot, joints, scene.axes), this.#materials.foot);
      wedge.geometry.applyMatrix4(group.matrix.clone().invert());
      group.add(wedge);
      wedges += 1;
      for (const body of bodies) inWedge.add(body);
    }
    const thickest = 0.06 * bodyHeight(scene);
    for (const { body, from_m: from, to_m: to } of scene.lines) {
      if (withBones.has(body) || inWedge.has(body)) continue;
      this.#bodyGroups.get(body)?.add(limb(from, to, thickest, this.#materials.bone));
      capsules += 1;
    }
    // For tests: what is drawn is not in the page's text.
    this.canvas.dataset["shapes"] = `${withBones.size} bones, ${wedges} wedges, ${capsules} capsules`;
  }

  #showSpheres({ now, after, standing }: ShownModel): void {
    const current = after ?? now;
    this.#restLift = standing ? (liftToRest(current) ?? 0) : 0;
    const paths = new Set(current.spheres.map(({ path }) => path));
    for (const [path, ball] of this.#balls) {
      if (paths.has(path)) continue;
      ball.removeFromParent();
      this.#balls.delete(path);
    }
    for (const sphere of current.spheres) this.#ball(sphere);
    this.#showArrows(current);
    clearGroup(this.#oldSpheres);
    const shownByPath = new Map(current.spheres.map((sphere) => [sphere.path, sphere]));
    for (const sphere of after ? now.spheres : []) {
      const next = shownByPath.get(sphere.path);
      if (next && isSameSphere(next, sphere)) continue;
      const ring = new LineSegments(RINGS, this.#materials.old);
      ring.renderOrder = 1;
      placeSphere(ring, sphere);
      this.#oldSpheres.add(ring);
    }
  }

  #ball(sphere: PlacedSphere): void {
    const ball = this.#balls.get(sphere.path) ?? new Mesh(BALL, this.#materials.ball);
    ball.material = this.#materials.ball;
    placeSphere(ball, sphere);
    this.#balls.set(sphere.path, ball);
    this.#body.add(ball);
  }

  #showArrows(scene: Scene): void {
    const paths = new Set(scene.spheres.map(({ path }) => path));
    for (const [path, arrow] of this.#arrows) {
      if (paths.has(path)) continue;
      arrow.removeFromParent();
      arrow.dispose();
      this.#arrows.delete(path);
    }
    const most = Math.max(0, ...scene.spheres.map(({ force_bw: force }) => force ?? 0));
    const up = new Vector3(...scene.axes[1]);
    const { middle, reach } = extent(scene.spheres.map(({ centre_m: centre }) => new Vector3(...centre)));
    for (const { path, centre_m: centre, radius_m: radius, force_bw: force } of scene.spheres) {
      const arrow = this.#arrows.get(path) ?? new ArrowHelper(up, middle, 1, this.#colours.force);
      const length = most > 0 ? (LONGEST_ARROW * (reach + radius) * (force ?? 0)) / most : 0;
      arrow.userData["carries"] = length > 0.01 * reach;
      arrow.visible = this.#forces && length > 0.01 * reach;
      arrow.setDirection(up);
      arrow.setColor(this.#colours.force);
      arrow.position.set(...centre).addScaledVector(up, radius);
      if (length > 0) arrow.setLength(length, 0.25 * length, 0.12 * length);
      this.#arrows.set(path, arrow);
      this.#body.add(arrow);
    }
  }

  #showFloor(scene: Scene): void {
    clearGroup(this.#floor);
    delete this.canvas.dataset["floor"];
    const height = floorHeight(scene);
    if (height === undefined) return;
    const up = new Vector3(...scene.axes[1]);
    const { middle, reach } = extent(scene.spheres.map(({ centre_m: centre }) => new Vector3(...centre)));
    const size = 8 * Math.max(0.01, reach, ...scene.spheres.map(({ radius_m: radius }) => radius));
    const floor = grid(size, this.#colours.floor);
    floor.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), up);
    floor.position.copy(middle).addScaledVector(up, height - middle.dot(up));
    floor.userData["cell"] = size / FLOOR_CELLS;
    this.#floor.add(floor);
    this.canvas.dataset["floor"] = String(size);
  }
}

/** The middle of points, and the distance of the farthest point from it. */
function extent(points: readonly Vector3[]): { middle: Vector3; reach: number } {
  const middle = new Vector3();
  for (const point of points) middle.addScaledVector(point, 1 / points.length);
  return { middle, reach: Math.max(0, ...points.map((point) => point.distanceTo(middle))) };
}

/** The grid of a level floor. */
function grid(size: number, colour: string): GridHelper {
  const floor = new GridHelper(size, FLOOR_CELLS, colour, colour);
  floor.material.transparent = true;
  floor.material.opacity = 0.45;
  return floor;
}

/** What draws: without a graphics card the processor, for which smooth edges are too slow. */
type Drawer = "card" | "processor";

/** What draws in this browser; undefined if it has no WebGL. */
export function findDrawer(): Drawer | undefined {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) return undefined;
  const names = gl.getExtension("WEBGL_debug_renderer_info");
  const name: unknown = names ? gl.getParameter(names.UNMASKED_RENDERER_WEBGL) : "";
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return typeof name === "string" && /swiftshader|llvmpipe|software/i.test(name) ? "processor" : "card";
}

/** Moves a body to the pose that begins at the index `start` of `poses`. */
function placeBody(group: Group, poses: readonly number[], start: number): void {
  const axis = (from: number) => new Vector3(...[0, 1, 2].map((part) => (poses[start + from + part] ?? 0) / POINTS_PER_M));
  group.matrix.makeBasis(axis(0), axis(3), axis(6)).setPosition(axis(9));
  group.matrixWorldNeedsUpdate = true;
}

/** The height from the lowest body to the highest, m. */
function bodyHeight({ bodies, axes: [, up] }: Scene): number {
  const heights = bodies.map(({ frame }) => new Vector3(...frame[3]).dot(new Vector3(...up)));
  return Math.max(0.01, Math.max(...heights) - Math.min(...heights));
}

function placeSphere(object: Object3D, { centre_m: centre, radius_m: radius }: PlacedSphere): void {
  object.position.set(...centre);
  object.scale.setScalar(radius);
}

function isSameSphere(one: PlacedSphere, other: PlacedSphere): boolean {
  return one.radius_m === other.radius_m && one.centre_m.every((value, index) => value === other.centre_m[index]);
}

/** Removes all objects from a group and frees their memory. */
function clearGroup(group: Group): Group {
  for (const child of [...group.children]) {
    group.remove(child);
    if (child instanceof Mesh && child.geometry !== BALL) child.geometry.dispose();
    if (child instanceof LineSegments && child.geometry !== RINGS) child.geometry.dispose();
    if (child instanceof GridHelper) child.material.dispose();
  }
  return group;
}

function boneMesh(points: readonly number[], triangles: readonly number[], material: MeshLambertMaterial): Mesh {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from(points, (value) => value / POINTS_PER_M), 3));
  geometry.setIndex(new BufferAttribute(Uint32Array.from(triangles), 1));
  geometry.computeVertexNormals();
  return new Mesh(geometry, material);
}

/** Three circles, one in each plane, as the outline of a sphere. */
function rings(): BufferGeometry {
  const COUNT = 48;
  const points: Vector3[] = [];
  for (const turn of [(a: number, b: number) => new Vector3(a, b, 0), (a: number, b: number) => new Vector3(a, 0, b), (a: number, b: number) => new Vector3(0, a, b)]) {
    for (let step = 0; step < COUNT; step += 1) {
      for (const end of [step, step + 1]) {
        const angle = (end / COUNT) * 2 * Math.PI;
        points.push(turn(Math.cos(angle), Math.sin(angle)));
      }
    }
  }
  return new BufferGeometry().setFromPoints(points);
}
