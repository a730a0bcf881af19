// A recorded motion: the model along it, with the forces of its contacts beside those of force plates.

import { el, setText } from "../dom/element";
import { failureOf } from "../engine/failure";
import { dot, type Played, type PlayedForce, type Vector } from "../engine/space";
import type { FileKind } from "../files/kinds";
import { QUESTIONS } from "../forms/all";
import { answered } from "../state/answers";
import { fileOf } from "../state/model";
import type { Session } from "../state/session";
import { Curves } from "./curves";
import { sentence } from "./failure";
import { Player } from "./player";

/** Answers about the model that a recording takes, too. */
const ANSWERS = ["mass", "contacts_mass", "exclude_body", "select", "exclude", "geometry", "model"];
const FILES: readonly [field: "motion" | "plates" | "loads", label: string][] = [
  ["motion", "Recorded motion"], ["plates", "Force plates"], ["loads", "External loads"],
];
/** So much slower than it is. */
const SLOWER = 2;

/** Shows a moment of a recording; without one, the model as it stands. */
type Shows = (played: Played | undefined, moment: number) => void;

export class RecordingView {
  readonly element = el("div", { class: "recording", hidden: true });
  readonly #player = new Player({ play: "Play the motion", time: "Time of the motion", id: "play-motion" }, (moment) => this.#at(moment));
  readonly #selects = new Map(FILES.map(([field, label]) => [field, el("select", { "aria-label": label })] as const));
  readonly #plots = el("div", { class: "recording-plots" });
  readonly #words = el("ul", { class: "recording-words" });
  readonly #failure = el("p", { class: "problem", role: "alert" });
  #curves: Curves[] = [];
  #played: Played | undefined;
  #asked = "";

  constructor(readonly session: Session, readonly shows: Shows, readonly up: () => Vector) {
    const labels = FILES.map(([field, label]) => el("label", {}, el("span", {}, label), this.#selects.get(field) ?? ""));
    this.element.append(
      el("h3", {}, "Along a recording"), el("div", { class: "recording-files" }, ...labels), this.#failure, this.#player.element, this.#plots, this.#words);
    for (const select of this.#selects.values()) select.addEventListener("change", () => void this.#ask());
    session.files.watch(() => this.#offer());
    session.chosen.watch(() => this.#offer());
    session.models.watch(() => void this.#ask());
  }

  stop(): void {
    this.#player.stop();
  }

  /** Offers what is here; what is here alone is chosen. */
  #offer(): void {
    for (const [field, select] of this.#selects) {
      const names = this.session.files.value.filter(({ kind }) => kind === (field satisfies FileKind)).map(({ name }) => name);
      if (names.join("\n") === [...select.options].slice(1).map(({ value }) => value).join("\n")) continue;
      const before = select.value;
      select.replaceChildren(el("option", { value: "" }, names.length === 0 ? "none is open" : "none"), ...names.map((name) => el("option", { value: name }, name)));
      select.value = names.includes(before) ? before : names.length === 1 ? (names[0] ?? "") : "";
    }
    void this.#ask();
  }

  #file(field: "motion" | "plates" | "loads"): string {
    return this.#selects.get(field)?.value ?? "";
  }

  async #ask(): Promise<void> {
    const model = this.session.model();
    const motions = this.session.files.value.some(({ kind }) => kind === "motion");
    this.element.hidden = !model?.inspected || !motions;
    if (!model?.inspected || !motions) return;
    const chosen = Object.fromEntries(FILES.map(([field]) => [field, this.#file(field)]).filter(([, name]) => name !== ""));
    // Loads say what columns of the plates are.
    if (!("plates" in chosen)) delete chosen["loads"];
    const known = Object.entries(answered(model, QUESTIONS)).filter(([name]) => ANSWERS.includes(name));
    const request = { ...Object.fromEntries(known), ...chosen, verb: "motion", subject: fileOf(model) };
    const key = JSON.stringify(request);
    if (key === this.#asked) return;
    this.#asked = key;
    if (!("motion" in request)) return this.#show(undefined);
    try {
      const played = await this.session.engine.play(request);
      if (key === this.#asked) this.#show(played);
    } catch (error) {
      if (key === this.#asked) this.#show(undefined, sentence(failureOf(error).message));
    }
  }

  #show(played: Played | undefined, failure = ""): void {
    this.#played = played;
    setText(this.#failure, failure);
    const times = played?.time_s ?? [];
    const [start, end] = [times[0] ?? 0, times[times.length - 1] ?? 0];
    this.#player.reset(times.length, (end - start) * SLOWER);
    this.#words.replaceChildren(...(played?.remarks ?? []).map((remark) => el("li", {}, sentence(remark))));
    const along = ({ forces_bw: forces }: PlayedForce) => forces.map((force) => force && dot(force, this.up()));
    const feet = played?.feet ?? [];
    this.#curves = feet.map(({ name, model, plates }) => {
      const curves = new Curves(110);
      const measured = plates ? [{ kind: "old" as const, values: along(plates) }] : [];
      const title = `${name}: upward force in body weights${plates ? ", plates dashed" : ""}`;
      curves.show([...measured, { kind: "new" as const, values: along(model) }], title, `${title}; in words below`, start, end);
      return curves;
    });
    this.#plots.replaceChildren(...this.#curves.map(({ element }) => element));
    this.shows(undefined, 0);
  }

  #at(moment: number): void {
    this.shows(this.#played, moment);
    for (const curves of this.#curves) curves.at(moment);
  }
}
