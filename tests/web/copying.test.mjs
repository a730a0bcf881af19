// The change as a command, in Python and in MATLAB.

import assert from "node:assert/strict";

import { inChromium } from "./support/chromium.mjs";
import { Folder } from "./support/command.mjs";
import { given } from "./support/places.mjs";

const HUMAN = given("table1/human_62kg_smooth_sphere.osim", "my human.osim");
const PERMISSIONS = ["clipboard-read", "clipboard-write"];

inChromium("the change is spelled for a terminal, for Python and for MATLAB", async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("500");
  await user.done("my human.scaled.osim");
  assert.match(await user.spelled("Command"), /^osim-contact-scale rescale "my human\.osim" --target-mass 500$/);
  const python = await user.spelled("Python");
  assert.match(python, /import osim_contact_scale/);
  assert.match(python, /rescale\("my human\.osim", target_mass=500/);
  const matlab = await user.spelled("MATLAB");
  assert.match(matlab, /^result = osimcontact\.rescale\('my human\.osim', 'TargetMass', 500\);/m);
});

inChromium("the change is a request in JSON and a link without names, too", async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("500");
  await user.done("my human.scaled.osim");
  assert.deepEqual(JSON.parse(await user.spelled("JSON")), { verb: "rescale", models: ["my human.osim"], target_mass: 500 });
  assert.match(await user.spelled("Link"), /osim-contact-scale\.html#rescale\?target_mass=500$/);
});

for (const title of ["Command", "Python", "MATLAB"]) {
  inChromium(`“Copy as ${title}” copies it`, { permissions: PERMISSIONS }, async (user) => {
    await user.open(HUMAN);
    await user.field("Target mass (kg)").fill("500");
    await user.done("my human.scaled.osim");
    const text = await user.spelled(title);
    await user.button("Share…", user.acts).click();
    await user.button(`Copy as ${title}`).click();
    await user.announced(`Copied as ${title}.`);
    assert.equal(await user.page.evaluate(() => navigator.clipboard.readText()), text);
  });
}

inChromium("lines that change are shown as the command's --diff shows them", async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("500");
  await user.done("my human.scaled.osim");
  await user.result.getByText("Lines that change").click();
  const lines = user.result.getByLabel("Lines that change");
  await lines.getByText(/^\+.*<stiffness>2005361\.9\d+<\/stiffness>/).first().waitFor();
  const folder = new Folder(HUMAN);
  const { stdout } = await folder.run("my human.osim", "--target-mass", "500", "--dry-run", "--diff");
  folder.end();
  assert.ok(stdout.trimEnd().endsWith((await lines.textContent()).trimEnd()));
});
