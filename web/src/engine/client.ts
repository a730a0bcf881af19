// Sends tasks to the worker and returns a promise for each.

import { EngineError } from "./failure";
import { failed, type Files, type Reply, type Task, type ChangeThen } from "./messages";
import type { AnimalFall, Bones, CorrectedMotion, PlayedMotion } from "./space";
import type { Change, Kept, Inspected, NamedBytes, Preset, Request, Sheet, Spelled } from "./types";

interface Waiting {
  resolve(value: unknown): void;
  reject(error: EngineError): void;
}

type BusyListener = (count: number) => void;

export class Client {
  readonly #worker: Worker;
  readonly #waiting = new Map<number, Waiting>();
  #lastId = 0;
  #busy: BusyListener = () => undefined;

  constructor(worker: Worker) {
    this.#worker = worker;
    this.#worker.onmessage = ({ data }: MessageEvent<Reply>) => this.#settle(data);
    this.#worker.onerror = (event) => this.#end(event.message);
  }

  /** Calls `busy` whenever the number of unanswered tasks changes. */
  onBusy(busy: BusyListener): void {
    this.#busy = busy;
  }

  /** Starts the engine. It is the first task: the others wait for it in the worker. */
  start = (engine: string) => this.#send<null>({ do: "start", engine });
  put = (name: string, bytes: Uint8Array) => this.#send<null>({ do: "put", name, bytes }, [bytes.buffer]);
  remove = (name: string) => this.#send<null>({ do: "remove", name });
  bytes = (name: string) => this.#send<Uint8Array | null>({ do: "bytes", name });
  inspect = (model: string, fields: Record<string, unknown>, parts: string[]) => this.#call<Inspected>({ do: "look", model, fields, parts });
  bones = (model: string, fields: Record<string, unknown>) => this.#call<Bones>({ do: "bones", model, fields });
  change = (request: Request, parts: string[]) => this.#call<Change>({ do: "change", request, parts });
  keep = (request: Request, parts: string[]) => this.#send<ChangeThen<Kept>>({ do: "then", request, parts, next: "keep" });
  diff = (request: Request) => this.#send<ChangeThen<{ text: string }>>({ do: "then", request, parts: ["changes"], next: "diff" });
  files = (request: Request) => this.#send<Files>({ do: "files", request });
  report = (request: Request) => this.#call<{ name: string; html: string }>({ do: "report", request });
  calculate = (request: Request) => this.#call<{ sheet: Sheet; text: string }>({ do: "calculate", request });
  spell = (request: Request) => this.#call<Spelled>({ do: "spell", request });
  explain = (topic: string) => this.#call<{ text: string }>({ do: "explain", topic });
  play = (request: Record<string, unknown>) => this.#call<PlayedMotion>({ do: "play", request });
  correct = (request: Record<string, unknown>) => this.#call<CorrectedMotion>({ do: "correct", request });
  animals = () => this.#call<AnimalFall[]>({ do: "animals" });
  presets = (fields: Record<string, unknown> = {}) => this.#call<Preset[]>({ do: "presets", fields });
  zipBegin = () => this.#send<null>({ do: "zip-begin" });
  zipAdd = (request: Request) => this.#send<Change>({ do: "zip-add", request });
  zipEnd = () => this.#send<Uint8Array>({ do: "zip-end" });

  /** The bytes of a file with its name. */
  async file(name: string): Promise<NamedBytes> {
    const bytes = await this.bytes(name);
    if (!bytes) throw new Error(`${name} is not here any more`);
    return { name, bytes };
  }

  /** Lets the worker run an example, so that the first model of the user opens fast. There is no answer. */
  warmUp(example: string): void {
    this.#worker.postMessage({ id: 0, task: { do: "warm-up", example } satisfies Task });
  }

  #call<T>(call: Record<string, unknown>): Promise<T> {
    return this.#send<T>({ do: "call", call });
  }

  #send<T>(task: Task, transfer: Transferable[] = []): Promise<T> {
    const id = (this.#lastId += 1);
    const answer = new Promise<unknown>((resolve, reject) => this.#waiting.set(id, { resolve, reject }));
    this.#worker.postMessage({ id, task }, transfer);
    this.#busy(this.#waiting.size);
    return answer as Promise<T>;
  }

  #settle({ id, answer }: Reply): void {
    const waiting = this.#waiting.get(id);
    this.#waiting.delete(id);
    this.#busy(this.#waiting.size);
    if (failed(answer)) waiting?.reject(new EngineError(answer.error));
    else waiting?.resolve(answer.ok);
  }

  /** Rejects all waiting tasks after the worker has ended. */
  #end(message: string): void {
    const failure = { code: "internal", message: `the engine stopped: ${message}`, needs_answer: false, fields: [] };
    for (const { reject } of this.#waiting.values()) reject(new EngineError(failure));
    this.#waiting.clear();
    this.#busy(0);
  }
}
