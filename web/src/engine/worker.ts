// The worker: it runs the engine, so that long tasks do not block the page.

import { EngineHost } from "./host";
import { type Answer, failed, type Files, type Message, type Reply, type Task } from "./messages";
import type { Change, Failure, Request } from "./types";
import { unpack } from "./unpack";
import { Archive } from "./zip_writer";

interface Scope {
  onmessage: ((event: MessageEvent<Message>) => void) | null;
  postMessage(reply: Reply, transfer: Transferable[]): void;
}

const scope = globalThis as unknown as Scope;
const host = new EngineHost();
let archive = new Archive();
/** The steps of the warm-up that are left, and the timer of the next one. */
let warmUp: Generator<void> | undefined;
let nextStep: ReturnType<typeof setTimeout> | undefined;
const REST_AFTER_FILE_MS = 500;

scope.onmessage = ({ data: { id, task } }) => {
  const answer = handle(task);
  scope.postMessage({ id, answer }, transferables(answer));
};

// For boot.ts. A message that the page sends before this script has ended waits until the page is idle.
setTimeout(() => scope.postMessage({ id: 0, answer: { ok: null } }, []));

function handle(task: Task): Answer<unknown> {
  try {
    return task.do === "start" ? startEngine(task.engine) : runTask(task, host);
  } catch (error) {
    host.restart();
    warmUp = undefined;
    return { error: task.do === "put" ? tooLarge(task.name) : failureOfPage(error) };
  }
}

function startEngine(packed: string): Answer<null> {
  host.start(unpack(packed));
  return { ok: null };
}

function runTask(task: Exclude<Task, { do: "start" }>, engine: EngineHost): Answer<unknown> {
  switch (task.do) {
    case "warm-up": warmUp = engine.warmUp(unpack(task.example)); return { ok: warmUpAfter(0) ?? null };
    case "put": warmUpAfter(REST_AFTER_FILE_MS); return { ok: engine.put(task.name, task.bytes) ?? null };
    case "remove": return { ok: engine.remove(task.name) ?? null };
    case "bytes": return { ok: engine.bytes(task.name) ?? null };
    case "call": return callEngine(engine, task.call);
    case "files": return changedFiles(engine, task.request);
    case "then": return changeThenCall(engine, task);
    case "zip-begin": archive = new Archive(); return { ok: null };
    case "zip-add": return addToZip(engine, task.request);
    case "zip-end": return { ok: archive.end() };
  }
}

/** Runs the other steps of the warm-up after a rest. Tasks come between the steps, and a page that is left ends them. */
function warmUpAfter(rest: number): void {
  clearTimeout(nextStep);
  nextStep = setTimeout(() => warmUp?.next().done === false && warmUpAfter(0), rest);
}

function callEngine<T>(engine: EngineHost, call: Record<string, unknown>): Answer<T> {
  return JSON.parse(engine.call(JSON.stringify(call))) as Answer<T>;
}

function requestChange(engine: EngineHost, request: Request, parts: string[]): Answer<Change> {
  return callEngine<Change>(engine, { do: "change", request, parts });
}

function changedFiles(engine: EngineHost, request: Request): Answer<Files> {
  const change = requestChange(engine, request, ["changes"]);
  if (failed(change)) return change;
  const results = change.ok.results.map(({ name }, index) => ({ name, bytes: engine.result(index) ?? new Uint8Array() }));
  return { ok: { change: change.ok, files: results } };
}

function changeThenCall(engine: EngineHost, { request, parts, next }: Extract<Task, { do: "then" }>): Answer<unknown> {
  const change = requestChange(engine, request, parts);
  if (failed(change)) return change;
  const answer = callEngine<unknown>(engine, { do: next });
  if (failed(answer)) return answer;
  if (next === "keep") engine.rememberFiles(change.ok.results.map(({ name }) => name));
  return { ok: { change: change.ok, next: answer.ok } };
}

function addToZip(engine: EngineHost, request: Request): Answer<Change> {
  const results = changedFiles(engine, request);
  if (failed(results)) return results;
  const conflict = results.ok.files.find(({ name, bytes }) => archive.hasOther(name, bytes));
  if (conflict) return { error: nameTaken(conflict.name) };
  for (const { name, bytes } of results.ok.files) archive.add(name, bytes);
  return { ok: results.ok.change };
}

function nameTaken(name: string): Failure {
  const message = `another model makes a file of this name, ${name}: change this one by itself`;
  return { code: "name-taken", message, needs_answer: false, fields: [] };
}

function tooLarge(name: string): Failure {
  return { code: "too-large", message: `${name}: there is not enough memory in this browser for it`, needs_answer: false, fields: [] };
}

function failureOfPage(error: unknown): Failure {
  const message = error instanceof Error ? error.message : String(error);
  return { code: "internal", message: `this is a defect of the page, please report it: ${message}`, needs_answer: false, fields: [] };
}

/** Buffers that are transferred instead of copied. */
function transferables(answer: Answer<unknown>): Transferable[] {
  if (failed(answer)) return [];
  const { ok } = answer;
  if (ok instanceof Uint8Array) return [ok.buffer];
  return hasFiles(ok) ? ok.files.map(({ bytes }) => bytes.buffer) : [];
}

function hasFiles(answer: unknown): answer is Files {
  return typeof answer === "object" && answer !== null && "files" in answer && "change" in answer;
}
