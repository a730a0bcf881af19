// Errors: their place on the page, and the way out. Open models stay open.

import assert from "node:assert/strict";

import { inChromium } from "./support/chromium.mjs";
import { Folder } from "./support/command.mjs";
import { given } from "./support/places.mjs";
import { downloadsWhatTheCommandMakes } from "./support/same.mjs";

const HUMAN = given("table1/human_62kg_smooth_sphere.osim", "human.osim");
const BROKEN_MODELS = ["truncated", "tags_crossed", "attribute_unquoted", "two_roots", "empty", "utf16"];

inChromium("a broken file shows file, line, column and the marked place, as the command does", { limit: 90_000 }, async (user) => {
  for (const name of BROKEN_MODELS) {
    const file = given(`bad/${name}.osim`);
    const { line, column, message, marked } = await errorOfCommand(file);
    await user.choose([file]);
    if (name !== BROKEN_MODELS[0]) await user.button(file.name).click();
    const alert = user.region(file.name).getByRole("alert");
    await alert.waitFor();
    const text = await alert.innerText();
    assert.ok(text.toLowerCase().includes(message.slice(0, 25).toLowerCase()), `${message}\n${text}`);
    assert.ok(text.includes(line ? `${file.name}:${line}:${column}` : file.name), text);
    assert.equal(await alert.locator("mark").count(), marked ? 1 : 0, "the place is marked where the command marks it");
  }
});

inChromium("a number that is not one is found when it is needed, and marked", async (user) => {
  const file = given("bad/number_word.osim");
  await user.open(file);
  await user.field("Target mass (kg)").fill("80");
  const alert = user.outcome.getByRole("alert");
  await alert.getByText("number_word.osim:30:17").waitFor();
  assert.match(await alert.getByRole("paragraph").first().innerText(), /^error stiffness is 'abc', expected a number/i);
  assert.equal(await alert.locator("mark").textContent(), "abc");
});

inChromium("what is open stays when a broken file is opened beside it", async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("500");
  await user.done("human.scaled.osim");
  await user.drop(given("bad/truncated.osim"));
  await user.announced("1 model could not be opened");
  await user.region("human.osim").waitFor();
  assert.equal(await user.field("Target mass (kg)").inputValue(), "500");
  await downloadsWhatTheCommandMakes(user, [HUMAN], "human.scaled.osim");
});

inChromium("a broken file of the same name does not take the place of the model", async (user) => {
  await user.open(HUMAN);
  await user.drop({ name: "human.osim", bytes: given("bad/truncated.osim").bytes });
  await user.region("human.osim").getByRole("alert").filter({ hasText: "the one before stays open" }).waitFor();
  await user.field("Target mass (kg)").fill("500");
  await downloadsWhatTheCommandMakes(user, [HUMAN], "human.scaled.osim");
});

inChromium("a change that could not be kept is said until the next success", async (user) => {
  const taken = user.page.getByRole("alert").filter({ hasText: "human.scaled.scaled.osim is open already" });
  const keepTwice = async () => {
    await user.button("Keep and continue", user.acts).click();
    await taken.waitFor();
  };
  await user.open(HUMAN, { ...HUMAN, name: "human.scaled.scaled.osim" });
  await user.field("Target mass (kg)").fill("80");
  await user.done("human.scaled.osim");
  await user.keep("human.scaled.osim");
  await user.field("Target mass (kg)").fill("90");
  await user.done("human.scaled.scaled.osim");
  await keepTwice();
  await user.downloads(user.button("Download human.scaled.scaled.osim", user.acts));
  await taken.waitFor({ state: "hidden" });
  await keepTwice();
  await user.button("Undo", user.acts).click();
  await user.done("human.scaled.osim");
  await taken.waitFor({ state: "hidden" });
  assert.equal(await user.page.getByRole("alert").filter({ visible: true }).count(), 0);
});

inChromium("a text that is not a model, and bytes that are not a text, are refused by name", async (user) => {
  await user.drop({ name: "noise.osim", bytes: Uint8Array.from({ length: 4000 }, (_, index) => (index * 7919) % 256) });
  await user.region("noise.osim").getByRole("alert").waitFor();
  await user.drop(given("bad/html.osim"));
  await user.announced("1 model could not be opened");
});

inChromium("an answer that only the user has is a field; filled in, the change works", async (user) => {
  const ball = given("format/standalone_ForceSet.xml", "forces.xml");
  const geometry = given("format/standalone_ContactGeometrySet.xml", "geometry.xml");
  await user.drop(ball, geometry);
  await user.region("forces.xml").getByRole("group", { name: "Your answer" }).getByLabel("File of the contact geometry set").selectOption("geometry.xml");
  await user.field("Target mass (kg)").fill("80");
  const question = user.outcome.getByRole("group", { name: /answer/ });
  await question.getByLabel("Mass the contacts were made for (kg)").fill("61.5");
  await user.page.keyboard.press("Tab");
  await downloadsWhatTheCommandMakes(user, [ball, geometry], "forces.scaled.xml", ["geometry.scaled.xml"]);
});

inChromium("a number that is unlikely is asked about, and can be meant", async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("62000");
  const question = user.outcome.getByRole("group", { name: /answer/ });
  await question.getByLabel("Target mass (kg)").waitFor();
  await user.button("This is correct: continue", question).click();
  await user.outcome.getByRole("alert").filter({ hasText: /^error the radius of/i }).waitFor();
  await user.button("This is correct: continue", question).click();
  await downloadsWhatTheCommandMakes(user, [HUMAN], "human.scaled.osim");
  assert.match(await user.spelled(), /--yes implausible-mass.*--yes implausible-radius|--yes implausible-mass,implausible-radius/);
  await user.field("Target mass (kg)").fill("70000");
  await question.waitFor();
});

inChromium("what was typed wrongly is said at its field", async (user) => {
  await user.open(HUMAN);
  const wrong = [["70,5", "Write 70.5, with a decimal point."], ["heavy", /^Write a number/], ["-3", /^Write a number (above|of at least)/]];
  for (const [text, problem] of wrong) {
    await user.field("Target mass (kg)").fill(text);
    await user.form.getByRole("alert").filter({ hasText: problem }).waitFor();
    assert.equal(await user.field("Target mass (kg)").getAttribute("aria-invalid"), "true");
  }
  await user.field("Target mass (kg)").fill("70.5");
  await user.done("human.scaled.osim");
});

/** The error that the command reports about a file. */
async function errorOfCommand(file) {
  const folder = new Folder(file);
  const { stdout, stderr } = await folder.run("inspect", file.name, "--format", "json");
  folder.end();
  return { ...JSON.parse(stdout).error, marked: /^ +\| +\^/m.test(stderr) };
}

inChromium("a file of presets with an error says where it is", async (user) => {
  await user.choose([given("presets/bad_key.toml", "bad_key.toml")]);
  await user.announced(/bad_key\.toml:[0-9]+:[0-9]+: .*disipation/);
});
