// The main tasks of a user in Firefox ESR.

import assert from "node:assert/strict";

import { makesTheSame } from "./support/command.mjs";
import { openFirefox } from "./support/firefox.mjs";
import { FIREFOX, given, PAGE_ADDRESS } from "./support/places.mjs";
import { testWith } from "./support/skipping.mjs";

const HUMAN = given("table1/human_62kg_smooth_sphere.osim", "human.osim");

testWith({ browser: FIREFOX }, "Firefox: open, rescale, download what the command makes, undo; nothing else is asked for", async () => {
  const user = await openFirefox();
  try {
    const done = await user.choose(HUMAN);
    await user.text("12 × SmoothSphereHalfSpaceForce");
    done();
    await user.fill("Target mass (kg)", "500");
    await user.text("other properties change");
    await user.find("image", "Drop test");
    await user.click("Download human.scaled.osim");
    const bytes = await user.downloaded("human.scaled.osim");
    await makesTheSame("osim-contact-scale rescale human.osim --target-mass 500", [HUMAN], [{ name: "human.scaled.osim", bytes }]);
    await user.click("Keep and continue");
    await user.find("heading", "human.scaled.osim");
    await user.click("Undo");
    await user.find("heading", "human.osim");
    assert.match(new URL(await user.page.url()).hash, /^#rescale/);
    assertNoRequestsAndNoErrors(user);
  } finally {
    await user.end();
  }
});

testWith({ browser: FIREFOX }, "Firefox: files that are dropped, the calculator, and an error", async () => {
  const user = await openFirefox();
  try {
    await user.page.evaluate((text) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([text], "broken.osim"));
      document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
    }, given("bad/tags_crossed.osim").bytes.toString());
    await user.text("broken.osim:30:26");
    await user.click("Calculate without a model");
    for (const [label, text] of [["Radius (m)", "0.03"], ["Relative indentation", "0.16"], ["Mass of the model (kg)", "70"],
      ["Spheres that share the body weight", "4"]]) await user.fill(label, text);
    await user.click("Calculate");
    await user.text("What follows for one contact sphere.");
    assertNoRequestsAndNoErrors(user);
  } finally {
    await user.end();
  }
});

testWith({ browser: FIREFOX }, "Firefox: the commonest jobs, each in a few clicks", async () => {
  const user = await openFirefox();
  try {
    const model = given("check/contacts_of_another_mass.osim", "left.osim");
    const done = [await user.choose(model)];
    await user.click("Make the contacts right for 90 kg");
    await user.click("Download left.scaled.osim");
    const left = { name: "left.scaled.osim", bytes: await user.downloaded("left.scaled.osim") };
    await makesTheSame("osim-contact-scale rescale left.osim --contacts-mass 62 --target-mass 90", [model], [left]);
    await user.click("Close");
    const [scaled, generic] = [given("scale_tool/scaled_smooth.osim", "scaled.osim"), given("scale_tool/generic_smooth.osim", "generic.osim")];
    done.push(await user.choose(scaled), await user.choose(generic));
    await user.click("Move the spheres with the bones and make the contacts right for 52 kg");
    await user.click("Download scaled.scaled.osim");
    const followed = { name: "scaled.scaled.osim", bytes: await user.downloaded("scaled.scaled.osim") };
    await makesTheSame("osim-contact-scale transfer scaled.osim --from generic.osim --follow-bodies --level", [scaled, generic], [followed]);
    done.push(await user.choose(given("feet/human_40000.osim", "bare.osim")));
    await user.click("bare.osim");
    await user.click("From a reference spheres of another model or a preset");
    assert.equal(await user.page.evaluate(() => document.activeElement.id), "form-from");
    for (const one of done) one();
    assertNoRequestsAndNoErrors(user);
  } finally {
    await user.end();
  }
});

testWith({ browser: FIREFOX }, "Firefox: a library of forty is one ZIP", async () => {
  const user = await openFirefox();
  try {
    const done = await user.choose(...Array.from({ length: 40 }, (_, index) => ({ ...HUMAN, name: `m${index}.osim` })));
    await user.text("40 models opened.");
    done();
    await user.fill("Target mass (kg)", "80");
    await user.click("Change all and download a ZIP");
    assert.ok((await user.downloaded("models.zip")).length > 40_000);
    assertNoRequestsAndNoErrors(user);
  } finally {
    await user.end();
  }
});

function assertNoRequestsAndNoErrors({ watched: { requests, problems } }) {
  // Firefox has letters for its own use in an address that holds them.
  const others = requests.filter((address) => address.split("#")[0] !== PAGE_ADDRESS && !/^(blob|data):/.test(address));
  assert.deepEqual(others, []);
  assert.deepEqual(problems, []);
}
