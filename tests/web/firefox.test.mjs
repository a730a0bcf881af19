// The main flows in Firefox ESR.

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
    await user.text("72 numbers of 6 properties change");
    await user.find("image", "Drop test");
    await user.click("Download human.scaled.osim");
    const bytes = await user.downloaded("human.scaled.osim");
    await makesTheSame("osim-contact-scale rescale human.osim --target-mass 500", [HUMAN], [{ name: "human.scaled.osim", bytes }]);
    await user.click("Keep and go on");
    await user.find("heading", "human.scaled.osim");
    await user.click("Undo");
    await user.find("heading", "human.osim");
    assert.match(new URL(await user.page.url()).hash, /^#rescale/);
    assertQuiet(user);
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
    assertQuiet(user);
  } finally {
    await user.end();
  }
});

function assertQuiet({ watched: { requests, problems } }) {
  // Firefox has letters for its own use in an address that holds them.
  const others = requests.filter((address) => address.split("#")[0] !== PAGE_ADDRESS && !/^(blob|data):/.test(address));
  assert.deepEqual(others, []);
  assert.deepEqual(problems, []);
}
