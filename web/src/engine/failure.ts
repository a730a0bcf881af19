// Failures of the engine as errors that can be thrown.

import type { Failure } from "./types";

export class EngineError extends Error {
  constructor(readonly failure: Failure) {
    super(failure.message);
    this.name = "EngineError";
  }
}

/** Any error as a failure, like those of the engine. */
export function toFailure(error: unknown): Failure {
  if (error instanceof EngineError) return error.failure;
  const message = error instanceof Error ? error.message : String(error);
  return { code: "internal", message, needs_answer: false, fields: [] };
}
