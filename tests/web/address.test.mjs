// The request in the address of the page: the user can store and send the address, and it never has names of files.

import assert from "node:assert/strict";

import { inChromium, openPage } from "./support/chromium.mjs";
import { given } from "./support/places.mjs";
import { serve } from "./support/server.mjs";

const HUMAN = given("table1/human_62kg_smooth_sphere.osim", "a_patients_name.osim");
const EXAMPLE = "human_62kg_smooth_sphere.osim";
const MOUSE = given("table1/mouse_smooth_sphere.osim", "another_name.osim");

inChromium("what the form says is in the address", async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("500");
  await user.more();
  await user.field("Soles stay level").check();
  await user.tick("Properties that change", "radius", "stiffness");
  await user.settled();
  assert.equal(fragmentOfAddress(user), "#rescale?target_mass=500&only=radius&only=stiffness&level=true");
  await user.verb("Set");
  await user.field("stiffness").fill("x2");
  await user.settled();
  assert.equal(decodeURIComponent(fragmentOfAddress(user)), "#set?set=stiffness=x2");
});

inChromium("an address fills the form in, before a model is there", { hash: "#rescale?target_mass=500&level=true&only=stiffness" },
  async (user) => {
    await user.open(HUMAN);
    assert.equal(await user.field("Target mass (kg)").inputValue(), "500");
    assert.equal(await user.field("Soles stay level").isChecked(), true);
    const button = await user.done("a_patients_name.scaled.osim");
    const [{ bytes }] = await user.downloads(button);
    assert.ok(bytes.length > 1000);
  });

inChromium("another address changes the form of the page that is open", async (user) => {
  await user.open(HUMAN);
  await user.page.evaluate(() => (location.hash = "#set?set=dissipation%3Dx3&set=stiffness%3D2000000"));
  await user.done("a_patients_name.scaled.osim");
  assert.equal(await user.form.getByRole("radio", { name: "Set" }).isChecked(), true);
  assert.equal(await user.field("dissipation").inputValue(), "x3");
  assert.equal(await user.field("stiffness").inputValue(), "2000000");
});

inChromium("a calculation has an address, too", { hash: "#design?radius=0.03&mass=70&spheres=4&indentation=0.16" }, async (user) => {
  const calculator = user.region("Calculate without a model");
  await calculator.waitFor();
  assert.equal(await calculator.getByLabel("Relative indentation").inputValue(), "0.16");
});

inChromium("an address opens the example", { hash: "#example" }, async (user) => {
  await user.opened(EXAMPLE);
  await user.field("Target mass (kg)").fill("500");
  await user.done("human_62kg_smooth_sphere.scaled.osim");
  await user.settled();
  assert.equal(fragmentOfAddress(user), "#rescale?target_mass=500");
});

inChromium("the address of the example works in a page that is open, too", async (user) => {
  const go = (address) => user.page.evaluate((hash) => (location.hash = hash), address);
  await go("#example");
  await user.opened(EXAMPLE);
  await go("#");
  await go("#example");
  await user.announced(`Open already: ${EXAMPLE}.`);
});

inChromium("no file's name is ever in the address", async (user) => {
  const seen = new Set();
  await user.page.exposeFunction("seen", (address) => void seen.add(address));
  await user.page.evaluate(() => setInterval(() => window.seen(location.href), 20));
  await user.open(HUMAN, MOUSE);
  await user.verb("Transfer");
  await user.field("Source of the contacts").selectOption(MOUSE.name);
  await user.field("Spheres follow their bodies").check();
  await user.settled();
  await user.verb("Rescale");
  await user.field("Target mass (kg)").fill("80");
  await user.settled();
  const addresses = [...seen, user.page.url()].join("\n");
  assert.match(addresses, /#transfer/);
  assert.doesNotMatch(addresses, /patient|another_name|osim(?!-contact)/);
});

inChromium("strange addresses do no harm", { hash: "#rescale?target_mass=%3Cimg%20src%3Dx%3E&only=%22&nothing=1&target_mass=2" }, async (user) => {
  await user.open(HUMAN);
  await user.form.getByRole("alert").filter({ hasText: /^Write a number/ }).waitFor();
  for (const address of ["#", "#nothing", "#rescale?", "#set?set=", "#set?set=x", "#transfer?from=../../etc/passwd", "#%E0%A4%A"]) {
    await user.page.evaluate((hash) => (location.hash = hash), address);
    await user.settled();
  }
  await user.opened(HUMAN.name);
});

inChromium("the page works from a server as it does from a folder", { limit: 60_000 }, async () => {
  const server = await serve();
  const user = await openPage({ address: server.page });
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("500");
  await user.downloads(await user.done("a_patients_name.scaled.osim"));
  assert.deepEqual(server.requests, ["/osim-contact-scale.html"]);
  assert.deepEqual(user.watched.problems, []);
  await user.context.close();
  await server.end();
});

function fragmentOfAddress(user) {
  return new URL(user.page.url()).hash;
}
