// The bench: question, verdicts and body on one screen; the commonest jobs in few actions; the body in three dimensions and in words.

import assert from "node:assert/strict";

import { inChromium, openWindow } from "./support/chromium.mjs";
import { makesTheSame } from "./support/command.mjs";
import { given, PAGE_ADDRESS } from "./support/places.mjs";
import { testWith } from "./support/skipping.mjs";
import { User } from "./support/user.mjs";

const HUMAN = given("table1/human_62kg_smooth_sphere.osim", "human.osim");
const SCALED = given("scale_tool/scaled_smooth.osim", "scaled.osim");
const GENERIC = given("scale_tool/generic_smooth.osim", "generic.osim");
const BARE = given("feet/human_40000.osim", "bare.osim");
const ONE_SCREEN = { width: 1280, height: 720 };

inChromium("mass, verdicts, feet and buttons are on one screen", ONE_SCREEN, async (user) => {
  await user.open(HUMAN);
  await user.settled();
  const { page } = user;
  const parts = {
    mass: user.field("Target mass (kg)"), slider: user.form.getByRole("slider", { name: "Target mass, slider" }),
    verdict: page.getByText(/^floor, standing/).first(), result: user.outcome, body: page.locator("#stage-canvas"), undo: user.button("Undo"),
    play: user.button("Let it fall"),
  };
  for (const [name, part] of Object.entries(parts)) {
    const box = await part.boundingBox();
    assert.ok(box.y >= 0 && box.y + box.height <= ONE_SCREEN.height, `${name}: ${JSON.stringify(box)}`);
  }
});

for (const width of [992, 1199, 1200, 1280, 1500, 1920]) {
  inChromium(`at ${width} pixels the three steps and the form stay in sight`, { width, height: 720 }, async (user) => {
    await user.open(HUMAN);
    await user.field("Target mass (kg)").fill("80");
    await user.done("human.scaled.osim");
    await user.page.evaluate(() => document.getElementById("result").scrollIntoView());
    for (const id of ["model-title", "proposal-title", "outcome-title", "change-title", "download"]) {
      const { y, height } = await user.page.locator(`#${id}`).boundingBox();
      assert.ok(y >= 0 && y + height <= 720, `${id}: ${y}`);
    }
    const form = await user.form.boundingBox();
    const after = await user.result.getByRole("columnheader", { name: "after" }).first().boundingBox();
    assert.ok(after.x + after.width <= form.x, "the new numbers are in sight");
    assert.deepEqual(await user.page.evaluate(smallTexts), []);
  });
}

inChromium("on a telephone buttons that stay in sight lead to each step", { width: 390, height: 844 }, async (user) => {
  await user.open(HUMAN);
  await user.settled();
  for (const [name, id] of [["1 File", "model"], ["2 Original", "proposal"], ["3 Result", "outcome"]]) {
    await user.page.evaluate(() => document.getElementById("details").scrollIntoView());
    const bar = await user.button(name, user.acts).boundingBox();
    assert.ok(bar.y >= 0 && bar.y + bar.height <= 844, `${name}: ${bar.y}`);
    await user.button(name, user.acts).click();
    const { y, height } = await user.page.locator(`#${id}-title`).boundingBox();
    assert.ok(y >= 0 && y + height < bar.y, `${id}: ${y}`);
  }
});

inChromium("on a telephone the blue button leads to its result, and a long text covers no button", { width: 390, height: 844 }, async (user) => {
  await user.open(given("check/contacts_of_another_mass.osim", "scaled.osim"));
  await user.outcome.getByText("Click the blue button of step 2, or choose another change, to see its result.").waitFor();
  await user.button("Make the contacts right for 90 kg").click();
  await user.done("scaled.scaled.osim");
  const [result, bar] = [await user.outcome.boundingBox(), await user.acts.boundingBox()];
  assert.ok(result.y >= 0 && result.y + result.height <= bar.y, JSON.stringify([result, bar]));
  await user.drop(given("bad/truncated.osim"));
  await user.announced("1 model could not be opened");
  const [button, line] = [await user.button("Share…", user.acts).boundingBox(), await user.page.locator("#announcement").boundingBox()];
  assert.ok(line.height > 40 && button.y + button.height <= line.y, JSON.stringify([button, line]));
});

inChromium("forces of a misspelt class are no reason to add others", async (user) => {
  await user.open(given("bad/class_misspelt.osim"));
  await user.proposal.getByText("First correct the file").waitFor();
  assert.equal(await user.proposal.getByRole("group", { name: "Most likely" }).getByRole("button").count(), 0);
  assert.ok(await user.form.getByRole("radio", { name: "Rescale" }).isChecked());
});

inChromium("a single property that changes is named", async (user) => {
  await user.open(given("check/force_before_contact.osim"));
  await user.proposal.getByRole("button", { name: /^Change the contacts/ }).click();
  await user.outcome.getByText(/^constant_contact_force (×\S+ )?changes\.$/).first().waitFor();
});

inChromium("job: another mass, two actions to the download", async (user) => {
  await user.open(HUMAN);
  await user.button("horse, 545 kg", user.form).click();
  const [file] = await user.downloads(user.button("Download human.scaled.osim", user.acts));
  await makesTheSame("osim-contact-scale rescale human.osim --target-mass 545", [HUMAN], [file]);
});

inChromium("job: contacts that were made for another body, two actions", async (user) => {
  const model = given("check/contacts_of_another_mass.osim", "scaled.osim");
  await user.open(model);
  await user.page.getByText(/^Weighs 90 kg; its contacts are those of Falisse .*, made for 62 kg\.$/).waitFor();
  await user.button("Make the contacts right for 90 kg").click();
  const [file] = await user.downloads(user.button("Download scaled.scaled.osim", user.acts));
  await makesTheSame("osim-contact-scale rescale scaled.osim --contacts-mass 62 --target-mass 90", [model], [file]);
});

inChromium("job: scaled from a model that is open, two actions", async (user) => {
  const files = [SCALED, GENERIC];
  await user.open(...files);
  await user.opened("scaled.osim");
  await user.button("Move the spheres with the bones and make the contacts right for 52 kg").click();
  const [file] = await user.downloads(user.button("Download scaled.scaled.osim", user.acts));
  await makesTheSame("osim-contact-scale transfer scaled.osim --from generic.osim --follow-bodies --level", files, [file]);
});

inChromium("job: no contacts: three ways, each begins where something has to be said", async (user) => {
  await user.open(BARE);
  await user.page.getByText(/it has no contacts\.$/).waitFor();
  for (const [way, field] of [["From a reference", "from"], ["Under its own bones", "feet"], ["From a table", "contacts"]]) {
    await user.page.getByRole("group", { name: "Most likely" }).getByRole("button", { name: way }).click();
    assert.equal(await user.page.evaluate(() => document.activeElement.closest("[id^=form-]").id), `form-${field}`);
  }
});

inChromium("a model without contacts is given some first; when it has them, the form is for its mass", async (user) => {
  const isChecked = (name) => user.form.getByRole("radio", { name, exact: true }).isChecked();
  await user.open(BARE, given("contact_tables/own.csv", "places.csv"));
  assert.ok(await isChecked("Add"));
  await user.verb("Rescale");
  await user.outcome.getByText("First give the model contacts, in step 2.").waitFor();
  await user.verb("Add");
  await user.field("Table of contacts").selectOption("places.csv");
  await user.field("Source of the contacts").selectOption("falisse2022");
  await user.done("bare.scaled.osim");
  // Nothing changes in what is new.
  await user.outcome.getByText(/^1 floor added; \d+ spheres? added; \d+ × SmoothSphereHalfSpaceForce added\.$/).waitFor();
  await user.keep("bare.scaled.osim");
  assert.ok(await isChecked("Rescale"));
  await user.page.getByText(/^Give it contacts of falisse2022.* → bare\.scaled\.osim$/).waitFor();
});

inChromium("job: a library of forty, two actions", { limit: 60_000 }, async (user) => {
  const models = Array.from({ length: 40 }, (_, index) => ({ name: `m${index}.osim`, bytes: HUMAN.bytes }));
  await user.choose(models);
  await user.announced("40 models opened.");
  await user.field("Target mass (kg)").fill("80");
  const [zip] = await user.downloads(user.button("Change all and download a ZIP"));
  assert.equal(zip.name, "models.zip");
});

/** Inside the page: moves a slider to a mass. */
function slideTo(slider, kg) {
  slider.value = String(Math.log10(kg));
  slider.dispatchEvent(new Event("input", { bubbles: true }));
}

inChromium("a mass that is chosen is meant as it is; one that is typed may be in pounds", async (user) => {
  await user.open(HUMAN);
  await user.button("Twice the mass").click();
  await user.done("human.scaled.osim");
  assert.match(await user.spelled(), /--target-mass 124$/);
  // 62 kg are 136.7 lb.
  await user.form.getByRole("slider", { name: "Target mass, slider" }).evaluate(slideTo, 137);
  await user.settled();
  assert.match(await user.spelled(), /--target-mass 13[67](\.\d)? --yes mass-in-pounds$/);
  await user.field("Target mass (kg)").fill("137.0");
  await user.outcome.getByRole("group", { name: /answer/ }).waitFor();
});

inChromium("a number that is proposed is a button", async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("62000");
  await user.button("Use 62 kg", user.outcome).click();
  assert.equal(await user.field("Target mass (kg)").inputValue(), "62");
});

inChromium("by keys alone: the likely job and the download are two actions", async (user) => {
  const model = given("check/contacts_of_another_mass.osim", "scaled.osim");
  await user.open(model);
  const reach = async (name) => {
    for (let count = 0; count < 90; count += 1) {
      await user.page.keyboard.press("Tab");
      if ((await user.page.evaluate(() => document.activeElement.textContent.trim())) === name) return;
    }
    assert.fail(`${name} is not reached`);
  };
  await reach("Make the contacts right for 90 kg");
  await user.page.keyboard.press("Enter");
  await user.done("scaled.scaled.osim");
  await reach("Download scaled.scaled.osim");
  const download = user.page.waitForEvent("download");
  await user.page.keyboard.press("Enter");
  assert.equal((await download).suggestedFilename(), "scaled.scaled.osim");
});

inChromium("who wants no motion sees where the animals end, until they ask", async (user) => {
  const ball = user.page.locator(".animals circle.new").first();
  await ball.waitFor();
  const first = await ball.getAttribute("cy");
  await user.page.waitForTimeout(300);
  assert.equal(await ball.getAttribute("cy"), first);
  await user.button("Let them fall again").click();
  await user.page.waitForFunction((there) => document.querySelector(".animals circle.new").getAttribute("cy") !== there, first);
});

inChromium("verdicts unfold; what is wrong has one button, a remark has none", async (user) => {
  await user.open(HUMAN);
  const good = user.page.locator("#model details.verdict[data-on=good]");
  assert.equal(await good.evaluate((one) => one.open), false);
  await user.unfold("good");
  await good.getByRole("listitem").first().waitFor();
  const proposals = user.proposal.getByRole("group", { name: "Most likely" }).getByRole("button");
  assert.equal(await proposals.count(), 0, "remarks have no remedies");
  await user.choose([given("check/sunk_in.osim")]);
  await user.button("sunk_in.osim").click();
  await user.opened("sunk_in.osim");
  assert.equal(await proposals.count(), 1);
});

inChromium("the body follows the slider, and can be turned by keys and looked at from all sides", async (user) => {
  await user.open(HUMAN);
  const canvas = user.page.getByRole("img", { name: /^12 contact spheres/ });
  const drawn = () => canvas.evaluate((one) => Number(one.dataset.drawn));
  const draws = async (act) => {
    await user.settled();
    const before = await drawn();
    await act();
    await user.page.waitForFunction((count) => Number(document.getElementById("stage-canvas").dataset.drawn) > count, before);
  };
  await draws(() => user.field("Target mass (kg)").fill("500"));
  await canvas.focus();
  for (const key of ["ArrowLeft", "ArrowUp", "Shift+ArrowRight", "+", "-"]) await draws(() => user.page.keyboard.press(key));
  for (const name of ["Side", "Front", "Top", "Left", "Whole body", "Default pose"]) {
    await draws(() => user.page.getByRole("radio", { name, exact: true }).check());
  }
});

inChromium("on a telephone: before and after are in sight, and no text is smaller than 11 pixels", { width: 390, height: 844 }, async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("200");
  await user.done("human.scaled.osim");
  const table = user.result.getByRole("table", { name: /^Numbers that change/ });
  for (const name of ["before", "after"]) {
    const { x, width } = await table.getByRole("columnheader", { name }).boundingBox();
    assert.ok(x + width <= 390, name);
  }
  assert.deepEqual(await user.page.evaluate(smallTexts), []);
  await user.button("Share…", user.acts).click();
  const command = user.page.getByRole("textbox", { name: "Command", exact: true });
  await user.page.waitForFunction((one) => one.value !== "", await command.elementHandle());
  assert.ok(await command.evaluate((one) => one.clientHeight > 30 && one.scrollHeight <= one.clientHeight), "the command is whole");
});

inChromium("on a telephone no table of centres or verdicts is wider than the screen", { width: 390, height: 844 }, async (user) => {
  await user.open(SCALED, GENERIC);
  await user.proposal.getByRole("button", { name: /^Move the spheres/ }).click();
  await user.done("scaled.scaled.osim");
  for (const name of ["Centres that move", "Verdicts"]) {
    const table = user.result.getByRole("group", { name, exact: true });
    await table.scrollIntoViewIfNeeded();
    assert.ok(await table.evaluate((one) => one.scrollWidth <= one.clientWidth), name);
    assert.ok((await table.getByRole("row").count()) === 7, name);
  }
});

inChromium("why a fall cannot be computed is said with the names of fields", async (user) => {
  await user.open(given("bad/mass_missing.osim"));
  await user.page.getByText(/^Contacts of the model: .* give the mass of the model with the field “mass of the model”\.$/).waitFor();
});

/** Inside the page: the visible texts of less than 11 pixels. */
function smallTexts() {
  const all = [...document.querySelectorAll("body *")].filter((one) => one.checkVisibility() && [...one.childNodes].some((child) => child.nodeType === 3 && child.data.trim()));
  const scale = ({ a, b }) => Math.hypot(a, b);
  const pixels = (one) => parseFloat(getComputedStyle(one).fontSize) * (one.closest("svg") ? scale(one.getScreenCTM()) : 1);
  return all.filter((one) => pixels(one) < 10.99).map((one) => `${one.textContent.trim().slice(0, 20)} ${pixels(one)}`);
}

inChromium("what happened last leaves after three seconds", async (user) => {
  await user.open(HUMAN);
  const line = user.page.locator("#announcement");
  assert.equal(await line.evaluate((one) => getComputedStyle(one).opacity), "1");
  await user.page.waitForTimeout(3200);
  assert.equal(await line.evaluate((one) => getComputedStyle(one).opacity), "0");
});

inChromium("a click on a sphere says its numbers", async (user) => {
  await user.open(HUMAN);
  await user.page.getByRole("radio", { name: "Top", exact: true }).check();
  await user.settled();
  const { width, height } = await user.page.locator("#stage-canvas").boundingBox();
  const text = user.page.locator(".stage-clicked");
  for (let place = 0; place < 20 && (await text.textContent()) === ""; place += 1) {
    await user.page.locator("#stage-canvas").click({ position: { x: (width * (place + 0.5)) / 20, y: height / 2 + 0.2 * height * Math.sin(place) } });
  }
  assert.match(await text.textContent(), /^s\d_[rl] on \w+: radius 32 mm, carries 0\.\d+ of the body weight and sinks in 0\.\d+ of its radius$/);
});

inChromium("what the view shows is in words, too: radii before and after, forces that sum to the body weight", async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("496");
  await user.settled();
  await user.page.getByText("The same as text").click();
  const table = user.page.getByRole("group", { name: "Contact spheres as text" }).getByRole("table");
  // The table is filled after it is opened, and `all` does not wait.
  await table.getByRole("cell").first().waitFor();
  const rows = await table.getByRole("row").filter({ has: user.page.getByRole("cell") }).all();
  assert.equal(rows.length, 12);
  const cells = await Promise.all(rows.map((row) => row.getByRole("cell").allTextContents()));
  // Eight times the mass is twice the radius.
  assert.ok(cells.every(([, radius]) => radius === "32 → 64"), cells[0].join());
  const sum = cells.reduce((total, [, , force]) => total + Number(force), 0);
  assert.ok(Math.abs(sum - 1) < 0.01, `the spheres carry ${sum} body weights`);
});

inChromium("a fall is played, before beside after, with what it shows in words", async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("500");
  await user.settled();
  const words = await user.page.locator("#fall-said").textContent();
  const [before, after] = [...words.matchAll(/at most ([\d.]+) body weights, up to ([\d.]+) mm deep \(([\d.]+) of the radius\)/g)];
  // Contacts that are left behind let the heavier body in deeper, in radii; scaled ones fall as they did.
  assert.ok(Number(before[3]) > 2 * Number(after[3]), words);
  const time = user.page.getByRole("slider", { name: "Time of the fall" });
  await user.button("Let it fall").click();
  await user.button("Stop").waitFor();
  await user.page.waitForFunction(() => document.querySelector("[aria-label='Time of the fall']").valueAsNumber > 5);
  await user.button("Stop").click();
  await time.fill("100");
  assert.equal(await time.inputValue(), "100");
});

inChromium("the page begins with three animals that fall", async (user) => {
  await user.page.emulateMedia({ reducedMotion: "no-preference" });
  await user.page.reload();
  const ball = user.page.locator(".animals circle.new").first();
  await ball.waitFor();
  const first = await ball.getAttribute("cy");
  await user.page.waitForFunction((there) => document.querySelector(".animals circle.new").getAttribute("cy") !== there, first);
  const picture = user.page.getByRole("img", { name: /^Falls of a mouse: on contacts of a human it floats/ });
  await picture.waitFor();
  assert.match(await picture.getAttribute("aria-label"), /a giraffe: on contacts of a human it is 2\.28 radii deep/);
  const chooser = user.page.waitForEvent("filechooser");
  await user.page.getByRole("heading", { name: /^Drop a model here/ }).click();
  await chooser;
});

inChromium("a ZIP is opened like the folder in it; a damaged one is said to be so", async (user) => {
  const { zipSync } = await import("../../web/node_modules/fflate/esm/index.mjs");
  await user.drop({ name: "lab.zip", bytes: zipSync({ "lab/human.osim": new Uint8Array(HUMAN.bytes), "lab/notes.docx": new Uint8Array(9) }) });
  await user.opened("lab/human.osim");
  await user.drop({ name: "bad.zip", bytes: zipSync({ "../out.osim": new Uint8Array(HUMAN.bytes) }) });
  await user.announced(/bad\.zip: this ZIP is damaged, a name in it leads out of its folder/);
  await user.drop({ name: "noise.zip", bytes: Buffer.from("no archive") });
  await user.announced(/noise\.zip: this ZIP is damaged/);
  const stored = Buffer.from(zipSync({ "a.osim": [new Uint8Array(HUMAN.bytes), { level: 0 }], "b.osim": new Uint8Array(9) }));
  const changed = Buffer.from(stored);
  changed[1000] ^= 1;
  await user.drop({ name: "changed.zip", bytes: changed });
  await user.announced(/changed\.zip: this ZIP is damaged, a\.osim in it is not what was packed/);
  await user.drop({ name: "twice.zip", bytes: Buffer.from(stored.toString("latin1").replaceAll("b.osim", "a.osim"), "latin1") });
  await user.announced(/twice\.zip: this ZIP has two files called a\.osim/);
});

inChromium("a ZIP with a wrong checksum or size is said to be damaged", async (user) => {
  const { zipSync } = await import("../../web/node_modules/fflate/esm/index.mjs");
  const sound = Buffer.from(zipSync({ "a.osim": new Uint8Array(HUMAN.bytes) }));
  // In the directory of a ZIP, an entry begins with PK 1 2; these numbers are so many bytes after its begin.
  const entry = sound.lastIndexOf("PK\x01\x02", "latin1");
  for (const [name, at, by] of [
    ["checksum", 16, 1],
    ["packed_size", 20, -100],
    ["shorter", 24, -1],
    ["longer", 24, 1],
    ["empty", 24, -HUMAN.bytes.length],
  ]) {
    const damaged = Buffer.from(sound);
    damaged.writeUInt32LE((damaged.readUInt32LE(entry + at) + by) >>> 0, entry + at);
    await user.drop({ name: `${name}.zip`, bytes: damaged });
    await user.announced(new RegExp(`${name}\\.zip: this ZIP is damaged`));
  }
  await user.drop({ name: "torn.zip", bytes: sound.subarray(0, -30) });
  await user.announced(/torn\.zip: this ZIP is damaged/);
  await user.drop({ name: "sound.zip", bytes: sound });
  await user.opened("a.osim");
});

inChromium("1,500 is asked about: it may be either", async (user) => {
  await user.open(HUMAN);
  await user.field("Target mass (kg)").fill("1,500");
  await user.form.getByRole("alert").filter({ hasText: "Write 1500, or 1.500 with a decimal point: the comma can mean either." }).waitFor();
});

inChromium("without meshes a body has capsules for limbs and a wedge for each foot; with meshes, bones", async (user) => {
  const drawn = (shapes) => user.page.waitForFunction((text) => new RegExp(text).test(document.getElementById("stage-canvas").dataset.shapes), shapes);
  await user.open(HUMAN);
  await drawn("^0 bones, 2 wedges, [1-9][0-9]* capsules$");
  await user.button("Close human.osim").click();
  await user.open(BARE, ...["r_human_foot", "l_human_foot", "r_human_toes", "l_human_toes"].map((name) => given(`feet/Geometry/${name}.vtp`)));
  await drawn("^4 bones, 0 wedges, ");
});

inChromium("new spheres have a floor under them and feet around them before they are kept", async (user) => {
  await user.open(BARE);
  const canvas = user.page.locator("#stage-canvas");
  assert.equal(await canvas.getAttribute("data-floor"), null);
  await user.choose([GENERIC], user.button("Add a file… for “Source of the contacts”"));
  await user.done("bare.scaled.osim");
  assert.ok(Number(await canvas.getAttribute("data-floor")) > 0.5);
  assert.match(await canvas.getAttribute("data-shapes"), /^0 bones, 2 wedges, /);
});

inChromium("meshes that are not here are named", async (user) => {
  await user.open(BARE);
  await user.page.getByText(/^To see its bones, open the folder Geometry, too\. Not here: .*r_human_foot\.vtp/).waitFor();
});

testWith({}, "without WebGL the drawings of the feet stand there, and all else works", async () => {
  const { context, page, watched } = await openWindow();
  await page.addInitScript(() => {
    const plain = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
      return kind === "webgl2" ? null : plain.call(this, kind, ...rest);
    };
  });
  await page.goto(PAGE_ADDRESS);
  await page.locator("html[data-ready]").waitFor({ state: "attached" });
  const user = new User(page, context, watched);
  await user.open(HUMAN);
  await user.details.getByRole("img", { name: "Feet" }).waitFor();
  assert.equal(await page.locator("#stage-canvas").count(), 0);
  await user.field("Target mass (kg)").fill("500");
  await user.done("human.scaled.osim");
  assert.deepEqual(watched.problems, []);
  await context.close();
});

inChromium("the manual is in the page", async (user) => {
  await user.button("Manual", user.page).click();
  const manual = user.page.getByRole("dialog", { name: "Manual of this page" });
  await manual.getByRole("heading", { name: "A first change" }).waitFor();
  // Nothing of it leads to a file that is not there.
  const links = await manual.locator("a").evaluateAll((all) => all.map(({ href }) => href));
  assert.deepEqual(links.filter((link) => !link.startsWith("https://")), []);
  assert.equal(await manual.locator("img").count(), 0);
  await user.page.keyboard.press("Escape");
  await manual.waitFor({ state: "hidden" });
});
