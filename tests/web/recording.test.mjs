// A recorded motion with force plates: the moving body, curves of the contacts and of the plates, and a text about them.

import assert from "node:assert/strict";

import { inChromium } from "./support/chromium.mjs";
import { given } from "./support/places.mjs";

const FILES = ["walker.osim", "walk.mot", "plates.sto", "plates.xml"].map((name) => given(`motion/${name}`));

inChromium("a motion is played with its plates; what is here alone is chosen, whatever comes first", async (user) => {
  const { page } = user;
  const [walker, ...others] = FILES;
  await user.choose(others.reverse());
  await user.announced(/3 files added/);
  await user.open(walker);
  assert.equal(await page.getByLabel("Recorded motion").inputValue(), "walk.mot");
  assert.equal(await page.getByLabel("Force plates").inputValue(), "plates.sto");
  assert.equal(await page.getByLabel("External loads").inputValue(), "plates.xml");
  const curves = page.getByRole("img", { name: /upward force in body weights, plates dashed/ });
  await curves.first().waitFor();
  assert.equal(await curves.count(), 2);
  assert.ok((await curves.first().locator("polyline.old").count()) > 0 && (await curves.first().locator("polyline.new").count()) > 0);
  await page.locator(".recording-words").getByRole("listitem").first().waitFor();
  const drawn = () => page.locator("#stage-canvas").evaluate((one) => Number(one.dataset.drawn));
  const before = await drawn();
  await user.button("Play the motion").click();
  await page.waitForFunction((count) => Number(document.getElementById("stage-canvas").dataset.drawn) > count + 5, before);
  await user.button("Stop").click();
  const cursor = () => curves.first().locator("line.cursor").getAttribute("x1");
  const time = page.getByRole("slider", { name: "Time of the motion" });
  await time.fill("60");
  const there = await cursor();
  await time.fill("120");
  assert.ok(Number(await cursor()) > Number(there));
});

inChromium("without plates the contacts are seen alone; a motion of another model says why not", async (user) => {
  const { page } = user;
  await user.open(...FILES);
  await page.getByLabel("Force plates").selectOption("");
  await page.getByRole("img", { name: /upward force in body weights;/ }).first().waitFor();
  await page.getByLabel("External loads").selectOption("");
  await user.drop({ name: "other.mot", bytes: Buffer.from("other\nversion=1\nnRows=2\nnColumns=2\ninDegrees=yes\nendheader\ntime\tnothing\n0\t1\n1\t2\n") });
  await page.getByLabel("Recorded motion").selectOption("other.mot");
  await page.locator(".recording").getByRole("alert").filter({ hasText: /coordinate/ }).waitFor();
});

inChromium("the motion follows the model: after a change that is kept, its new contacts are seen", async (user) => {
  const { page } = user;
  await user.open(...FILES);
  const said = () => page.locator(".recording-words").innerText();
  await page.locator(".recording-words").getByRole("listitem").first().waitFor();
  const before = await said();
  await user.verb("Set");
  await user.field("stiffness").fill("x2");
  await user.done("walker.scaled.osim");
  await user.keep("walker.scaled.osim");
  await page.waitForFunction((old) => document.querySelector(".recording-words").innerText !== old, before);
  const peak = (text) => Number(/up to ([\d.]+) body weights/.exec(text)[1]);
  // The motion is prescribed: twice the stiffness is twice the force.
  assert.ok(Math.abs(peak(await said()) / peak(before) - 2) < 0.05, await said());
});
