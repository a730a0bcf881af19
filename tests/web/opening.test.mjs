// Opening files: dropped or chosen, one or many, with the other files of a model.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";

import { inChromium } from "./support/chromium.mjs";
import { Folder } from "./support/command.mjs";
import { fixture, given, published } from "./support/places.mjs";

const HUMAN = given("table1/human_62kg_smooth_sphere.osim", "human.osim");
const MOUSE = given("table1/mouse_smooth_sphere.osim", "mouse.osim");

inChromium("a model that is dropped is summed up and its feet are drawn", async (user) => {
  await user.drop(HUMAN);
  await user.opened("human.osim");
  await user.details.getByRole("term").filter({ hasText: "Gravity" }).waitFor();
  const facts = await user.details.getByRole("definition").allTextContents();
  assert.match(facts[0], /^62 kg/);
  assert.ok(facts.includes("12 × SmoothSphereHalfSpaceForce"), facts.join("; "));
  assert.ok(facts.includes("9.81 m/s²"));
  assert.match(facts.join(), /femur_r \(right\): 6 spheres/);
  await user.page.getByRole("img", { name: /^12 contact spheres/ }).waitFor();
  await user.details.getByRole("heading", { name: "Feet" }).click();
  const feet = user.details.getByRole("figure").getByRole("img", { name: "Feet" });
  assert.equal(await feet.locator("circle").count() > 12, true, "spheres are drawn");
});

inChromium("a file and a folder of the disk are dropped on a page from the disk", async (user) => {
  await user.dropFromDisk(fixture("table1/human_62kg_smooth_sphere.osim"));
  await user.opened("human_62kg_smooth_sphere.osim");
  await user.dropFromDisk(fixture("scale_tool"));
  await user.region(/^[0-9]+ models$/).waitFor();
  await user.announced(/models? opened/);
});

inChromium("a file that is no model says what it is, and that its model is missing", async (user) => {
  await user.drop(given("motion/walk.mot"));
  await user.announced("1 file added (motion): now open the model.");
  await user.drop({ name: "foot.png", bytes: Buffer.from("a picture") });
  await user.announced("1 file added (unknown kind): now open the model.");
});

inChromium("of many models that cannot be opened the line says how many, and their rows say why", async (user) => {
  const { bytes } = given("bad/truncated.osim");
  await user.drop(...Array.from({ length: 20 }, (_, index) => ({ name: `m${index}.osim`, bytes })));
  await user.announced("20 models could not be opened: their rows say why.");
  assert.equal(await user.region("20 models").getByText(/the file ends inside a tag/).count(), 20);
});

inChromium("what comes while files are being opened waits for its turn", async (user) => {
  const broken = { name: "human.osim", bytes: Buffer.from("<OpenSimDocument>") };
  await Promise.all([user.drop(HUMAN), user.drop(broken), user.drop(HUMAN), user.drop(broken)]);
  await user.announced(/not taken/);
  await user.opened("human.osim");
});

inChromium("the places of the spheres are in a table, for those who do not see the feet", async (user) => {
  await user.open(HUMAN);
  await user.details.getByRole("heading", { name: "Forces and spheres of the model" }).click();
  const table = user.details.getByRole("group", { name: "Spheres" }).getByRole("table");
  const row = table.getByRole("row").filter({ has: user.page.getByRole("rowheader", { name: "s1_r" }) });
  assert.deepEqual(await row.getByRole("cell").allTextContents(), ["calcn_r", "femur_r", "0.0320", "-0.0298", "-0.0692", "-0.0480"]);
});

inChromium("a model can be chosen, and then another one, which makes a table of two", async (user) => {
  await user.open(HUMAN);
  assert.equal(await user.region(/models$/).count(), 0);
  await user.choose([MOUSE]);
  const table = user.region("2 models").getByRole("table");
  await table.waitFor();
  assert.deepEqual(await table.getByRole("rowheader").allTextContents(), ["human.osim", "mouse.osim"]);
});

inChromium("several models are opened at once", async (user) => {
  await user.drop(HUMAN, MOUSE, given("table1/horse_smooth_sphere.osim", "horse.osim"));
  await user.region("3 models").waitFor();
  await user.announced("3 models opened.");
});

inChromium("the example opens without any file", async (user) => {
  await user.button("Try the example").click();
  await user.opened("human_62kg_smooth_sphere.osim");
});

inChromium("a force set is opened with its geometry", async (user) => {
  await user.drop(
    given("format/standalone_ForceSet.xml", "forces.xml"), given("format/standalone_ContactGeometrySet.xml", "geometry.xml"));
  const set = user.region("forces.xml");
  await set.getByRole("group", { name: "Your answer" }).getByLabel("File of the contact geometry set").selectOption("geometry.xml");
  await user.opened("forces.xml");
  assert.match((await user.details.getByRole("definition").allTextContents()).join("; "), /1 × SmoothSphereHalfSpaceForce/);
});

inChromium("a model with a part in another file says that it is missing, and is whole once it is there", async (user) => {
  const { model, part } = modelInTwoFiles();
  await user.choose([model]);
  await user.page.getByText(/parts\/bodies\.xml/).first().waitFor();
  await user.drop(part);
  await user.opened(model.name);
  assert.match((await user.details.getByRole("definition").allTextContents())[0], /^62 kg sum of 9 bodies/);
});

inChromium("a folder is opened with what is in it, also what models take from other folders of it", async (user) => {
  const { model, part } = modelInTwoFiles();
  const folder = new Folder({ ...model, name: `lab/${model.name}` }, { ...part, name: `lab/${part.name}` });
  await user.choose(join(folder.path, "lab"), user.button("Open a folder…"));
  await user.opened(`lab/${model.name}`);
  folder.end();
  assert.match((await user.details.getByRole("definition").allTextContents())[0], /^62 kg sum of 9 bodies/);
});

inChromium("a published model is opened", { corpus: true }, async (user) => {
  const name = "v40000_falisse_2022_human.osim";
  await user.open({ name, bytes: readFileSync(published(name)) });
  await user.opened(name);
  assert.match((await user.details.getByRole("definition").allTextContents()).join("; "), /12 × SmoothSphereHalfSpaceForce/);
});

/** A model whose bodies are in a file of another folder. */
function modelInTwoFiles() {
  const [before, rest] = HUMAN.bytes.toString().split("<BodySet");
  const [bodies, after] = rest.split("</BodySet>");
  const model = `${before}<BodySet file="../parts/bodies.xml" />${after}`;
  const part = `<OpenSimDocument Version="40000"><BodySet${bodies}</BodySet></OpenSimDocument>`;
  return { model: { name: "models/human.osim", bytes: model }, part: { name: "parts/bodies.xml", bytes: part } };
}
