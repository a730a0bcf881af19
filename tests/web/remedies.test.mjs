// Every remedy that the page offers, on our models and on published ones: applied by the page's engine, and then each of the verbs. A verb
// that the model allowed before is allowed after it.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";

import { CORPUS, fixture, ROOT } from "./support/places.mjs";
import { testWith } from "./support/skipping.mjs";

const ENGINE = join(ROOT, "target/web/engine");
const NEXT_REMEDIES = [
  { verb: "rescale", target_mass: 75 }, { verb: "transfer", from: "falisse2022" }, { verb: "set", set: { dissipation: "x1.1" } },
  { verb: "design", indentation: 0.16 }, { verb: "convert", to: "hunt-crossley" }, { verb: "convert", to: "smooth" }, { verb: "remove" },
];

const osims = (folder) => readdirSync(folder).filter((name) => name.endsWith(".osim")).map((name) => join(folder, name));

testWith({}, "remedies of our models: each can be applied, and blocks no verb", async (context) => tryRemedies(context, osims(fixture("check")), 10));

testWith({ corpus: true }, "remedies of published models: each can be applied, and blocks no verb", async (context) => tryRemedies(context, osims(CORPUS), 0));

/** Applies all remedies of the models at `paths`. There must be at least `least` remedies; published models may have none. */
async function tryRemedies(context, paths, least) {
  // Its file has no ending by which Node would know that it is a module.
  const binding = readFileSync(join(ENGINE, "osim_web.js"), "utf8");
  const { initSync, Engine } = await import(`data:text/javascript,${encodeURIComponent(binding)}`);
  initSync({ module: readFileSync(join(ENGINE, "osim_web_bg.wasm")) });
  const counts = { models: 0, remedies: 0, verbs: 0 };
  const blocked = [];
  for (const path of paths) {
    const bytes = readFileSync(path);
    const found = remediesOf(Engine, bytes);
    if (found.length === 0) continue;
    counts.models += 1;
    const before = refusalsOfVerbs(engineWith(Engine, bytes), "model.osim");
    for (const { text, request } of found) {
      const engine = engineWith(Engine, bytes);
      const changed = ask(engine, { do: "change", request, parts: [] });
      if (changed.error) {
        blocked.push(`${path}: ${text} ${changed.error.message}`);
        continue;
      }
      const { ok: kept } = ask(engine, { do: "keep" });
      counts.remedies += 1;
      const after = refusalsOfVerbs(engine, kept.model);
      for (const [index, refused] of after.entries()) {
        counts.verbs += 1;
        if (refused && !before[index]) blocked.push(`${path}: ${text} Then ${NEXT_REMEDIES[index].verb}: ${refused.message}`);
      }
      engine.free();
    }
  }
  context.diagnostic(`${counts.remedies} remedies of ${counts.models} models, ${counts.verbs} verbs after them`);
  assert.ok(counts.remedies >= least, `${counts.remedies} remedies`);
  assert.deepEqual(blocked, []);
}

function engineWith(Engine, bytes) {
  const engine = new Engine();
  engine.set_today("2026-01-01");
  engine.put("model.osim", bytes);
  return engine;
}

function ask(engine, question) {
  return JSON.parse(engine.call(JSON.stringify(question)));
}

/** The findings with a button: errors and warnings with a remedy, but no remarks. */
function remediesOf(Engine, bytes) {
  const engine = engineWith(Engine, bytes);
  const { ok } = ask(engine, { do: "look", model: "model.osim", parts: [] });
  engine.free();
  return (ok?.findings ?? []).filter(({ remedy, severity }) => remedy && severity !== "remark").map(({ remedy }) => remedy);
}

/** The reason why each verb is refused; undefined for a verb that is not refused. */
function refusalsOfVerbs(engine, model) {
  return NEXT_REMEDIES.map((request) => ask(engine, { do: "change", request: { ...request, models: [model] }, parts: [] }).error);
}
