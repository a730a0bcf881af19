// Several models: a table with a row for each model, one change for all models, and an archive of the results.

import assert from "node:assert/strict";

import { inChromium } from "./support/chromium.mjs";
import { Folder } from "./support/command.mjs";
import { given } from "./support/places.mjs";
import { unzipped } from "./support/unzip.mjs";

const MODELS = ["human_62kg", "mouse", "horse"].map((name) => given(`table1/${name}_smooth_sphere.osim`, `${name}.osim`));
const BROKEN = given("bad/number_word.osim", "broken.osim");

inChromium("models are changed to masses of their own, and the archive has what the command makes", async (user) => {
  await user.open(...MODELS);
  const library = user.region("3 models");
  await library.getByLabel("Target mass of mouse.osim (kg)").fill("0.03");
  await library.getByLabel("Target mass of horse.osim (kg)").fill("600");
  await user.field("Target mass (kg)").fill("80");
  await user.button("Show what would change in all models", library).click();
  await user.announced("3 of 3 models would change");
  const whole = /^radius ×[\d.]+, stiffness ×[\d.]+, dissipation ×[\d.]+ and \d other properties change\.$/;
  for (const outcome of await outcomesOfModels(library)) assert.match(outcome, whole);
  const [zip] = await user.downloads(user.button("Change all and download a ZIP", library));
  assert.equal(zip.name, "models.zip");
  const files = unzipped(zip.bytes);
  const folder = new Folder(...MODELS);
  folder.write("table.csv", "model,target_mass\nhuman_62kg.osim,80\nmouse.osim,0.03\nhorse.osim,600\n");
  const { status, stderr } = await folder.run("batch", "table.csv", "-d", "out");
  assert.equal(status, 0, stderr);
  assert.deepEqual([...files.keys()].sort(), ["horse.scaled.osim", "human_62kg.scaled.osim", "mouse.scaled.osim"]);
  for (const [name, bytes] of files) assert.ok(folder.read(`out/${name.replace(".scaled", "")}`).equals(bytes), name);
  folder.end();
});

inChromium("a model that fails is a row with an error, and not in the archive", async (user) => {
  await user.open(...MODELS, BROKEN);
  const library = user.region("4 models");
  await user.field("Target mass (kg)").fill("80");
  await library.getByLabel("Target mass of mouse.osim (kg)").fill("0.03");
  const [zip] = await user.downloads(user.button("Change all and download a ZIP", library));
  await user.announced(/1 failed and (is|are) not in it/);
  assert.match((await outcomesOfModels(library))[0], /^error stiffness is 'abc', expected a number/);
  assert.deepEqual([...unzipped(zip.bytes).keys()].sort(), ["horse.scaled.osim", "human_62kg.scaled.osim", "mouse.scaled.osim"]);
});

inChromium("a model without contacts has no mass that they were made for, and no spheres that move", async (user) => {
  await user.open(...MODELS, given("feet/human_40000.osim", "bare.osim"));
  const library = user.region("4 models");
  await user.button("Move the spheres of 2 models with the bones, and download a ZIP", library).waitFor();
  assert.equal(await library.getByRole("row", { name: /^bare\.osim/ }).getByRole("cell").nth(1).textContent(), "–");
});

inChromium("headings sort the rows, and one answer is for all models", async (user) => {
  await user.open(...MODELS);
  const library = user.region("3 models");
  await user.button("mass", library).click();
  assert.deepEqual(await library.getByRole("rowheader").allTextContents(), ["mouse.osim", "human_62kg.osim", "horse.osim"]);
  await user.button("mass", library).click();
  assert.deepEqual(await library.getByRole("rowheader").allTextContents(), ["horse.osim", "human_62kg.osim", "mouse.osim"]);
  await library.getByLabel("Target mass of all (kg)").fill("62000");
  await user.button("Show what would change in all models", library).click();
  await user.announced(/would change, [123] failed/);
  const question = library.getByRole("group", { name: /answer/ });
  await user.button("This is correct: continue", question).click();
  await library.getByRole("alert").filter({ hasText: /the radius of/ }).waitFor();
  await user.button("This is correct: continue", question).click();
  await user.announced("3 of 3 models would change.");
});

inChromium("where nothing can be changed there is no archive", async (user) => {
  await user.open(...MODELS);
  await user.verb("Add");
  await user.field("Source of the contacts").selectOption("falisse2022");
  await user.button("Change all and download a ZIP").click();
  await user.announced("No model could be changed; there is no archive.");
});

inChromium("a row opens its model, and can be closed", async (user) => {
  await user.open(...MODELS);
  await user.button("horse.osim").click();
  await user.opened("horse.osim");
  await user.button("Close horse.osim").click();
  await user.region("2 models").waitFor();
  await user.region("human_62kg.osim").waitFor();
});

inChromium("equal results give equal archives", async (user) => {
  await user.open(...MODELS);
  await user.verb("Set");
  await user.field("stiffness").fill("x2");
  const all = user.button("Change all and download a ZIP");
  const [[one], [other]] = [await user.downloads(all), await user.downloads(all)];
  assert.ok(one.bytes.equals(other.bytes));
});

async function outcomesOfModels(library) {
  const rows = await library.getByRole("row").filter({ has: library.page().getByRole("rowheader") }).all();
  return Promise.all(rows.map((row) => row.locator(".outcome").textContent()));
}
