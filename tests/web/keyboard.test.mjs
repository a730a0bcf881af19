// Tests the page with the keyboard alone, from opening files to the download.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";

import { inChromium } from "./support/chromium.mjs";
import { makesTheSame } from "./support/command.mjs";
import { given } from "./support/places.mjs";

const HUMAN = given("table1/human_62kg_smooth_sphere.osim", "human.osim");

inChromium("from opening a file to the download, without a pointer", async (user) => {
  const { page } = user;
  await tabTo(user, "Open files…");
  const chooser = page.waitForEvent("filechooser");
  await page.keyboard.press("Enter");
  await (await chooser).setFiles([{ name: HUMAN.name, mimeType: "text/xml", buffer: HUMAN.bytes }]);
  await user.opened("human.osim");
  // Arrows choose among verbs, and back again.
  await tabTo(user, "Rescale");
  await page.keyboard.press("ArrowRight");
  assert.equal(await user.form.getByRole("radio", { name: "Transfer" }).isChecked(), true);
  await page.keyboard.press("ArrowLeft");
  await tabTo(user, "Target mass (kg)");
  await page.keyboard.type("100");
  await tabTo(user, "Target mass, slider");
  await page.keyboard.press("ArrowRight");
  await user.done("human.scaled.osim");
  const line = await user.spelled();
  assert.match(line, /--target-mass 101/);
  await page.keyboard.press("Escape");
  await tabTo(user, "Download human.scaled.osim", "Shift+Tab");
  const download = page.waitForEvent("download");
  await page.keyboard.press("Enter");
  const bytes = await readFile(await (await download).path());
  await makesTheSame(line, [HUMAN], [{ name: "human.scaled.osim", bytes }]);
});

inChromium("Ctrl+S in a field downloads what the form says now, not the result before", async (user) => {
  await user.open(HUMAN);
  const field = user.field("Target mass (kg)");
  await field.fill("70");
  await user.done("human.scaled.osim");
  const download = user.page.waitForEvent("download");
  await field.evaluate((one) => {
    one.value = "80";
    one.dispatchEvent(new Event("input", { bubbles: true }));
    one.dispatchEvent(new KeyboardEvent("keydown", { key: "s", ctrlKey: true, bubbles: true, cancelable: true }));
  });
  const bytes = await readFile(await (await download).path());
  await makesTheSame("osim-contact-scale rescale human.osim --target-mass 80", [HUMAN], [{ name: "human.scaled.osim", bytes }]);
});

inChromium("the first key leads past the head of the page", async (user) => {
  await user.page.keyboard.press("Tab");
  assert.equal(await focusedElement(user), "Skip to the content");
  const isVisible = await user.page.evaluate(() => document.activeElement.getBoundingClientRect().top >= 0);
  assert.equal(isVisible, true);
  await user.page.keyboard.press("Enter");
  assert.equal(await user.page.evaluate(() => document.activeElement.id), "content");
});

inChromium("what has the focus is seen", async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("100");
  await user.done("human.scaled.osim");
  await user.page.evaluate(() => document.activeElement.blur());
  const unseen = new Set();
  for (let count = 0; count < 60; count += 1) {
    await user.page.keyboard.press("Tab");
    const [name, visible] = await user.page.evaluate(() => {
      const one = document.activeElement;
      const { outlineStyle, outlineWidth } = getComputedStyle(one);
      return [one.outerHTML.slice(0, 80), outlineStyle !== "none" && parseFloat(outlineWidth) > 0];
    });
    // After the last element comes the browser's own frame.
    if (!visible && !name.startsWith("<body")) unseen.add(name);
  }
  assert.deepEqual([...unseen], []);
});

inChromium("a remedy, its undoing and the explanation of a finding", async (user) => {
  const { page } = user;
  await user.open(given("check/sunk_in.osim"));
  await user.unfold("mass");
  await tabTo(user, "sunk-in");
  await page.keyboard.press("Enter");
  await page.getByRole("dialog", { name: "Explanation" }).waitFor();
  await page.keyboard.press("Escape");
  assert.equal(await focusedElement(user), "sunk-in", "the focus is where it was");
  await tabTo(user, /^Change the contacts: relative indentation/);
  await page.keyboard.press("Enter");
  await user.done("sunk_in.scaled.osim");
  await tabTo(user, "Keep and continue", "Shift+Tab");
  await page.keyboard.press("Enter");
  await user.opened("sunk_in.scaled.osim");
  await tabTo(user, "Undo", "Shift+Tab");
  await page.keyboard.press("Enter");
  await user.opened("sunk_in.osim");
});

/** Presses a key until the element with this name has the focus. */
async function tabTo(user, name, key = "Tab") {
  const passed = [];
  for (let count = 0; count < 120; count += 1) {
    await user.page.keyboard.press(key);
    const now = await focusedElement(user);
    if (typeof name === "string" ? now === name : name.test(now)) return;
    passed.push(now);
  }
  assert.fail(`${name} is not reached: ${passed.join(", ")}`);
}

/** The name of the element with the focus, as a screen reader reads it. */
function focusedElement(user) {
  return user.page.evaluate(() => {
    const one = document.activeElement;
    return (one.ariaLabel ?? one.labels?.[0]?.textContent ?? one.textContent).trim().replace(/\s+/g, " ");
  });
}
