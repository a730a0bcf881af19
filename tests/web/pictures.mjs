// Takes the pictures of the documentation: node tests/web/pictures.mjs docs/page
//
// Of the project's own models only. The window is small, so that the pictures are.

import { mkdirSync, statSync } from "node:fs";
import { join } from "node:path";

import { launch, pageIn } from "./support/launch.mjs";
import { given } from "./support/places.mjs";

const MOST_BYTES = 180_000;
const HUMAN = given("table1/human_62kg_smooth_sphere.osim", "human.osim");

const PICTURES = {
  empty: {
    width: 1000, height: 700,
    show: async (user) => {
      await user.page.getByRole("img", { name: /^Falls of/ }).waitFor();
      // Until they lie still.
      await user.page.waitForTimeout(3500);
    },
  },
  model: { width: 1040, height: 640, show: async (user) => at(user, await opened(user)) },
  rescaled: {
    width: 1040, height: 640,
    show: async (user) => {
      await user.open(HUMAN);
      await user.field("Target mass (kg)").fill("200");
      await user.done("human.scaled.osim");
      await user.page.getByRole("radio", { name: "Side", exact: true }).check();
      await user.page.waitForTimeout(10_500);
    },
  },
  telephone: { width: 360, height: 700, scheme: "dark", show: async (user) => at(user, await opened(user)) },
};

async function opened(user) {
  await user.open(HUMAN);
  await user.settled();
  // What happened last is not in the picture any more.
  await user.page.waitForTimeout(10_500);
  return user.region("human.osim");
}

/** Scrolls so that a region begins at the top. */
function at(user, region) {
  return region.evaluate((one) => scrollTo(0, one.getBoundingClientRect().top + scrollY - 8));
}

const folder = process.argv[2];
if (!folder) {
  console.error("error: say into which folder: node tests/web/pictures.mjs docs/page");
  process.exit(2);
}
mkdirSync(folder, { recursive: true });
const browser = await launch();
for (const [name, { show, ...options }] of Object.entries(PICTURES)) {
  const user = await pageIn(browser, options);
  await show(user);
  await user.page.mouse.move(0, 0);
  const path = join(folder, `${name}.png`);
  await user.page.screenshot({ path, animations: "disabled" });
  await user.context.close();
  const { size } = statSync(path);
  console.log(`${String(size).padStart(7)} bytes  ${path}`);
  if (size > MOST_BYTES) process.exitCode = 1;
}
await browser.close();
