// Published models one by one, with the buttons for one model: rows are clicked, results are downloaded.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";

import { inChromium } from "./support/chromium.mjs";
import { Folder } from "./support/command.mjs";
import { CORPUS, published } from "./support/places.mjs";
import { refusal, sameReason } from "./support/refusals.mjs";
import { fillIn, VERBS } from "./support/verbs.mjs";

// published.test.mjs has the files of all verbs.
const TESTED_VERBS = ["rescale"];
// Making a report takes longer than anything else.
const REPORTED_MODELS = ["v40000_falisse_2022_human.osim", "v30000_scone_h0914m.osim", "v40000_opencap_lai_arnold_crlf.osim"];
const NAMES = CORPUS ? readdirSync(CORPUS).filter((name) => name.endsWith(".osim")) : [];

inChromium("each published model is downloaded by its button", { corpus: true, limit: 120_000 }, async (user, test) => {
  const models = NAMES.map((name) => ({ name, bytes: readFileSync(published(name)) }));
  const folder = new Folder(...models);
  await user.choose(models);
  await user.announced(`${models.length} models opened.`);
  for (const verb of VERBS.filter(({ name }) => TESTED_VERBS.includes(name))) {
    await test.test(verb.name, async () => {
      await fillIn(user, verb);
      for (const { name } of models) {
        await user.button(name, user.region(`${models.length} models`)).click();
        await user.opened(name);
        await compareVerb(user, folder, verb, name);
        folder.clear();
      }
    });
  }
  folder.end();
});

async function compareVerb(user, folder, { name: verb, words }, model) {
  const refused = refusal(await folder.run(verb, model, ...words, "--format", "json"));
  if (refused) {
    assert.equal(await user.settled(), "failed", `${model}: ${refused.message}`);
    const message = await user.outcome.getByRole("alert").getByRole("paragraph").first().innerText();
    assert.ok(sameReason(refused.message, message), `${refused.message}\n${message}`);
    return;
  }
  const result = model.replace(/\.osim$/, ".scaled.osim");
  // The button has the name of this model's result, so it is not the one of the model before.
  const [download] = await user.downloads(user.button(`Download ${result}`, user.acts));
  assert.equal(download.name, result);
  assert.ok(folder.read(result).equals(download.bytes), `${model}: the files differ`);
  if (REPORTED_MODELS.includes(model)) await compareReport(user, folder, [verb, model, ...words]);
}

/** Asserts that the report of the page equals the file that --report writes. */
async function compareReport(user, folder, words) {
  const [report] = await user.downloads(user.button("Report about the change", user.acts));
  folder.clear();
  await folder.run(...words, "--report", report.name);
  const [page, command] = [report.bytes.toString(), folder.read(report.name).toString()];
  assert.equal(page, command, `${report.name} differs`);
}
