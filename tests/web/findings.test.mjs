// Findings and their remedies; undo and redo.

import assert from "node:assert/strict";

import { inChromium } from "./support/chromium.mjs";
import { Folder } from "./support/command.mjs";
import { given } from "./support/places.mjs";

const HUMAN = given("table1/human_62kg_smooth_sphere.osim", "human.osim");
const SUNK_IN = given("check/sunk_in.osim");
const APPLY_BUTTON = /^Apply: Design the contacts: relative indentation/;

inChromium("a remedy is applied by its button, shows what it changed, and the finding is gone", async (user) => {
  await user.open(SUNK_IN);
  const before = await findingsOf(user, "sunk_in.osim");
  assert.ok(before.includes("sunk-in"));
  await user.button(APPLY_BUTTON).click();
  await user.opened("sunk_in.scaled.osim");
  const done = user.region(/^Done: /);
  await done.waitFor();
  assert.equal(await user.page.evaluate(() => document.activeElement.textContent.startsWith("Done: ")), true);
  await done.getByText("What it changed").click();
  await done.getByRole("table", { name: /^Numbers that change/ }).getByRole("row", { name: /^stiffness/ }).waitFor();
  const after = await findingsOf(user, "sunk_in.scaled.osim");
  assert.ok(!after.includes("sunk-in"), after.join());
});

inChromium("what a remedy made is the command's file", async (user) => {
  await user.open(SUNK_IN);
  await user.button(APPLY_BUTTON).click();
  await user.opened("sunk_in.scaled.osim");
  const [download] = await user.downloads(user.button("Download sunk_in.scaled.osim", user.acts));
  const folder = new Folder(SUNK_IN);
  await folder.run("design", "sunk_in.osim", "--indentation", "0.16", "--constant-indentation", "0.054");
  assert.deepEqual(folder.made(), [download.name]);
  assert.ok(folder.read(download.name).equals(download.bytes));
  folder.end();
});

inChromium("every remedy of the models that show a finding can be applied", { limit: 90_000 }, async (user) => {
  const names = ["contacts_of_another_mass", "large_constant_indentation", "stale_note", "spheres_misplaced", "sunk_in"];
  for (const name of names) {
    await user.choose([given(`check/${name}.osim`)]);
    const origin = `${name}.osim`;
    if (name !== names[0]) await user.button(origin).click();
    const model = await user.opened(origin);
    const remedies = model.getByRole("button", { name: /^Apply: / });
    if ((await remedies.count()) === 0) continue;
    const text = (await remedies.first().textContent()).replace(/^Apply: /, "").replace(/\.$/, "");
    await remedies.first().click();
    const done = user.region(`Done: ${text}`);
    await done.or(user.page.getByRole("alert")).first().waitFor();
    assert.equal(await user.page.getByRole("alert").filter({ hasText: "defect" }).count(), 0);
  }
});

inChromium("undo and redo by buttons and by keys", async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("500");
  await user.done("human.scaled.osim");
  await user.keep("human.scaled.osim");
  await user.button("Undo").click();
  await user.opened("human.osim");
  await user.announced(/^Undone: Rescale: target mass 500 kg/);
  await user.button("Redo").click();
  await user.opened("human.scaled.osim");
  for (const [keys, model] of [["Control+z", "human.osim"], ["Control+Shift+z", "human.scaled.osim"], ["Control+z", "human.osim"],
    ["Control+y", "human.scaled.osim"]]) {
    await user.page.keyboard.press(keys);
    await user.opened(model);
  }
});

inChromium("keys undo what was typed, where something is being typed", async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("500");
  await user.done("human.scaled.osim");
  await user.keep("human.scaled.osim");
  await user.field("Target mass (kg)").pressSequentially("70");
  await user.page.keyboard.press("Control+z");
  await user.settled();
  assert.equal(await user.region("human.scaled.osim").count(), 1, "the model is as it was");
});

inChromium("two changes in a row are two steps, and one can go back to each", async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("80");
  await user.done("human.scaled.osim");
  await user.keep("human.scaled.osim");
  await user.verb("Set");
  await user.field("dissipation").fill("x2");
  await user.done("human.scaled.scaled.osim");
  await user.keep("human.scaled.scaled.osim");
  const [download] = await user.downloads(user.button("Download human.scaled.scaled.osim"));
  const folder = new Folder(HUMAN);
  await folder.run("human.osim", "--target-mass", "80");
  await folder.run("set", "human.scaled.osim", "dissipation=x2");
  assert.ok(folder.read("human.scaled.scaled.osim").equals(download.bytes));
  folder.end();
  const steps = user.page.getByRole("list", { name: "Steps" }).getByRole("listitem");
  assert.equal(await steps.count(), 3);
  await user.button("Opened human.osim").click();
  await user.opened("human.osim");
});

/** The codes of the findings of a model. */
async function findingsOf(user, name) {
  return user.region(name).getByRole("listitem", { includeHidden: true }).getByRole("link", { includeHidden: true }).allTextContents();
}
