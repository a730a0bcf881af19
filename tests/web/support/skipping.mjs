// Reports tests that cannot run on this machine, in the form that dev/skips.py reads.

import { test } from "node:test";

import { lacking } from "./places.mjs";

/** A test that is skipped and reported if this machine lacks programs or files that it `needs`. */
export function testWith(needs, name, ...rest) {
  const act = rest.pop();
  const why = lacking(needs);
  if (why) console.log(`skipped: ${name}: ${why}`);
  test(name, { timeout: 60_000, ...rest[0], skip: why ?? false }, act);
}
