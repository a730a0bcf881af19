// From step to step: one blue button, the original that the user has to choose, and models that are closed meanwhile.

import assert from "node:assert/strict";

import { inChromium } from "./support/chromium.mjs";
import { given } from "./support/places.mjs";

const HUMAN = given("table1/human_62kg_smooth_sphere.osim", "human.osim");
const SCALED = given("scale_tool/scaled_smooth.osim", "scaled.osim");
const GENERIC = given("scale_tool/generic_smooth.osim", "generic.osim");

inChromium("one button is blue: the next one to press", async (user) => {
  await user.page.waitForFunction(isOnlyBlue, "Open files…");
  await user.open(SCALED);
  await user.page.waitForFunction(isOnlyBlue, "Add a file… for “Model that it was scaled from”");
  await user.drop(GENERIC);
  const follow = "Move the spheres with the bones and make the contacts right for 52 kg";
  await user.page.waitForFunction(isOnlyBlue, follow);
  await user.button(follow).click();
  await user.page.waitForFunction(isOnlyBlue, "Download scaled.scaled.osim");
  await user.keep("scaled.scaled.osim");
  await user.page.waitForFunction(isOnlyBlue, "Download scaled.scaled.osim");
  await user.outcome.getByText("The change is kept. Download the model with the blue button below, or change more.").first().waitFor();
});

/** Inside the page: whether of all buttons only the one with this text has the colour of the next step. */
function isOnlyBlue(text) {
  const probe = document.body.appendChild(document.createElement("i"));
  probe.style.color = "var(--accent)";
  const { color } = getComputedStyle(probe);
  probe.remove();
  const all = [...document.querySelectorAll("button, .verb span")].filter((one) => one.checkVisibility() && getComputedStyle(one).backgroundColor === color);
  return all.length === 1 && all[0].textContent === text;
}

inChromium("of several models that may be the original, the user chooses one", async (user) => {
  await user.open(SCALED, GENERIC);
  const from = user.proposal.getByLabel("Model that it was scaled from", { exact: true });
  await user.proposal.getByRole("button", { name: /^Move the spheres/ }).waitFor();
  await user.drop({ ...GENERIC, name: "other.osim" });
  await user.proposal.getByText("Several open models may be its original: choose generic.osim or other.osim.").waitFor();
  assert.equal(await from.inputValue(), "");
  assert.equal(await user.page.getByLabel("All were scaled from").inputValue(), "");
  await from.selectOption("other.osim");
  await user.proposal.getByRole("button", { name: /^Move the spheres/ }).waitFor();
  await user.drop({ ...GENERIC, name: "third.osim" });
  await user.region("4 models").waitFor();
  await user.settled();
  assert.equal(await from.inputValue(), "other.osim", "what the user chose stays");
});

inChromium("the only model can be closed while it is opened and while a change of it is kept", async (user) => {
  await user.choose([HUMAN]);
  await user.button("Close human.osim").click();
  await user.region("Drop a model here, or click").waitFor();
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("80");
  await user.done("human.scaled.osim");
  await user.page.evaluate(async () => {
    document.getElementById("keep").click();
    await new Promise((resolve) => setTimeout(resolve));
    document.querySelector("[aria-label='Close human.osim']").click();
  });
  await user.region("Drop a model here, or click").waitFor();
  await user.settled();
  assert.equal(await user.page.getByRole("alert").filter({ visible: true }).count(), 0);
  await user.open({ ...HUMAN, name: "next.osim" });
  await user.field("Target mass (kg)").fill("70");
  await user.done("next.scaled.osim");
});

inChromium("the only model can be closed, also while its change is computed", async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("80");
  await user.button("Close human.osim").click();
  await user.region("Drop a model here, or click").waitFor();
  await user.settled();
  assert.equal(await user.acts.isVisible(), false);
  assert.equal(await user.page.getByRole("alert").filter({ visible: true }).count(), 0);
});
