// Number box and slider show the same, and what would change follows both.

import assert from "node:assert/strict";

import { inChromium } from "./support/chromium.mjs";
import { given } from "./support/places.mjs";

const HUMAN = given("table1/human_62kg_smooth_sphere.osim", "human.osim");

inChromium("the slider follows the number, and the number the slider", async (user) => {
  await user.open(HUMAN);
  const [number, slider] = [user.field("Target mass (kg)"), user.form.getByRole("slider", { name: "Target mass, slider" })];
  assert.match(await slider.getAttribute("aria-valuetext"), /^not set; 62 kg now/);
  await number.fill("500");
  assert.equal(await slider.getAttribute("aria-valuetext"), "500 kg");
  await slider.press("ArrowRight");
  assert.equal(await number.inputValue(), "507");
  await slider.press("Home");
  assert.equal(await number.inputValue(), "0.001");
  assert.equal(await slider.getAttribute("aria-valuetext"), "1 g");
  await slider.press("End");
  assert.equal(await number.inputValue(), "100000");
  await number.fill("62");
  assert.ok(Math.abs(10 ** Number(await slider.inputValue()) - 62) < 0.5);
});

inChromium("what would change follows the slider while it moves, and ends where it ends", async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("60");
  const slider = user.form.getByRole("slider", { name: "Target mass, slider" });
  const row = user.result.getByRole("table", { name: /^Numbers that change/ }).getByRole("row", { name: /^stiffness/ });
  await row.waitFor();
  const seen = new Set();
  for (let step = 0; step < 40; step += 1) {
    await slider.press("ArrowRight");
    seen.add(await row.innerText());
  }
  assert.ok(seen.size > 10, `${seen.size} states were seen in 40 steps`);
  await user.settled();
  const mass = Number(await user.field("Target mass (kg)").inputValue());
  const expected = (mass / 62) ** (1 / 3);
  const factor = Number(/×([\d.]+)/.exec(await row.innerText())[1]);
  assert.ok(Math.abs(factor / expected - 1) < 1e-6, `${factor}, expected ${expected}`);
});
