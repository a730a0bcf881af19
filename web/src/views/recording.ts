// Plays a recorded motion of the model, with the forces of its contacts and of force plates.

import { el, setText } from "../dom/element";
import { toFailure } from "../engine/failure";
import { dot, type PlayedMotion, type PlayedForce, type Vector } from "../engine/space";
import type { FileKind } from "../files/kinds";
import { QUESTIONS } from "../forms/all";
import { answersFor } from "../state/answers";
import { currentFile, isBare } from "../state/model";
import type { Session } from "../state/session";
import { CorrectionView, type MotionRequest } from "./correction";
import { type Curve, Curves } from "./curves";
import { sentence } from "./failure";
import { Player } from "./player";

/** Answers about the model that are also fields of a recording. */
const ANSWERS_FOR_MOTION = ["mass", "contacts_mass", "exclude_body", "select", "exclude", "geometry", "model"];
const FILES_OF_RECORDING: readonly [field: "motion" | "plates" | "loads", label: string][] = [
  ["motion", "Recorded motion"], ["plates", "Force plates"], ["loads", "External loads"],
];
const NUMBERS_OF_RECORDING: readonly [field: string, label: string][] = [
  ["low_pass", "Cutoff of the low-pass filter (Hz)"], ["plates_delay", "Delay of the force plates (s)"],
];
/** The motion is shown slower by this factor. */
const SLOW_MOTION_FACTOR = 2;

/** Shows a moment of a recording; without a recording, the model at rest. */
type Shows = (played: PlayedMotion | undefined, moment: number) => void;

export class RecordingView {
  readonly element = el("div", { class: "recording", hidden: true });
  readonly #player = new Player({ play: "Play the motion", time: "Time of the motion", id: "play-motion" }, (moment) => this.#showMoment(moment));
  readonly #selects = new Map(FILES_OF_RECORDING.map(([field, label]) => [field, el("select", { "aria-label": label })] as const));
  readonly #numbers = new Map(NUMBERS_OF_RECORDING.map(([field, label]) => [field, el("input", { type: "text", inputmode: "decimal", autocomplete: "off", "aria-label": label })] as const));
  readonly #plots = el("div", { class: "recording-plots" });
  readonly #words = el("ul", { class: "recording-words" });
  readonly #lacks = el("p", { class: "quiet" });
  readonly #failure = el("p", { class: "problem", role: "alert" });
  #curves: Curves[] = [];
  #played: PlayedMotion | undefined;
  /** The corrected motion, if there is one, and whether it is shown. */
  #corrected: PlayedMotion | undefined;
  #showsCorrected = false;
  #moment = 0;
  #requestKey = "";
  readonly #correction: CorrectionView;

  constructor(readonly session: Session, readonly onMoment: Shows, readonly up: () => Vector) {
    const labelled = (label: string, control: Node | undefined) => el("label", {}, el("span", {}, label), control ?? "");
    const files = FILES_OF_RECORDING.map(([field, label]) => labelled(label, this.#selects.get(field)));
    const numbers = NUMBERS_OF_RECORDING.map(([field, label]) => labelled(label, this.#numbers.get(field)));
    this.#correction = new CorrectionView(session, (played, isShown) => this.#showCorrected(played, isShown));
    this.element.append(
      el("h3", {}, "Along a recording"), el("div", { class: "recording-files" }, ...files),
      el("details", { class: "more" }, el("summary", {}, "Filter and delay"), el("div", { class: "recording-files" }, ...numbers)),
      this.#lacks, this.#failure, this.#player.element, this.#correction.element, this.#plots, this.#words);
    for (const control of [...this.#selects.values(), ...this.#numbers.values()]) control.addEventListener("change", () => void this.#load());
    session.files.watch(() => this.#updateChoices());
    session.chosen.watch(() => this.#updateChoices());
    session.models.watch(() => void this.#load());
  }

  stop(): void {
    this.#player.stop();
  }

  /** Lists the open files of each kind; a single file is chosen. */
  #updateChoices(): void {
    for (const [field, select] of this.#selects) {
      const names = this.session.files.value.filter(({ kind }) => kind === (field satisfies FileKind)).map(({ name }) => name);
      if (names.join("\n") === [...select.options].slice(1).map(({ value }) => value).join("\n")) continue;
      const before = select.value;
      select.replaceChildren(el("option", { value: "" }, names.length === 0 ? "none is open" : "none"), ...names.map((name) => el("option", { value: name }, name)));
      select.value = names.includes(before) ? before : names.length === 1 ? (names[0] ?? "") : "";
    }
    void this.#load();
  }

  #file(field: "motion" | "plates" | "loads"): string {
    return this.#selects.get(field)?.value ?? "";
  }

  async #load(): Promise<void> {
    const model = this.session.model();
    const any = this.session.files.value.some(({ kind }) => this.#selects.has(kind as "motion"));
    this.element.hidden = !model?.inspected || !any;
    if (!model?.inspected || !any) return;
    const chosen = Object.fromEntries(FILES_OF_RECORDING.map(([field]) => [field, this.#file(field)]).filter(([, name]) => name !== ""));
    // External loads describe the columns of the plates, so that they are useless alone.
    if (!("plates" in chosen)) delete chosen["loads"];
    const numbers = [...this.#numbers].filter(([, { value }]) => value.trim() !== "").map(([field, { value }]) => [field, Number(value.replace(",", "."))]);
    const answers = Object.entries(answersFor(model, QUESTIONS)).filter(([name]) => ANSWERS_FOR_MOTION.includes(name));
    const request = { ...Object.fromEntries(answers), ...Object.fromEntries(numbers), ...chosen, verb: "motion", subject: currentFile(model) };
    const key = JSON.stringify(request);
    if (key === this.#requestKey) return;
    this.#requestKey = key;
    this.#correction.offer(undefined);
    setText(this.#lacks, !("motion" in chosen) ? "Open the recorded motion, too." : isBare(model.inspected) ? "To play the motion, first give the model contacts, and keep them." : "");
    if (!("motion" in chosen) || isBare(model.inspected)) return this.#show(undefined);
    try {
      const played = await this.session.engine.play(request);
      if (key !== this.#requestKey) return;
      this.#show(played);
      if ("plates" in request) this.#correction.offer(request as MotionRequest);
    } catch (error) {
      if (key === this.#requestKey) this.#show(undefined, sentence(toFailure(error).message));
    }
  }

  #show(played: PlayedMotion | undefined, failure = ""): void {
    [this.#played, this.#corrected, this.#showsCorrected, this.#moment] = [played, undefined, false, 0];
    setText(this.#failure, failure);
    const { time_s: times = [] } = played ?? {};
    this.#player.reset(times.length, ((times[times.length - 1] ?? 0) - (times[0] ?? 0)) * SLOW_MOTION_FACTOR);
    this.#showWords(played);
    this.#drawCurves();
    this.onMoment(undefined, 0);
  }

  #showCorrected(corrected: PlayedMotion | undefined, isShown: boolean): void {
    const isNew = corrected !== this.#corrected;
    [this.#corrected, this.#showsCorrected] = [corrected, isShown];
    if (isNew) this.#drawCurves();
    this.#showWords(isShown ? corrected : this.#played);
    this.#showMoment(this.#moment);
  }

  #showWords(played: PlayedMotion | undefined): void {
    this.#words.replaceChildren(...(played?.remarks ?? []).map((remark) => el("li", {}, sentence(remark))));
  }

  #drawCurves(): void {
    const { time_s: times = [], feet = [] } = this.#played ?? {};
    const upward = ({ forces_bw: forces }: PlayedForce) => forces.map((force) => force && dot(force, this.up()));
    this.#curves = feet.map(({ name, model, plates }, index) => {
      const curves = new Curves(110);
      const after = this.#corrected?.feet[index]?.model;
      const all: (false | null | undefined | { kind: Curve["kind"]; of: PlayedForce })[] = [
        plates && { kind: "old", of: plates }, { kind: after ? "before" : "new", of: model }, after && { kind: "new", of: after },
      ];
      const kinds = `${plates ? ", plates dashed" : ""}${after ? ", recorded thin" : ""}`;
      const about = `${name}: upward force in body weights${kinds}; as text below`;
      const drawn = all.flatMap((curve) => (curve ? [{ kind: curve.kind, values: upward(curve.of) }] : []));
      curves.show(drawn, `${name}${kinds}`, about, times[0] ?? 0, times[times.length - 1] ?? 0);
      return curves;
    });
    const unit = el("p", { class: "quiet stage-remark" }, feet.length > 0 ? "Upward force on each foot, in body weights:" : "");
    this.#plots.replaceChildren(unit, ...this.#curves.map(({ element }) => element));
  }

  #showMoment(moment: number): void {
    this.#moment = moment;
    this.onMoment(this.#showsCorrected ? this.#corrected : this.#played, moment);
    for (const curves of this.#curves) curves.moveCursor(moment);
  }
}
