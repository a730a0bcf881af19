// Turns, moves and zooms the view by mouse, touch and keys.

import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

import type { Stage } from "./model_3d";

const TURN_OF_KEY = Math.PI / 24;
const ZOOM_OF_KEY = 1.15;

export function addControls(stage: Stage): OrbitControls {
  const { canvas } = stage;
  const controls = new OrbitControls(stage.camera, canvas);
  controls.target = stage.target;
  controls.addEventListener("change", () => stage.render());
  // The wheel scrolls the page until the view has the focus.
  controls.enableZoom = false;
  const enableWheel = (awake: boolean) => (controls.enableZoom = awake);
  canvas.addEventListener("focus", () => enableWheel(true));
  canvas.addEventListener("blur", () => enableWheel(false));
  canvas.addEventListener("pointerdown", () => canvas.focus({ preventScroll: true }));
  canvas.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (!applyKey(event.key, event.shiftKey, stage)) return;
    event.preventDefault();
    stage.camera.lookAt(stage.target);
    controls.update();
    stage.render();
  });
  return controls;
}

/** Moves the camera for a key; returns whether the key has a function. */
function applyKey(key: string, shift: boolean, { camera, target }: Stage): boolean {
  const from = camera.position.clone().sub(target);
  const right = from.clone().cross(camera.up).normalize();
  const turns: Readonly<Record<string, [typeof right, number]>> = {
    ArrowLeft: [camera.up, -TURN_OF_KEY], ArrowRight: [camera.up, TURN_OF_KEY], ArrowUp: [right, TURN_OF_KEY], ArrowDown: [right, -TURN_OF_KEY],
  };
  const turn = turns[key];
  if (turn && shift) {
    const direction = { ArrowLeft: right, ArrowRight: right.clone().negate(), ArrowUp: camera.up.clone().negate(), ArrowDown: camera.up.clone() }[key];
    if (!direction) return false;
    const shift = direction.multiplyScalar(-0.05 * from.length());
    camera.position.add(shift);
    target.add(shift);
    return true;
  }
  if (turn) {
    const turned = from.clone().applyAxisAngle(...turn);
    // The camera stops before the top, where up and down would swap.
    if (Math.abs(turned.clone().normalize().dot(camera.up)) < 0.995) camera.position.copy(target).add(turned);
    return true;
  }
  const zoom = key === "+" || key === "=" ? 1 / ZOOM_OF_KEY : key === "-" ? ZOOM_OF_KEY : undefined;
  if (zoom === undefined) return false;
  camera.position.copy(target).addScaledVector(from, zoom);
  return true;
}
