// Published models, all verbs: page and command make the same files, and refuse the same changes.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";

import { inChromium } from "./support/chromium.mjs";
import { Folder } from "./support/command.mjs";
import { CORPUS, published } from "./support/places.mjs";
import { refusal, sameReason } from "./support/refusals.mjs";
import { unzipped } from "./support/unzip.mjs";
import { fillIn, VERBS } from "./support/verbs.mjs";

const NAMES = CORPUS ? readdirSync(CORPUS).filter((name) => name.endsWith(".osim")) : [];

inChromium("all verbs on all published models", { corpus: true, limit: 120_000 }, async (user, test) => {
  const models = NAMES.map((name) => ({ name, bytes: readFileSync(published(name)) }));
  assert.ok(models.length >= 27, `${models.length} models`);
  const folder = new Folder(...models);
  const count = `${models.length} models`;
  await user.choose(models);
  await user.announced(`${count} opened.`);
  const tallies = [];
  for (const verb of VERBS) {
    await test.test(verb.name, async () => {
      await fillIn(user, verb);
      const all = user.button("Change all and download a ZIP", user.region(count));
      const [zip] = await user.downloads(all);
      const files = unzipped(zip.bytes);
      const rows = await rowsOf(user, count);
      assert.equal(rows.length, models.length);
      const problems = [];
      for (const row of rows) problems.push(...(await compareVerb(folder, verb, row, files)));
      assert.deepEqual(problems, []);
      assert.equal(files.size, 0, `nothing else is in the archive: ${[...files.keys()]}`);
      tallies.push(rows.filter(({ message }) => !message).length);
    });
  }
  folder.end();
  test.diagnostic(`${tallies.reduce((sum, one) => sum + one, 0)} of ${models.length * VERBS.length} were changed, the others refused`);
});

/** The row of the page's table about each model. */
async function rowsOf(user, title) {
  const rows = await user.region(title).getByRole("row").filter({ has: user.page.getByRole("rowheader") }).all();
  return Promise.all(rows.map((row) => row.evaluate((one) => ({
    model: one.querySelector("th").textContent,
    outcome: one.querySelector(".outcome").textContent,
    message: one.querySelector(".outcome .message")?.textContent,
    place: one.querySelector(".outcome .quiet code")?.textContent,
  }))));
}

/** The differences between page and command for one model, whose result is removed from `files`. */
async function compareVerb(folder, { name: verb, words }, { model, message, place, outcome }, files) {
  const result = model.replace(/\.osim$/, ".scaled.osim");
  // Into another folder the command writes what needs no change, too: all results are there, as in the archive.
  const refused = refusal(await folder.run(verb, model, ...words, "--format", "json", "-d", "out"));
  const [bytes, made] = [files.get(result), folder.made()[0] && folder.read(`out/${model}`)];
  files.delete(result);
  folder.clear();
  if (refused || message) return [...differences(refused, message, place, bytes)].map((text) => `${model}: ${text}`);
  if (!bytes || !made) return bytes || made ? [`${model}: only ${made ? "the command" : "the page"} makes a file (${outcome})`] : [];
  return bytes.equals(made) ? [] : [`${model}: the files differ`];
}

function* differences(refused, message, place, bytes) {
  if (!refused || !message) return yield `only ${refused ? "the command" : "the page"} refuses: ${refused?.message ?? message}`;
  if (bytes) yield "the archive has a file of a model that failed";
  if (!sameReason(refused.message, message)) yield `other reasons:\n  ${refused.message}\n  ${message}`;
  const [, line, column] = /:(\d+):(\d+)$/.exec(place ?? "") ?? [];
  if (Number(line ?? 0) !== (refused.line ?? 0) || Number(column ?? 0) !== (refused.column ?? 0)) {
    yield `other places: ${refused.line}:${refused.column}, ${place}`;
  }
}
