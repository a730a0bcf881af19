// The calculator: parameters of contacts from wanted values, without a model.

import assert from "node:assert/strict";

import { inChromium } from "./support/chromium.mjs";
import { Folder } from "./support/command.mjs";

const WANTED_VALUES = Object.entries({
  "Radius (m)": "0.03", "Mass of the model (kg)": "70", "Spheres that share the body weight": "4",
  "Relative indentation": "0.16", "Coefficient of restitution": "0.8", "Impact speed (m/s)": "0.4",
});
const CALL_WORDS = ["design", "--radius", "0.03", "--mass", "70", "--spheres", "4", "--indentation", "0.16", "--restitution", "0.8",
  "--impact-speed", "0.4"];

inChromium("numbers are the command's, and follow what is typed", async (user) => {
  const calculator = await openCalculator(user);
  await fillCalculator(user, calculator);
  await user.button("Calculate", calculator).click();
  const table = calculator.getByRole("table", { name: "What follows for one contact sphere." });
  await table.waitFor();
  await calculator.getByText("As text, to copy").click();
  const text = await calculator.getByLabel("The result as text").textContent();
  const folder = new Folder();
  const { stdout, status } = await folder.run(...CALL_WORDS);
  folder.end();
  assert.equal(status, 0);
  assert.equal(text.trim(), stdout.trim());
  const row = table.getByRole("row", { name: /^stiffness/ }).first();
  const before = await row.innerText();
  await calculator.getByLabel("Relative indentation").fill("0.1");
  await user.page.waitForFunction(([one, old]) => one.innerText !== old, [await row.elementHandle(), before]).catch(() => undefined);
  assert.notEqual(await table.getByRole("row", { name: /^stiffness/ }).first().innerText(), before);
});

inChromium("equations of the calculator are explained", async (user) => {
  const calculator = await openCalculator(user);
  await fillCalculator(user, calculator);
  await user.button("Calculate", calculator).click();
  await calculator.getByRole("link", { name: "(11)" }).first().click();
  await user.page.getByRole("dialog", { name: "Explanation" }).getByText(/11/).first().waitFor();
  await user.page.keyboard.press("Escape");
  await user.page.getByRole("dialog").waitFor({ state: "hidden" });
});

inChromium("what is missing is said, and answered in a field", async (user) => {
  const calculator = await openCalculator(user);
  await calculator.getByLabel("Relative indentation").fill("0.16");
  await user.button("Calculate", calculator).click();
  await calculator.getByRole("alert").filter({ hasText: /^error / }).waitFor();
  await fillCalculator(user, calculator);
  await calculator.getByRole("table").waitFor();
});

inChromium("the calculator closes and keeps what was typed", async (user) => {
  const calculator = await openCalculator(user);
  await fillCalculator(user, calculator);
  await user.button("Calculate without a model").click();
  await calculator.waitFor({ state: "hidden" });
  await user.button("Calculate without a model").click();
  assert.equal(await calculator.getByLabel("Relative indentation").inputValue(), "0.16");
});

async function openCalculator(user) {
  await user.button("Calculate without a model").click();
  const calculator = user.region("Calculate without a model");
  await calculator.waitFor();
  await user.page.waitForFunction(() => document.activeElement.id === "calculator-title");
  const more = calculator.getByText("More options");
  if (await more.isVisible()) await more.click();
  return calculator;
}

async function fillCalculator(user, calculator) {
  for (const [label, text] of WANTED_VALUES) {
    // A question has the same field once more, below the form.
    await calculator.getByLabel(label, { exact: true }).first().fill(text);
  }
}
