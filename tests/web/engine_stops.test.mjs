// A defect of the engine: WebAssembly stops in the middle of an answer. Open models stay open, and can be downloaded.

import assert from "node:assert/strict";

import { openWindow } from "./support/chromium.mjs";
import { makesTheSame } from "./support/command.mjs";
import { given, PAGE_ADDRESS } from "./support/places.mjs";
import { testWith } from "./support/skipping.mjs";
import { User } from "./support/user.mjs";

const HUMAN = given("table1/human_62kg_smooth_sphere.osim", "human.osim");

testWith({}, "after a stop of the engine, what is open stays, and work goes on", async () => {
  const user = await openPageWithStoppableEngine();
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("500");
  await user.done("human.scaled.osim");
  await user.keep("human.scaled.osim");
  await trapEngine(user, true);
  await user.verb("Set");
  await user.field("stiffness").fill("x2");
  await user.page.getByRole("alert").filter({ hasText: /defect|stopped/ }).first().waitFor();
  await user.region("human.scaled.osim").waitFor();
  assert.equal(await user.field("stiffness").inputValue(), "x2");
  // The next question is answered.
  await trapEngine(user, false);
  await user.field("stiffness").fill("x3");
  const [changed] = await user.downloads(await user.done("human.scaled.scaled.osim"));
  assert.ok(changed.bytes.length > 10_000);
  await user.button("Clear the form").click();
  const [kept] = await user.downloads(user.button("Download human.scaled.osim"));
  await makesTheSame("osim-contact-scale rescale human.osim --target-mass 500", [HUMAN], [kept]);
  await user.context.close();
});

/** Opens the page with an engine that a test can stop. */
async function openPageWithStoppableEngine() {
  const { context, page, watched } = await openWindow();
  await page.addInitScript(trappable, beforeTheWorker.toString());
  await page.goto(PAGE_ADDRESS);
  await page.locator("html[data-ready]").waitFor({ state: "attached" });
  return new User(page, context, watched);
}

async function trapEngine(user, trapped) {
  for (const worker of user.page.workers()) await worker.evaluate((yes) => (self.trapped = yes), trapped);
}

/** Runs in the page: puts the script `before` in front of the script of the worker. */
function trappable(before) {
  const Plain = Blob;
  window.Blob = class extends Plain {
    constructor(parts, options) {
      super(options?.type === "text/javascript" ? [`(${before})();`, ...parts] : parts, options);
    }
  };
}

/** In the worker: while it is trapped, questions are at an address that the engine does not have, which stops it as a defect would. */
function beforeTheWorker() {
  const Plain = WebAssembly.Instance;
  WebAssembly.Instance = function Instance(module, imports) {
    const { exports } = new Plain(module, imports);
    const call = (engine, text, length) => exports.engine_call(engine, self.trapped ? 0x7ffffff0 : text, length);
    return { exports: { ...exports, engine_call: call } };
  };
}
