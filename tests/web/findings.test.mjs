// Findings and their remedies; undo and redo.

import assert from "node:assert/strict";

import { inChromium } from "./support/chromium.mjs";
import { Folder } from "./support/command.mjs";
import { given } from "./support/places.mjs";

const HUMAN = given("table1/human_62kg_smooth_sphere.osim", "human.osim");
const SUNK_IN = given("check/sunk_in.osim");
const PROPOSAL = /^Change the contacts: relative indentation 0.16/;

inChromium("what the check proposes is a button; the result says what it changed and that the finding is gone", async (user) => {
  await user.open(SUNK_IN);
  const before = await findingsOf(user, "sunk_in.osim");
  assert.ok(before.includes("sunk-in"));
  await user.button(PROPOSAL).click();
  await user.done("sunk_in.scaled.osim");
  await user.result.getByRole("table", { name: /^Numbers that change/ }).getByRole("row", { name: /^stiffness/ }).waitFor();
  await user.outcome.locator("details.verdict[data-on=good]").waitFor();
  assert.equal(await user.outcome.getByText("too soft").count(), 0);
  await user.keep("sunk_in.scaled.osim");
  const after = await findingsOf(user, "sunk_in.scaled.osim");
  assert.ok(!after.includes("sunk-in"), after.join());
});

inChromium("what a remedy made is the command's file", async (user) => {
  await user.open(SUNK_IN);
  await user.keepProposal("sunk_in.scaled.osim");
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
    await user.opened(origin);
    const proposal = user.proposal.getByRole("group", { name: "Most likely" }).getByRole("button");
    if ((await proposal.count()) === 0) continue;
    await proposal.click();
    await user.done(`${name}.scaled.osim`);
    assert.equal(await user.page.getByRole("alert").count(), 0);
  }
});

inChromium("undo and redo by buttons and by keys", async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("500");
  await user.done("human.scaled.osim");
  await user.keep("human.scaled.osim");
  await user.button("Undo").click();
  await user.opened("human.osim");
  await user.announced(/^Undone: Make the contacts right for 500 kg/);
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
