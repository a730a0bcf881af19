// A failure of the engine as an error that can be thrown.

import type { Failure } from "./types";

export class EngineError extends Error {
  constructor(readonly failure: Failure) {
    super(failure.message);
    this.name = "EngineError";
  }
}

/** What went wrong, as the engine would say it. */
export function failureOf(error: unknown): Failure {
  if (error instanceof EngineError) return error.failure;
  const message = error instanceof Error ? error.message : String(error);
  return { code: "internal", message, needs_answer: false, fields: [] };
}
