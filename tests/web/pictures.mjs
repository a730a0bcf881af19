// Takes the pictures of the documentation: node tests/web/pictures.mjs docs/page
//
// The pictures show only the project's own models. The window is small, so that the pictures are small.

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
  model: { width: 1040, height: 640, show: async (user) => scrollToTop(user, await openModel(user)) },
  rescaled: {
    width: 1040, height: 640,
    show: async (user) => {
      await user.open(HUMAN);
      await user.field("Target mass (kg)").fill("200");
      await user.done("human.scaled.osim");
      await user.page.getByRole("radio", { name: "Side", exact: true }).check();
      await user.page.waitForTimeout(3500);
    },
  },
  followed: {
    width: 1040, height: 640,
    show: async (user) => {
      await user.open(given("scale_tool/scaled_smooth.osim", "scaled.osim"), given("scale_tool/generic_smooth.osim", "generic.osim"));
      await user.opened("scaled.osim");
      await user.button("Move the spheres with the bones and make the contacts right for 52 kg").click();
      await user.done("scaled.scaled.osim");
      await user.page.getByRole("radio", { name: "Side", exact: true }).check();
      await user.page.waitForTimeout(3500);
      await scrollToTop(user, user.region("The body"));
    },
  },
  bare: {
    width: 1040, height: 640,
    show: async (user) => {
      const meshes = ["r_human_foot", "l_human_foot", "r_human_toes", "l_human_toes"].map((name) => given(`feet/Geometry/${name}.vtp`));
      await user.open(given("feet/human_40000.osim", "human.osim"), ...meshes);
      await user.settled();
      await user.page.waitForTimeout(3500);
    },
  },
  library: {
    width: 1040, height: 640,
    show: async (user) => {
      const models = Array.from({ length: 40 }, (_, index) => ({ ...HUMAN, name: `subject_${String(index + 1).padStart(2, "0")}.osim` }));
      await user.choose(models);
      await user.announced("40 models opened.");
      await user.field("Target mass (kg)").fill("80");
      await user.button("Show what would change in all models").click();
      await user.announced(/would change/);
      await user.page.waitForTimeout(3500);
      await scrollToTop(user, user.region("40 models"));
    },
  },
  recording: {
    width: 1040, height: 820,
    show: async (user) => {
      await user.open(...["walker.osim", "walk.mot", "plates.sto", "plates.xml"].map((name) => given(`motion/${name}`)));
      await user.page.getByRole("img", { name: /upward force/ }).first().waitFor();
      await user.page.getByRole("radio", { name: "Side", exact: true }).check();
      await user.page.getByRole("slider", { name: "Time of the motion" }).fill("90");
      await user.page.waitForTimeout(3500);
      await scrollToTop(user, user.region("The body"));
    },
  },
};

async function openModel(user) {
  await user.open(HUMAN);
  await user.settled();
  // What happened last is not in the picture any more.
  await user.page.waitForTimeout(3500);
  return user.region("human.osim");
}

/** Scrolls so that a region begins at the top. */
function scrollToTop(user, region) {
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
