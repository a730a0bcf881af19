// A recorded motion with force plates: the moving body, curves of the contacts and of the plates, and a text about them.

import assert from "node:assert/strict";

import { inChromium } from "./support/chromium.mjs";
import { Folder } from "./support/command.mjs";
import { given } from "./support/places.mjs";

const FILES = ["walker.osim", "walk.mot", "plates.sto", "plates.xml"].map((name) => given(`motion/${name}`));

inChromium("a motion is played with its plates; what is here alone is chosen, whatever comes first", async (user) => {
  const { page } = user;
  const [walker, ...others] = FILES;
  await user.choose(others.reverse());
  await user.announced(/3 files added/);
  await user.open(walker);
  assert.equal(await page.getByLabel("Recorded motion").inputValue(), "walk.mot");
  assert.equal(await page.getByLabel("Force plates", { exact: true }).inputValue(), "plates.sto");
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

inChromium("the motion is corrected: its verdict, its curves, its picture, and the file that the command writes", async (user) => {
  const { page } = user;
  await user.open(...FILES);
  await user.button("Correct the motion").click();
  const correction = page.locator(".correction");
  await correction.getByText(/contacts and plates agree: loaded spheres move/i).waitFor({ timeout: 60_000 });
  assert.equal(await correction.locator(".tag.good").innerText(), "agree");
  const curves = page.getByRole("img", { name: /upward force in body weights, plates dashed, recorded thin/ });
  assert.equal(await curves.count(), 2);
  const lines = curves.first().locator("polyline");
  assert.deepEqual(await lines.evaluateAll((all) => [...new Set(all.map((one) => one.getAttribute("class")))]), ["old", "before", "new"]);
  const drawn = () => page.locator("#stage-canvas").evaluate((one) => Number(one.dataset.drawn));
  const said = () => page.locator(".recording > .recording-words").innerText();
  const [before, ofCorrected] = [await drawn(), await said()];
  await page.getByRole("radio", { name: "As recorded" }).check();
  await page.waitForFunction((count) => Number(document.getElementById("stage-canvas").dataset.drawn) > count, before);
  assert.notEqual(await said(), ofCorrected, "the words are about the motion that is shown");
  await page.setViewportSize({ width: 390, height: 844 });
  await page.waitForTimeout(300);
  const [title, time] = await curves.first().locator("text").filter({ hasText: /foot| s$/ }).evaluateAll((all) => all.map((one) => one.getBoundingClientRect().toJSON()));
  assert.ok(title.right < time.left, "the title is not over the time");
  await page.setViewportSize({ width: 1280, height: 900 });
  const [download] = await user.downloads(user.button("Download walk.corrected.sto"), 1);
  const folder = new Folder(...FILES);
  const { status, stderr } = await folder.type(await correction.locator("code").innerText());
  assert.equal(status, 0, stderr);
  assertSameNumbers(download.bytes.toString(), folder.read(download.name).toString());
  folder.end();
});

/** Asserts that two tables have the same words, and numbers that differ by no more than two computers may. */
function assertSameNumbers(one, other) {
  const [words, others] = [one, other].map((text) => text.split(/\s+/));
  assert.equal(words.length, others.length);
  for (const [index, word] of words.entries()) {
    assert.ok(word === others[index] || Math.abs(Number(word) - Number(others[index])) < 1e-9, `${word}, expected ${others[index]}`);
  }
}

inChromium("a force in kN is said, and nothing is written; a delay is a field", async (user) => {
  const { page } = user;
  await user.open(FILES[0], FILES[1], given("motion/kilonewtons.sto"), FILES[3]);
  await user.button("Correct the motion").click();
  const correction = page.locator(".correction");
  await correction.getByText(/are their forces in kN/).waitFor({ timeout: 60_000 });
  assert.equal(await correction.locator(".tag.warning").innerText(), "disagree");
  assert.equal(await page.getByRole("button", { name: /^Download walk/ }).count(), 0);
  await page.getByText("Filter and delay").click();
  await page.getByLabel("Delay of the force plates (s)").fill("0,05");
  await page.getByLabel("Delay of the force plates (s)").blur();
  // Another recording has another correction.
  await correction.getByText(/are their forces in kN/).waitFor({ state: "detached" });
});

inChromium("without plates the contacts are seen alone; a motion of another model says why not", async (user) => {
  const { page } = user;
  await user.open(...FILES);
  await page.getByLabel("Force plates", { exact: true }).selectOption("");
  await page.getByRole("img", { name: /upward force in body weights;/ }).first().waitFor();
  await page.getByLabel("External loads").selectOption("");
  await user.drop({ name: "other.mot", bytes: Buffer.from("other\nversion=1\nnRows=2\nnColumns=2\ninDegrees=yes\nendheader\ntime\tnothing\n0\t1\n1\t2\n") });
  await page.getByLabel("Recorded motion").selectOption("other.mot");
  await page.locator(".recording").getByRole("alert").filter({ hasText: /coordinate/ }).waitFor();
});

inChromium("what a recording lacks is said, and is no error", async (user) => {
  const { page } = user;
  const [walker, motion, ...plates] = FILES;
  await user.open(walker, ...plates);
  await page.getByText("Open the recorded motion, too.").waitFor();
  await user.button("Close walker.osim").click();
  await user.open(given("feet/human_40000.osim", "bare.osim"), motion);
  await page.getByText("To play the motion, first give the model contacts, and keep them.").waitFor();
  assert.equal(await page.getByRole("alert").filter({ visible: true }).count(), 0);
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
