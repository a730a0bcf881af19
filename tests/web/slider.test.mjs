// Number box and slider show the same mass, and the preview of the change follows both.

import assert from "node:assert/strict";

import { inChromium } from "./support/chromium.mjs";
import { given } from "./support/places.mjs";

const HUMAN = given("table1/human_62kg_smooth_sphere.osim", "human.osim");

inChromium("the slider follows the number, and the number the slider", async (user) => {
  await user.open(HUMAN);
  const [number, slider] = [user.field("Target mass (kg)"), user.form.getByRole("slider", { name: "Target mass, slider" })];
  assert.match(await slider.getAttribute("aria-valuetext"), /^not set; 62 kg now/);
  await number.fill("100");
  assert.equal(await slider.getAttribute("aria-valuetext"), "100 kg");
  await slider.press("ArrowRight");
  // A step is the 200th part of a power of ten.
  assert.ok(Math.abs(Number(await number.inputValue()) / (100 * 10 ** 0.005) - 1) < 0.01, await number.inputValue());
  await slider.press("Home");
  assert.ok(Number(await number.inputValue()) <= 0.0209, "the mouse is on the slider");
  await slider.press("End");
  assert.ok(Number(await number.inputValue()) >= 1190, "the giraffe is on the slider");
  // What is typed reaches further than the slider.
  await number.fill("0.002");
  assert.equal(await slider.getAttribute("aria-valuetext"), "2 g");
  assert.equal(await number.inputValue(), "0.002");
  await number.fill("62");
  assert.ok(Math.abs(10 ** Number(await slider.inputValue()) - 62) < 0.5);
});

inChromium("masses are chosen by buttons, too", async (user) => {
  await user.open(HUMAN);
  const number = user.field("Target mass (kg)");
  for (const [button, mass] of [["horse, 545 kg", "545"], ["Twice the mass", "1090"], ["Half the mass", "545"], ["mouse, 20.9 g", "0.0209"],
    ["own mass: 62 kg", "62"]]) {
    await user.button(button, user.form).click();
    assert.equal(await number.inputValue(), mass);
  }
});

inChromium("what would change follows the slider while it moves, and ends where it ends", async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("70");
  const slider = user.form.getByRole("slider", { name: "Target mass, slider" });
  const row = user.result.getByRole("table", { name: /^Numbers that change/ }).getByRole("row", { name: /^stiffness/ });
  await row.waitFor();
  const seen = new Set();
  for (let step = 0; step < 25; step += 1) {
    await slider.press("ArrowRight");
    seen.add(await row.innerText());
  }
  assert.ok(seen.size > 10, `${seen.size} states were seen in 25 steps`);
  await user.settled();
  const mass = Number(await user.field("Target mass (kg)").inputValue());
  const expected = (mass / 62) ** (1 / 3);
  const factor = Number(/×([\d.]+)/.exec(await row.innerText())[1]);
  assert.ok(Math.abs(factor / expected - 1) < 1e-3, `${factor}, expected ${expected}`);
});
