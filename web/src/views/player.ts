// Plays moments one after the other: a button, and a slider to go to a moment.

import { button, el, setAttribute, setText } from "../dom/element";

interface Texts {
  play: string;
  /** The name of the slider. */
  time: string;
  id: string;
}

export class Player {
  readonly element = el("div", { class: "player" });
  readonly #play: HTMLButtonElement;
  readonly #time: HTMLInputElement;
  #moments = 0;
  #seconds = 1;
  #running = 0;

  /** `onMoment` is called with each moment, `onEnd` at the end or after a stop. */
  constructor(readonly texts: Texts, readonly onMoment: (moment: number) => void, readonly onEnd: () => void = () => undefined) {
    this.#play = button(texts.play, () => (this.#running === 0 ? this.#start() : this.stop()), { id: texts.id });
    this.#time = el("input", { type: "range", min: 0, max: 1, step: 1, class: "slider", "aria-label": texts.time });
    this.#time.addEventListener("input", () => {
      cancelAnimationFrame(this.#running);
      this.#running = 0;
      setText(this.#play, texts.play);
      onMoment(this.#time.valueAsNumber);
    });
    this.element.append(this.#play, this.#time);
  }

  /** Starts with other moments, which take this time on the screen. */
  reset(moments: number, seconds: number): void {
    this.stop();
    [this.#moments, this.#seconds] = [moments, Math.max(seconds, 0.1)];
    this.element.hidden = moments < 2;
    setAttribute(this.#time, "max", Math.max(1, moments - 1));
    this.#time.value = "0";
  }

  stop(): void {
    const wasRunning = this.#running !== 0;
    cancelAnimationFrame(this.#running);
    this.#running = 0;
    setText(this.#play, this.texts.play);
    if (wasRunning) this.onEnd();
  }

  #start(): void {
    const last = this.#moments - 1;
    const from = this.#time.valueAsNumber >= last ? 0 : this.#time.valueAsNumber;
    const begin = performance.now() - (from / last) * this.#seconds * 1000;
    setText(this.#play, "Stop");
    const step = (now: number) => {
      const moment = Math.min(last, Math.max(0, Math.floor(((now - begin) / 1000 / this.#seconds) * last)));
      this.#time.value = String(moment);
      this.onMoment(moment);
      if (moment < last) this.#running = requestAnimationFrame(step);
      else this.stop();
    };
    this.#running = requestAnimationFrame(step);
  }
}
