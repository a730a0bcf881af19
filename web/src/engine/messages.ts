// What page and worker say to each other. A task is one unit: nothing comes between its steps.

import type { Change, Failure, NamedBytes, Request } from "./types";

export type Task =
  | { do: "start"; engine: string }
  /** What makes the first use as fast as the next ones. */
  | { do: "warm-up"; example: string }
  | { do: "put"; name: string; bytes: Uint8Array }
  | { do: "remove"; name: string }
  | { do: "bytes"; name: string }
  | { do: "ask"; question: Record<string, unknown> }
  /** A change, and at once the files that it makes. */
  | { do: "files"; request: Request }
  /** A change, and at once what else is asked about it. */
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

export interface Then<T> {
  change: Change;
  next: T;
}

/** Whether an answer is a failure. */
export function failed<T>(answer: Answer<T>): answer is { error: Failure } {
  return "error" in answer;
}
