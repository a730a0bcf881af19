// Everybody can use the page: axe-core finds no problem on small and large screens, in light and dark; no element is wider than the page.

import assert from "node:assert/strict";

import { axeFindings } from "./support/axe.mjs";
import { inChromium } from "./support/chromium.mjs";
import { given } from "./support/places.mjs";

const HUMAN = given("table1/human_62kg_smooth_sphere.osim", "human.osim");
const MOUSE = given("table1/mouse_smooth_sphere.osim", "mouse.osim");
const WIDTHS = [360, 1280, 1920];
const SCHEMES = ["light", "dark"];
// Problems of the width are found in one colour scheme, and problems of colours at one width.
const SCREENS_IN_FULL = [[360, "light"], [1280, "dark"], [1920, "light"]];

const SCREENS = {
  "the empty page": async () => undefined,
  "a model that is open": async (user) => {
    await user.open(HUMAN);
    await user.settled();
    for (const summary of await user.region("human.osim").locator("summary:visible").all()) await summary.click();
  },
  "a result with plots": async (user) => {
    await user.open(HUMAN);
    await user.field("Target mass (kg)").fill("500");
    await user.done("human.scaled.osim");
    await user.result.getByText("Lines that change").click();
    await user.spelled();
  },
  "the manual": async (user) => {
    await user.button("Manual", user.page).click();
    await user.page.getByRole("dialog", { name: "Manual of this page" }).getByRole("heading", { name: "Browsers" }).waitFor();
  },
  "the change to share": async (user) => {
    await user.open(HUMAN);
    await user.field("Target mass (kg)").fill("500");
    await user.done("human.scaled.osim");
    await user.button("Share…", user.acts).click();
  },
  "a model along a recording": async (user) => {
    await user.open(...["walker.osim", "walk.mot", "plates.sto", "plates.xml"].map((name) => given(`motion/${name}`)));
    await user.page.getByRole("img", { name: /upward force/ }).first().waitFor();
    await user.page.getByText("The same as text").click();
  },
  "a remedy that was applied": async (user) => {
    await user.open(given("check/sunk_in.osim"));
    await user.keepProposal("sunk_in.scaled.osim");
    await user.settled();
  },
  "several models": async (user) => {
    await user.open(HUMAN, MOUSE, given("bad/truncated.osim"));
    await user.field("Target mass (kg)").fill("80");
    await user.button("Show what would change in all models").click();
    await user.announced(/models would change/);
    await user.settled();
  },
  "an error with a question": async (user) => {
    await user.open(HUMAN);
    await user.field("Target mass (kg)").fill("62000");
    await user.outcome.getByRole("group", { name: /answer/ }).waitFor();
    await user.settled();
  },
  "a broken file": async (user) => {
    await user.choose([given("bad/tags_crossed.osim")]);
    await user.region("tags_crossed.osim").getByRole("alert").waitFor();
  },
  "the calculator": async (user) => {
    await user.button("Calculate without a model").click();
    const calculator = user.region("Calculate without a model");
    for (const [label, text] of [["Radius (m)", "0.03"], ["Relative indentation", "0.16"], ["Mass of the model (kg)", "70"],
      ["Spheres that share the body weight", "4"]]) await calculator.getByLabel(label, { exact: true }).first().fill(text);
    await user.button("Calculate", calculator).click();
    await calculator.getByRole("table").waitFor();
  },
};

for (const [name, show] of Object.entries(SCREENS)) {
  inChromium(`${name}: axe-core finds nothing, and nothing sticks out`, { limit: 90_000 }, async (user) => {
    await show(user);
    const { page } = user;
    for (const width of WIDTHS) {
      await page.setViewportSize({ width, height: 900 });
      assert.deepEqual(await elementsBeyondTheEdge(page), [], `at ${width} pixels`);
      for (const scheme of SCHEMES) {
        const full = SCREENS_IN_FULL.some(([wide, colours]) => wide === width && colours === scheme);
        if (!full && width !== WIDTHS[1]) continue;
        await page.emulateMedia({ colorScheme: scheme });
        assert.deepEqual(await axeFindings(page, full ? undefined : ["color-contrast"]), [], `${scheme}, ${width} pixels`);
      }
    }
  });
}

inChromium("the explanation is a dialog without findings", async (user) => {
  await user.open(HUMAN);
  await user.unfold("good");
  await user.region("human.osim").getByRole("link", { name: "beyond-hertz" }).first().click();
  await user.page.getByRole("dialog", { name: "Explanation" }).waitFor();
  assert.deepEqual(await axeFindings(user.page), []);
});

inChromium("letters twice as large still fit", { width: 640, height: 450 }, async (user) => {
  await user.open(HUMAN);
  await user.page.evaluate(() => (document.documentElement.style.fontSize = "200%"));
  assert.deepEqual(await elementsBeyondTheEdge(user.page), []);
});

/** The elements that reach beyond the right edge of the page, so that the page has to be scrolled sideways. */
function elementsBeyondTheEdge(page) {
  return page.evaluate(() => {
    const width = document.documentElement.clientWidth;
    if (document.documentElement.scrollWidth <= width) return [];
    const boxes = [...document.querySelectorAll("body *")].filter((one) => one.getBoundingClientRect().right > width + 1);
    return boxes.filter((one) => !one.closest(".wide, svg, pre")).map((one) => `${one.tagName} ${one.id} ${one.className}`).slice(0, 8);
  });
}
