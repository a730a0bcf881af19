// A file of 30 MB does not block the page: the page is drawn again while the file is opened, and the slider works.

import assert from "node:assert/strict";
import { join } from "node:path";

import { inChromium } from "./support/chromium.mjs";
import { Folder } from "./support/command.mjs";
import { given } from "./support/places.mjs";

const MODEL_BYTES = 30e6;
const LONGEST_MS = 200;
// A machine that is busy with other things delays pictures, too: the best of so many attempts counts.
const ATTEMPTS = 3;

inChromium("while a file of 30 MB is opened the page goes on, and then the slider works", { limit: 90_000 }, async (user, test) => {
  const human = given("table1/human_62kg_smooth_sphere.osim", "large.osim");
  const [before, after] = human.bytes.toString().split("<BodySet");
  const filler = "<!-- nothing but a long comment -->\n".repeat(MODEL_BYTES / 36);
  const bytes = Buffer.from(`${before}${filler}<BodySet${after}`);
  assert.ok(bytes.length >= MODEL_BYTES);
  const folder = new Folder({ name: "large.osim", bytes });
  await user.page.evaluate(measureTimeBetweenPictures);
  const opening = await bestOfAttempts(async () => {
    // A model that is open already would not be opened again.
    const close = user.button("Close large.osim");
    if (await close.isVisible()) await close.click();
    await user.page.evaluate(() => window.longest());
    await user.choose(join(folder.path, "large.osim"));
    await user.announced("1 model opened");
    await user.opened("large.osim");
    await user.settled();
    return user.page.evaluate(() => window.longest());
  });
  folder.end();
  const slider = user.form.getByRole("slider", { name: "Target mass, slider" });
  const moving = await bestOfAttempts(async () => {
    await user.page.evaluate(() => window.longest());
    await user.field("Target mass (kg)").fill("80");
    await user.done("large.scaled.osim");
    for (let step = 0; step < 10; step += 1) await slider.press("ArrowRight");
    await user.settled();
    assert.notEqual(await user.field("Target mass (kg)").inputValue(), "80");
    return user.page.evaluate(() => window.longest());
  });
  test.diagnostic(`longest time between two pictures: ${opening} ms while it was opened, ${moving} ms while the slider moved`);
  assert.ok(opening <= LONGEST_MS, `the page stood still for ${opening} ms while it was opened`);
  assert.ok(moving <= LONGEST_MS, `the page stood still for ${moving} ms while the slider moved`);
});

async function bestOfAttempts(attempt) {
  let least = Infinity;
  for (let count = 0; count < ATTEMPTS && least > LONGEST_MS; count += 1) least = Math.min(least, await attempt());
  return least;
}

/** Runs in the page: measures the longest time between two pictures; `longest` returns it and begins again. */
function measureTimeBetweenPictures() {
  let [last, longest] = [performance.now(), 0];
  const picture = () => {
    const now = performance.now();
    longest = Math.max(longest, now - last);
    last = now;
    requestAnimationFrame(picture);
  };
  requestAnimationFrame(picture);
  window.longest = () => {
    const said = Math.round(longest);
    longest = 0;
    return said;
  };
}
