// Tests that cannot run here say so, in the form that dev/skips.py reads.

import { test } from "node:test";

import { lacking } from "./places.mjs";

/** A test that is skipped, with a line about it, where this machine lacks what it `needs`. */
export function testWith(needs, name, ...rest) {
  const act = rest.pop();
  const why = lacking(needs);
  if (why) console.log(`skipped: ${name}: ${why}`);
  test(name, { timeout: 60_000, ...rest[0], skip: why ?? false }, act);
}
