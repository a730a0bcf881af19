// Tests in Chromium: every test gets its own page, whose requests and errors are recorded.

import assert from "node:assert/strict";
import { after } from "node:test";

import { launch, pageIn, windowIn } from "./launch.mjs";
import { PAGE_ADDRESS } from "./places.mjs";
import { testWith } from "./skipping.mjs";

let browser;

/** The browser that the tests of a file share. */
function sharedBrowser() {
  browser ??= launch();
  return browser;
}

after(async () => (await browser)?.close());

export async function openWindow(options) {
  return windowIn(await sharedBrowser(), options);
}

export async function openPage(options) {
  return pageIn(await sharedBrowser(), options);
}

/**
 * A test of the page in Chromium. At its end, the page must have asked for nothing but itself, and nothing may have gone
 * wrong in it that nobody saw.
 */
export function inChromium(name, ...rest) {
  const act = rest.pop();
  const { corpus, limit, ...options } = rest[0] ?? {};
  testWith({ corpus }, name, limit ? { timeout: limit } : {}, async (context) => {
    const user = await openPage(options);
    try {
      await act(user, context);
      assertRequestsOnlyItself(user.watched);
    } finally {
      await user.context.close();
    }
  });
}

/** Asserts that the page requested only itself and its worker, whose script is text in the page. */
function assertRequestsOnlyItself({ requests, problems }) {
  const others = requests.filter((one) => one.split("#")[0] !== PAGE_ADDRESS && !one.startsWith("blob:"));
  assert.deepEqual(others, [], "the page asked for more than itself");
  assert.deepEqual(problems, [], "something went wrong in the page");
}
