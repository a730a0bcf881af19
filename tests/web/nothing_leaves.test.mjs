// The page sends nothing: a test page with the same policy tries all known ways to send data, and no byte reaches a listener.
//
// Beyond what a policy in a page can forbid is that the page is left: an address that a script or the user goes to, also in
// another window by a link, is asked for. The page has one such link, to the paper. No script of ours goes anywhere.
//
// Before the policy refuses to open a frame or to submit a form, Chromium opens a connection for it, and sends nothing.
// So bytes are counted, not connections.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

import { guard as GUARD, policyElement } from "../../web/build/policy.mjs";
import { inChromium, openWindow } from "./support/chromium.mjs";
import { given, PAGE } from "./support/places.mjs";
import { listen } from "./support/server.mjs";
import { testWith } from "./support/skipping.mjs";
import { NAMES, waysOut } from "./support/ways_out.mjs";

const WAIT_MS = 2500;
// Ways to send data that the first script of the page (the guard) blocks, because no policy governs them.
const GUARDED = ["window-open", "turn-server"];
const LEAVES_THE_PAGE = ["link-new-window"];
// Chromium does nothing about these in a page from a folder, or not each time, also without a policy.
const NEVER_TRIED = ["speculation", "worker", "shared-worker", "webtransport", "manifest", "preconnect", "prerender"];
const GOVERNED = NAMES.filter((name) => ![...GUARDED, ...LEAVES_THE_PAGE].includes(name));

testWith({}, "without the policy, the listener is reached by every way", async () => {
  const reached = await requestsHeard(NAMES, () => "", "");
  const silent = NAMES.filter((name) => !reached.some((line) => line.includes(`/${name}`)) && !NEVER_TRIED.includes(name));
  // A TURN server is asked in a protocol without names.
  assert.deepEqual(silent.filter((name) => name !== "turn-server"), []);
  assert.ok(reached.some((line) => line.startsWith("\0\x03")), "the TURN server was asked");
});

testWith({}, "with the policy, nothing that it governs reaches the listener", async () => {
  assert.deepEqual(await requestsHeard(GOVERNED, policyElement), []);
});

testWith({}, "with the policy and the guard, no window is opened and no peer is called", async () => {
  assert.deepEqual(await requestsHeard(GUARDED, policyElement), []);
});

inChromium("the page has this policy, before anything else", async (user) => {
  const html = readFileSync(PAGE, "utf8");
  const [, policy] = /^<!doctype html>\s*<html lang="en">\s*<head>\s*<meta http-equiv="Content-Security-Policy" content="([^"]*)">/.exec(html) ?? [];
  for (const part of ["default-src 'none'", "connect-src 'none'", "form-action 'none'", "base-uri 'none'"]) {
    assert.ok(policy.split("; ").includes(part), `${part} in: ${policy}`);
  }
  assert.ok(html.includes(`<script>${GUARD}</script>`), "the guard is in the page");
  assert.doesNotMatch(policy, /unsafe-inline|'unsafe-eval'|https?:|\*/);
  // Tried in the page itself, too, by somebody who sits before it.
  const listener = await listen();
  await user.open(given("table1/human_62kg_smooth_sphere.osim", "human.osim"));
  await user.page.evaluate((host) => Promise.allSettled([fetch(`http://${host}/fetch`), new Promise((resolve) => {
    const image = new Image();
    image.onerror = resolve;
    image.src = `http://${host}/image`;
  })]), listener.host);
  assert.deepEqual(listener.reached, []);
  await listener.end();
  user.watched.requests.length = 0;
  user.watched.problems.length = 0;
});

inChromium("the page keeps nothing: no cookies, no storage, no caches", async (user) => {
  await user.open(given("table1/human_62kg_smooth_sphere.osim", "human.osim"));
  await user.field("Target mass (kg)").fill("500");
  await user.done("human.scaled.osim");
  const kept = await user.page.evaluate(async () => [
    document.cookie, localStorage.length, sessionStorage.length, (await indexedDB.databases()).length,
  ]);
  assert.deepEqual(kept, ["", 0, 0, 0]);
});

/** The requests that reach a listener when a page tries the ways `names` after a click. The head of the page begins with `element`. */
async function requestsHeard(names, element, guard = GUARD) {
  const listener = await listen();
  const folder = mkdtempSync(join(tmpdir(), "osim-web-leak-"));
  const script = waysOut(listener.host, names);
  const scripts = [guard, script].filter(Boolean);
  const head = element({ scripts, styles: [] });
  const file = join(folder, "page.html");
  const body = scripts.map((one) => `<script>${one}</script>`).join("");
  const html = `<!doctype html><html><head>${head}<meta charset="utf-8"><title>ways out</title></head><body>${body}</body></html>`;
  writeFileSync(file, html);
  const { context, page } = await openWindow();
  try {
    await page.goto(pathToFileURL(file).href);
    await page.getByRole("button", { name: "Try" }).click();
    await page.waitForTimeout(WAIT_MS);
    return listener.reached.filter((line) => line !== "(connected)");
  } finally {
    await context.close();
    await listener.end();
    rmSync(folder, { recursive: true });
  }
}
