// Measures the page in Chromium: node dev/benches/web.mjs
//
// Ready from a local file, opening the published model of 670 kB, a step of the slider, and the size of the file, each
// against its limit, and against the command as a process on the same model in the same run. Needs what tests/web needs.

import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, statSync } from "node:fs";
import { loadavg, tmpdir } from "node:os";
import { join } from "node:path";

import { launch, pageIn } from "../../tests/web/support/launch.mjs";
import { CORPUS, fixture, lacking, PAGE, PROGRAM } from "../../tests/web/support/places.mjs";

const ROUNDS = 15;
const STEPS = 200;
const LIMITS = { ready: 300, open: 500, step: 16, stepLate: 33, size: 3_000_000 };
/** Bones in the view, each with the same mesh. */
const BONES = 20;
const MODEL = CORPUS ? join(CORPUS, "v40000_falisse_2022_human.osim") : fixture("table1/human_62kg_smooth_sphere.osim");
const NAME = MODEL.split("/").pop();

/** The value that this share of the values does not exceed. */
function quantile(values, share) {
  const sorted = [...values].sort((one, other) => one - other);
  return sorted[Math.min(sorted.length - 1, Math.ceil(share * sorted.length) - 1)];
}

const median = (values) => quantile(values, 0.5);

/** Starts the page and opens the first model in it; and runs the command by turns. */
async function startAndOpen(browser, times, folder) {
  const user = await pageIn(browser);
  times.ready.push(await user.page.evaluate(() => performance.getEntriesByName("ready")[0].startTime));
  await user.choose(MODEL);
  await user.opened(NAME);
  times.open.push(await lastMeasure(user, "open"));
  await user.context.close();
  times.inspect.push(command(folder, "inspect", MODEL));
  times.rescale.push(command(folder, "rescale", MODEL, "--target-mass", "80", "-d", folder, "--force", "--quiet"));
}

/** The page in a tab of a browser that runs, as people open it: the browser's own processes are there already. */
async function inRunningBrowser(browser) {
  const { page, context } = await pageIn(browser);
  const address = page.url();
  const ready = [];
  for (let round = 0; round < ROUNDS; round += 1) {
    await page.goto("about:blank");
    await page.goto(address);
    await page.waitForFunction(() => document.documentElement.dataset.ready === "true");
    ready.push(await page.evaluate(() => performance.getEntriesByName("ready")[0].startTime));
  }
  await context.close();
  return ready;
}

function lastMeasure(user, name) {
  return user.page.evaluate((one) => performance.getEntriesByName(one, "measure").at(-1).duration, name);
}

/** How long the command takes as a process, in milliseconds. */
function command(folder, ...words) {
  const start = performance.now();
  const { status, stderr } = spawnSync(PROGRAM, words, { cwd: folder, encoding: "utf8", stdio: ["ignore", "pipe", "pipe"] });
  if (status !== 0) throw new Error(stderr);
  return performance.now() - start;
}

/** The model, and meshes under names that it has. */
function withBones() {
  const bytes = readFileSync(MODEL);
  const named = [...bytes.toString().matchAll(/<mesh_file>\s*([^<\s]+)\s*<\/mesh_file>/g)].map(([, name]) => name);
  const mesh = readFileSync(fixture("feet/Geometry/r_human_foot.vtp"));
  return [{ name: NAME, bytes }, ...[...new Set(named)].slice(0, BONES).map((name) => ({ name, bytes: mesh }))];
}

/** Steps of the slider one after the other: with the body on the screen, or the plots, or neither. */
async function steps(browser, seen) {
  const user = await pageIn(browser);
  await user.open(...withBones());
  await user.field("Target mass (kg)").fill("80");
  await user.done(NAME.replace(".osim", ".scaled.osim"));
  if (seen === "plots") await user.result.getByRole("img", { name: "Force against indentation" }).scrollIntoViewIfNeeded();
  if (seen === "neither") await user.page.getByRole("contentinfo").scrollIntoViewIfNeeded();
  await user.settled();
  const taken = await user.page.evaluate(moveSlider, STEPS);
  await user.context.close();
  return taken;
}

/** Inside the page: moves the slider, waits for what is measured, and for the picture, and moves it again; gives both times of each step. */
async function moveSlider(count) {
  const slider = document.querySelector("input[type=range]");
  const gl = document.getElementById("stage-canvas")?.getContext("webgl2");
  const measured = () => performance.getEntriesByName("step", "measure").length;
  performance.clearMeasures("step");
  const start = slider.valueAsNumber;
  const drawn = [];
  for (let step = 1; step <= count; step += 1) {
    const begin = performance.now();
    slider.value = String(start + 0.005 * ((step % 100) + 1));
    slider.dispatchEvent(new Event("input", { bubbles: true }));
    while (measured() < step) await new Promise((resolve) => setTimeout(resolve, 0));
    await new Promise((resolve) => requestAnimationFrame(resolve));
    gl?.finish();
    drawn.push(performance.now() - begin);
  }
  return { steps: performance.getEntriesByName("step", "measure").map(({ duration }) => duration), drawn };
}

function row(what, value, limit, unit, note = "") {
  const shown = [value, limit].map((one) => (one === undefined ? "" : unit === "B" ? String(one) : one.toFixed(1)));
  const ratio = limit === undefined ? "" : (value / limit).toFixed(2);
  const missed = limit !== undefined && value > limit ? "missed" : "";
  console.log(`${what.padEnd(52)} ${shown[0].padStart(9)} ${shown[1].padStart(9)} ${unit.padEnd(2)} ${ratio.padStart(6)}  ${missed}${note}`);
}

const why = lacking();
if (why) {
  console.error(`error: ${why}`);
  process.exit(2);
}
console.log(`${NAME}, ${statSync(MODEL).size} bytes${CORPUS ? "" : " (OSIM_CORPUS is not set)"}; load ${loadavg()[0].toFixed(2)}`);
const folder = mkdtempSync(join(tmpdir(), "osim-web-bench-"));
const browser = await launch();
const times = { ready: [], open: [], inspect: [], rescale: [] };
for (let round = 0; round < ROUNDS; round += 1) await startAndOpen(browser, times, folder);
const running = await inRunningBrowser(browser);
const [body, plots, neither] = [await steps(browser, "body"), await steps(browser, "plots"), await steps(browser, "neither")];
await browser.close();
rmSync(folder, { recursive: true });

console.log(`${"".padEnd(52)} ${"median".padStart(9)} ${"limit".padStart(9)}    ${"ratio".padStart(6)}`);
row("size of the page", statSync(PAGE).size, LIMITS.size, "B");
row("ready, from a local file", median(running), LIMITS.ready, "ms");
row("the same as the first page of a new browser profile", median(times.ready), undefined, "ms");
row("the model is open", median(times.open), LIMITS.open, "ms");
row(`slider step, the body with ${BONES} bones on the screen`, median(body.steps), LIMITS.step, "ms");
row("the same, 95 % of the steps within", quantile(body.steps, 0.95), LIMITS.stepLate, "ms");
row("the same until it is drawn, by a processor", median(body.drawn), LIMITS.step, "ms");
row("the same, 95 % of the steps within", quantile(body.drawn, 0.95), LIMITS.stepLate, "ms");
row("slider step, plots on the screen", median(plots.steps), LIMITS.step, "ms");
row("the same, 95 % of the steps within", quantile(plots.steps, 0.95), LIMITS.stepLate, "ms");
row("slider step, neither on the screen", median(neither.steps), LIMITS.step, "ms");
row("the same, 95 % of the steps within", quantile(neither.steps, 0.95), LIMITS.stepLate, "ms");
const against = (own, process) => `${(median(own) / median(process)).toFixed(2)} times as long`;
row("the command: inspect", median(times.inspect), undefined, "ms", `opening in the page: ${against(times.open, times.inspect)}`);
row("the command: rescale and write", median(times.rescale), undefined, "ms", `a step: ${against(body.steps, times.rescale)}`);
