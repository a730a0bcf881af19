// Shows the body in three dimensions before and after the change, updated with every step of a slider.

import { byId, el, setAttribute, setText } from "../dom/element";
import { counted, digits } from "../dom/number";
import type { Bones, PlacedSphere, Scene } from "../engine/space";
import { QUESTIONS } from "../forms/all";
import { addControls } from "../stage/controls";
import { lowestGap } from "../stage/rest";
import { type ViewDirection, type ViewTarget, findDrawer, Stage } from "../stage/model_3d";
import { answersFor } from "../state/answers";
import { currentFile, type OpenModel } from "../state/model";
import type { Session } from "../state/session";
import { choices } from "./choices";
import { FallView } from "./fall";
import { RecordingView } from "./recording";

const TARGETS: readonly [ViewTarget, string][] = [["feet", "Feet"], ["right", "Right"], ["left", "Left"], ["body", "Whole body"]];
const DIRECTIONS: readonly [ViewDirection, string][] = [["corner", "Corner"], ["side", "Side"], ["front", "Front"], ["top", "Top"]];
/** Most missing meshes that are named. */
const MOST_MESHES_NAMED = 4;
/** A pointer that moves further than this drags. */
const MOST_CLICK_PIXELS = 4;
const KEYS_HELP = "Click a sphere to read its numbers. Drag to turn, drag with the right button to move; click, then turn the wheel to zoom. Keys: arrows turn, Shift and arrows move, + and − zoom.";

export class StageView {
  readonly #section = byId("stage");
  readonly #canvas = el("canvas", { id: "stage-canvas", tabindex: 0, role: "img", "aria-describedby": "stage-keys" });
  readonly #words = el("div", { class: "stage-words" });
  readonly #inWords = el("details", { class: "section" });
  readonly #remark = el("p", { class: "quiet stage-remark" });
  readonly #meshes = el("p", { class: "quiet stage-remark" });
  /** The numbers of the sphere that was clicked. */
  readonly #clicked = el("p", { class: "stage-clicked", role: "status" });
  readonly #stage: Stage | undefined;
  readonly #fall: FallView;
  readonly #recording: RecordingView;
  #target: ViewTarget = "feet";
  #direction: ViewDirection = "corner";
  #standing = true;
  /** The id of the model that is shown, and the files that its bones come from. */
  #model: number | undefined;
  #bonesKey = "";
  #now: Scene | undefined;
  #after: Scene | undefined;

  constructor(readonly session: Session) {
    this.#stage = createStage(this.#canvas);
    this.#fall = new FallView((body, old, moves) => {
      this.#recording.stop();
      this.#stage?.unpose();
      this.#stage?.showForces(!moves);
      this.#stage?.lift(body, old);
    });
    this.#recording = new RecordingView(session, (played, moment) => {
      if (played) this.#stage?.pose(played, moment);
      else this.#stage?.unpose();
    }, () => this.#now?.axes[1] ?? [0, 1, 0]);
    const frame = el("div", { class: "stage-frame" }, this.#canvas, this.#clicked);
    const bars = [
      choices("Show", TARGETS, this.#target, (looked) => this.#setView(looked, this.#direction)),
      choices("From", DIRECTIONS, this.#direction, (from) => this.#setView(this.#target, from)),
      choices("Pose", [["standing", "Standing"], ["default", "Default pose"]], "standing", (pose) => this.#setStanding(pose === "standing")),
    ];
    const words = this.#inWords;
    words.append(el("summary", {}, "The same as text"), this.#words);
    words.addEventListener("toggle", () => this.#show());
    this.#section.append(el("h2", { id: "stage-title", class: "hidden" }, "The body"));
    if (this.#stage) {
      addControls(this.#stage);
      this.#wireClicks(this.#stage);
      new ResizeObserver(() => this.#stage?.resize(frame.clientWidth, frame.clientHeight)).observe(frame);
      matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.#stage?.recolour());
      this.#section.append(el("div", { class: "stage-bar" }, ...bars), frame, el("p", { class: "hidden", id: "stage-keys" }, KEYS_HELP));
    }
    this.#section.append(this.#remark, this.#meshes, this.#recording.element, this.#fall.element, words);
    // The canvas has the colours of the page only after it was added.
    this.#stage?.recolour();
    session.models.watch(() => this.#update());
    session.chosen.watch(() => this.#update());
    session.files.watch(() => void this.#fetchBones());
    session.preview.watch(() => this.#update());
    new IntersectionObserver(([entry]) => {
      if (entry?.isIntersecting) session.visible.add("scene");
      else session.visible.delete("scene");
    }).observe(this.#section);
  }

  /** Whether the browser can show it; otherwise the page shows drawings of the feet. */
  get works(): boolean {
    return this.#stage !== undefined;
  }

  /** Draws once, so that the first picture is quick. */
  warmUp(): void {
    this.#stage?.warmUp();
  }

  #update(): void {
    const model = this.session.model();
    const now = model?.inspected?.scene ?? undefined;
    this.#section.hidden = !now;
    if (!model || !now) return;
    const { value: preview } = this.session.preview;
    const done = preview.state === "done" && preview.request.models?.[0] === currentFile(model) ? preview.change : undefined;
    // If a step of a slider did not request the scene, the old one stays.
    const after = preview.state === "done" && !done?.scene && !done?.unchanged ? this.#after : (done?.scene ?? undefined);
    // The first spheres of a model are looked at like another model.
    const isNew = model.id !== this.#model || (now.spheres.length === 0 && !this.#after && after !== undefined);
    const changed = isNew || now !== this.#now || after !== this.#after;
    [this.#model, this.#now, this.#after] = [model.id, now, done ? after : undefined];
    if (changed) this.#show();
    if (isNew) this.#setView(this.#target, this.#direction);
    void this.#fetchBones();
    this.#showFalls(model);
  }

  #show(): void {
    const [now, after] = [this.#now, this.#after];
    if (!now) return;
    this.#recording.stop();
    this.#stage?.unpose();
    this.#stage?.show({ now, after, standing: this.#standing });
    setText(this.#clicked, "");
    setAttribute(this.#canvas, "aria-label", `${now.spheres.length} contact spheres under the body, which can be turned; as text below`);
    setText(this.#remark, poseRemark(now, this.#standing));
    if (this.#inWords.open) this.#words.replaceChildren(describeScene(now, after));
  }

  /** A click on a sphere says its numbers. A drag turns the view. */
  #wireClicks(stage: Stage): void {
    let [x, y] = [0, 0];
    this.#canvas.addEventListener("pointerdown", (event) => ([x, y] = [event.clientX, event.clientY]));
    this.#canvas.addEventListener("click", (event) => {
      if (Math.hypot(event.clientX - x, event.clientY - y) > MOST_CLICK_PIXELS) return;
      const box = this.#canvas.getBoundingClientRect();
      const path = stage.sphereAt((x - box.left) / box.width, (y - box.top) / box.height);
      const find = (scene: Scene | undefined) => scene?.spheres.find((sphere) => sphere.path === path);
      const [before, after] = [find(this.#now), find(this.#after)];
      const shown = after ?? before;
      setText(this.#clicked, shown ? describeSphere(shown, after ? before : undefined) : "");
    });
  }

  #showFalls(model: OpenModel): void {
    const { value: preview } = this.session.preview;
    const done = preview.state === "done" && preview.request.models?.[0] === currentFile(model) ? preview : undefined;
    // While a slider moves, the old fall stays.
    if (done && !done.complete && done.change.falls.length === 0) return;
    this.#fall.show(done && done.change.falls.length > 0 ? done.change.falls : (model.inspected?.falls ?? []));
  }

  #setView(looked: ViewTarget, from: ViewDirection): void {
    [this.#target, this.#direction] = [looked, from];
    this.#stage?.look(looked, from);
  }

  #setStanding(standing: boolean): void {
    this.#standing = standing;
    this.#show();
    this.#setView(this.#target, this.#direction);
  }

  /** Requests the bones if the model or the open meshes have changed. */
  async #fetchBones(): Promise<void> {
    const model = this.session.model();
    if (!this.#stage || !model?.inspected) return;
    const file = currentFile(model);
    const key = [file, ...this.session.files.value.filter(({ kind }) => kind === "mesh").map(({ name }) => name)].join("\n");
    if (key === this.#bonesKey) return;
    this.#bonesKey = key;
    const bones = await this.session.engine.bones(file, answersFor(model, QUESTIONS)).catch(() => undefined);
    if (key !== this.#bonesKey) return;
    this.#stage.setBones(bones);
    setText(this.#meshes, meshNote(bones));
  }
}

function createStage(canvas: HTMLCanvasElement): Stage | undefined {
  try {
    // Asked first, because three would log an error in the console.
    const drawer = findDrawer();
    return drawer && new Stage(canvas, drawer);
  } catch {
    return undefined;
  }
}

/** A text about missing and broken meshes. */
function meshNote(bones: Bones | undefined): string {
  const { missing = [], broken = [] } = bones ?? {};
  const names = missing.slice(0, MOST_MESHES_NAMED).join(", ");
  const more = missing.length > MOST_MESHES_NAMED ? ` and ${counted(missing.length - MOST_MESHES_NAMED, "other", "others")}` : "";
  const lacking = missing.length > 0 ? `To see its bones, open the folder Geometry, too. Not here: ${names}${more}.` : "";
  return [lacking, ...broken.map((why) => `${why}.`)].filter(Boolean).join(" ");
}

function poseRemark(scene: Scene, standing: boolean): string {
  if (scene.why_not_placed !== null) return `Some bodies are left out: ${scene.why_not_placed}.`;
  const gap = lowestGap(scene);
  if (gap === undefined || !standing || Math.abs(gap) < 5e-4) return "";
  return `Shown standing on its spheres. At the default pose of the file it is ${digits(Math.abs(gap) * 1000, 3)} mm ${gap < 0 ? "inside" : "above"} the floor.`;
}

/** The content of the view as a table, for those who do not see it. */
function describeScene(now: Scene, after: Scene | undefined): HTMLElement {
  const before = new Map(now.spheres.map((sphere) => [sphere.path, sphere]));
  const rows = (after ?? now).spheres.map((sphere) => sphereRow(sphere, after ? before.get(sphere.path) : undefined));
  const heads = ["sphere", "body", "radius (mm)", "share of body weight", "x/R at rest"].map((text) => el("th", { scope: "col" }, text));
  const caption = el("caption", {}, "Contact spheres as they are drawn, and what each carries where the body stands on all of them.");
  const table = el("table", {}, caption, el("thead", {}, el("tr", {}, ...heads)), el("tbody", {}, ...rows));
  return el("div", { class: "wide", role: "group", "aria-label": "Contact spheres as text", tabindex: 0 }, table);
}

function describeSphere(sphere: PlacedSphere, before: PlacedSphere | undefined): string {
  const { name, body, force_bw: force, relative_indentation: depth } = sphere;
  const carries = force === null ? "" : `, carries ${digits(force, 3)} of the body weight`;
  const sinks = depth === null ? "" : ` and sinks in ${digits(depth, 3)} of its radius`;
  return `${name} on ${body}: radius ${radiiText(sphere, before)} mm${carries}${sinks}`;
}

/** The radius, mm, after and before a change. */
function radiiText(sphere: PlacedSphere, before: PlacedSphere | undefined): string {
  const [radius, old] = [sphere, before ?? sphere].map(({ radius_m: metres }) => digits(metres * 1000, 3));
  return before && before.radius_m !== sphere.radius_m ? `${old} → ${radius}` : `${radius}`;
}

function sphereRow(sphere: PlacedSphere, before: PlacedSphere | undefined): HTMLElement {
  const cell = (text: string) => el("td", {}, text);
  const number = (value: number | null) => (value === null ? "–" : digits(value, 3));
  return el("tr", {}, el("th", { scope: "row" }, sphere.name), cell(sphere.body), cell(radiiText(sphere, before)), cell(number(sphere.force_bw)), cell(number(sphere.relative_indentation)));
}
