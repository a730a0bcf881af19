// Each verb: the test fills in its form, reads the preview of the change, and compares the download with the command's file.

import assert from "node:assert/strict";

import { inChromium } from "./support/chromium.mjs";
import { given } from "./support/places.mjs";
import { downloadsWhatTheCommandMakes } from "./support/same.mjs";

const HUMAN = given("table1/human_62kg_smooth_sphere.osim", "human.osim");
const MOUSE = given("table1/mouse_smooth_sphere.osim", "mouse.osim");
const BARE = given("feet/human_40000.osim", "bare.osim");

inChromium("rescale: changes with their equations, plots, feet and findings are live", async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("500");
  await user.done("human.scaled.osim");
  const changes = user.result.getByRole("table", { name: /^Numbers that change/ });
  const stiffness = changes.getByRole("row", { name: /^stiffness/ });
  assert.match(await stiffness.innerText(), /1000000\s+2005000\s+×2\.005\s+\(10\)/);
  for (const name of ["Force against indentation", "Dissipation", "Drop test", "Feet"]) {
    await user.result.getByRole("img", { name }).waitFor();
  }
  await user.result.getByRole("heading", { name: "Gone with this change" }).waitFor();
  await user.result.getByRole("table", { name: /^Figures of the spheres/ }).waitFor();
  await downloadsWhatTheCommandMakes(user, [HUMAN], "human.scaled.osim");
});

inChromium("rescale: an equation is explained where its number is clicked", async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("500");
  await user.done("human.scaled.osim");
  await user.result.getByRole("link", { name: "(10)" }).first().click();
  const explanation = user.page.getByRole("dialog", { name: "Explanation" });
  await explanation.getByText(/\(10\)/).first().waitFor();
  await user.button("Close", explanation).click();
  await explanation.waitFor({ state: "hidden" });
});

inChromium("rescale: options further down, ticks and patterns are part of the change", async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("90");
  await user.more();
  await user.field("Mass the contacts were made for (kg)").fill("70");
  await user.form.getByRole("combobox", { name: /^Radius/ }).selectOption({ label: "a factor…" });
  await user.field("Radius: factor").fill("1.1");
  await user.tick("Properties that change", "radius", "stiffness");
  await user.tick("Forces to leave out", "contact_s1_r", "contact_s1_l");
  await downloadsWhatTheCommandMakes(user, [HUMAN], "human.scaled.osim");
  const line = await user.spelled();
  for (const words of ["--contacts-mass 70", "--radius x1.1", "--only", "--exclude"]) assert.ok(line.includes(words), line);
});

inChromium("transfer: from a second file", async (user) => {
  await user.open(HUMAN, MOUSE);
  await user.button("mouse.osim").click();
  await user.opened("mouse.osim");
  await user.verb("Transfer");
  await user.field("Source of the contacts").selectOption("human.osim");
  await downloadsWhatTheCommandMakes(user, [HUMAN, MOUSE], "mouse.scaled.osim");
});

inChromium("transfer: from a file that is added in the form", async (user) => {
  await user.open(MOUSE);
  await user.verb("Transfer");
  await user.choose([HUMAN], user.button(/^Add a file… for “Source of the contacts”/));
  await downloadsWhatTheCommandMakes(user, [HUMAN, MOUSE], "mouse.scaled.osim");
});

inChromium("transfer: from a preset, also one of the user's file", async (user) => {
  const lab = given("presets/lab.toml");
  await user.open(MOUSE, lab);
  await user.verb("Transfer");
  await user.field("Source of the contacts").selectOption("falisse2022");
  await downloadsWhatTheCommandMakes(user, [MOUSE, lab], "mouse.scaled.osim");
  await user.field("Source of the contacts").selectOption("heel_pad");
  await downloadsWhatTheCommandMakes(user, [MOUSE, lab], "mouse.scaled.osim");
  assert.match(await user.spelled(), /--presets lab\.toml/);
});

inChromium("transfer: spheres follow bodies that the Scale Tool scaled", async (user) => {
  const files = [
    given("scale_tool/scaled_smooth.osim", "scaled.osim"), given("scale_tool/generic_smooth.osim", "generic.osim"),
    given("scale_tool/applied_scale_set.xml", "applied.xml"),
  ];
  await user.open(...files);
  await user.opened("scaled.osim");
  await user.verb("Transfer");
  await user.field("Source of the contacts").selectOption("generic.osim");
  await user.field("Spheres follow their bodies").check();
  await user.field("The Scale Tool's ScaleSet").selectOption("applied.xml");
  await downloadsWhatTheCommandMakes(user, files, "scaled.scaled.osim");
});

inChromium("add: a preset's spheres, once the size of the bodies is said", async (user) => {
  await user.open(BARE);
  await user.verb("Add");
  await user.field("Source of the contacts").selectOption("falisse2022");
  const question = user.outcome.getByRole("group", { name: /answer/ });
  const factors = ["calcn_r=1", "calcn_l=1", "toes_r=1", "toes_l=1"].join("\n");
  await question.getByLabel("Scale factors of a body").fill(factors);
  await user.page.keyboard.press("Tab");
  await downloadsWhatTheCommandMakes(user, [BARE], "bare.scaled.osim");
});

inChromium("add: spheres below the meshes of the feet, with numbers from what is wanted", async (user) => {
  await user.open(BARE, ...filesOfMeshes());
  await user.verb("Add");
  await user.tick("Bodies that touch the ground", "calcn_r", "calcn_l");
  await user.field("Spheres under each foot").fill("3");
  await user.field("Sole below the bones (m)").fill("0.01");
  await user.form.getByRole("combobox", { name: /^Radius/ }).selectOption({ label: "a radius in metres…" });
  await user.field("Radius in metres").fill("0.03");
  await user.field("Class of the new forces").selectOption({ label: "SmoothSphereHalfSpaceForce" });
  await user.form.getByText("More options").click();
  await user.field("Relative indentation").fill("0.2");
  await downloadsWhatTheCommandMakes(user, [BARE, ...filesOfMeshes()], "bare.scaled.osim");
});

inChromium("add: spheres where a table has them", async (user) => {
  const table = given("contact_tables/own.csv", "places.csv");
  await user.open(BARE, table);
  await user.verb("Add");
  await user.field("Table of contacts").selectOption("places.csv");
  await user.field("Source of the contacts").selectOption("falisse2022");
  await downloadsWhatTheCommandMakes(user, [BARE, table], "bare.scaled.osim");
});

inChromium("convert: forces become those of the other class", async (user) => {
  await user.open(HUMAN);
  await user.verb("Convert");
  await user.field("Class that forces get").selectOption({ label: "HuntCrossleyForce" });
  await downloadsWhatTheCommandMakes(user, [HUMAN], "human.scaled.osim");
});

inChromium("remove: foot contacts are gone", async (user) => {
  await user.open(HUMAN);
  await user.verb("Remove");
  const [{ bytes }] = await downloadsWhatTheCommandMakes(user, [HUMAN], "human.scaled.osim");
  assert.ok(!bytes.includes("<ContactSphere"));
});

inChromium("set: a value and a factor, for some of the forces", async (user) => {
  await user.open(HUMAN);
  await user.verb("Set");
  await user.field("stiffness").fill("x2");
  await user.field("dissipation").fill("1.5");
  await user.tick("Forces to choose", "contact_s1_r", "contact_s2_r");
  await downloadsWhatTheCommandMakes(user, [HUMAN], "human.scaled.osim");
});

inChromium("design: an indentation and a restitution", async (user) => {
  await user.open(HUMAN);
  await user.verb("Design");
  await user.field("Relative indentation").fill("0.16");
  await user.field("Coefficient of restitution").fill("0.8");
  await user.field("Impact speed (m/s)").fill("0.4");
  await downloadsWhatTheCommandMakes(user, [HUMAN], "human.scaled.osim");
});

inChromium("a force set and its geometry are both downloaded", async (user) => {
  const files = [
    given("format/standalone_ForceSet.xml", "forces.xml"), given("format/standalone_ContactGeometrySet.xml", "geometry.xml"),
  ];
  await user.drop(...files);
  const set = user.region("forces.xml");
  await set.getByRole("group", { name: "Your answer" }).getByLabel("File of the contact geometry set").selectOption("geometry.xml");
  await set.getByLabel(/^Mass of the model/).or(user.form).first().waitFor();
  await user.more();
  await user.field("Mass the contacts were made for (kg)").fill("61.5");
  await user.field("Target mass (kg)").fill("80");
  await downloadsWhatTheCommandMakes(user, files, "forces.scaled.xml", ["geometry.scaled.xml"]);
});

function filesOfMeshes() {
  return ["r_human_foot", "l_human_foot", "r_human_toes", "l_human_toes"].map((name) => {
    const { bytes } = given(`feet/Geometry/${name}.vtp`);
    return { name: `${name}.vtp`, bytes };
  });
}
