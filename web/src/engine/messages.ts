// Messages between page and worker. No other task runs between the steps of a task.

import type { Change, Failure, NamedBytes, Request } from "./types";

export type Task =
  | { do: "start"; engine: string }
  /** Runs an example, so that the first model opens fast. */
  | { do: "warm-up"; example: string }
  | { do: "put"; name: string; bytes: Uint8Array }
  | { do: "remove"; name: string }
  | { do: "bytes"; name: string }
  | { do: "call"; call: Record<string, unknown> }
  /** Plans a change, and returns its result files in the same answer. */
  | { do: "files"; request: Request }
  /** Plans a change, and makes a second call about it in the same task. */
  | { do: "then"; request: Request; parts: string[]; next: "keep" | "diff" }
  | { do: "zip-begin" }
  | { do: "zip-add"; request: Request }
  | { do: "zip-end" };

export interface Message {
  id: number;
  task: Task;
}

export type Answer<T> = { ok: T } | { error: Failure };

export interface Reply {
  id: number;
  answer: Answer<unknown>;
}

export interface Files {
  change: Change;
  files: NamedBytes[];
}

export interface ChangeThen<T> {
  change: Change;
  next: T;
}

/** Whether an answer is a failure. */
export function failed<T>(answer: Answer<T>): answer is { error: Failure } {
  return "error" in answer;
}
