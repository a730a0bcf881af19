// Corrects a recording by the least that makes contacts and force plates agree: a button, the verdict, and the files to download.

import { save } from "../download/save";
import { button, el, setText } from "../dom/element";
import { toFailure } from "../engine/failure";
import type { CorrectedMotion, PlayedMotion } from "../engine/space";
import type { Session } from "../state/session";
import { choices } from "./choices";
import { sentence } from "./failure";

const ABOUT = "Does a small correction of the motion make the contacts give the forces of the plates?";
const SIGNS: Readonly<Record<CorrectedMotion["verdict"], string>> = { agree: "good", "large-correction": "remark", disagree: "warning" };

export type MotionRequest = Readonly<Record<string, unknown>> & { verb: string; motion: string };

export class CorrectionView {
  readonly element = el("div", { class: "correction", hidden: true });
  readonly #start = button("Correct the motion", () => void this.#correct(), { class: "small" });
  readonly #outcome = el("div", { role: "status" });
  readonly #failure = el("p", { class: "problem", role: "alert" });
  #request: MotionRequest | undefined;

  /** `onCorrected` is called with each new correction, and whenever the user chooses which motion is shown. */
  constructor(readonly session: Session, readonly onCorrected: (played: PlayedMotion | undefined, isShown: boolean) => void) {
    this.element.append(el("p", { class: "bar" }, el("span", {}, ABOUT), this.#start), this.#failure, this.#outcome);
  }

  /** Offers to correct another recording; undefined if there is none with force plates. */
  offer(request: MotionRequest | undefined): void {
    this.#request = request;
    this.element.hidden = !request;
    this.#start.disabled = false;
    setText(this.#failure, "");
    this.#outcome.replaceChildren();
  }

  async #correct(): Promise<void> {
    const { session } = this;
    const recorded = this.#request;
    if (!recorded) return;
    this.#start.disabled = true;
    const request = { ...recorded, correct: this.#nameOfCorrected(recorded.motion) };
    try {
      const [corrected, { command }] = await Promise.all([session.engine.correct(request), session.engine.spell(request)]);
      if (recorded === this.#request) this.#show(corrected, command);
    } catch (error) {
      if (recorded !== this.#request) return;
      this.#start.disabled = false;
      setText(this.#failure, sentence(toFailure(error).message));
    }
  }

  #show({ verdict, why, remarks, files, played }: CorrectedMotion, command: string): void {
    const names = files.map(([name]) => name).join(" and ");
    const download = button(`Download ${names}`, () => {
      for (const [name, text] of files) save(name, text, name.endsWith(".xml") ? "application/xml" : "text/plain");
      this.session.announce(`Downloaded ${names}.`);
    }, { class: "primary" });
    const which = choices("Shown motion", [["recorded", "As recorded"], ["corrected", "Corrected"]], "corrected", (one) => this.onCorrected(played ?? undefined, one === "corrected"));
    const offers = played ? [el("div", { class: "bar" }, which, download), el("p", { class: "quiet" }, "In a terminal: ", el("code", {}, command))] : [];
    this.#outcome.replaceChildren(
      el("p", {}, el("span", { class: `tag ${SIGNS[verdict]}` }, verdict.replace("-", " ")), " ", sentence(why)), ...offers,
      el("ul", { class: "recording-words" }, ...remarks.map((remark) => el("li", {}, sentence(remark)))));
    if (played) this.onCorrected(played, true);
  }

  /** A name for the corrected motion that no open file has. */
  #nameOfCorrected(motion: string): string {
    const names = new Set(this.session.files.value.map(({ name }) => name));
    const stem = `${motion.replace(/\.[^./]*$/, "")}.corrected`;
    let [name, count] = [`${stem}.sto`, 1];
    while (names.has(name)) name = `${stem}-${(count += 1)}.sto`;
    return name;
  }
}
