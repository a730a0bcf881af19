// The commonest jobs, by mouse and by keys: how many actions each takes, from the empty page to what is wanted, and how many of them
// are wrong turns, after which the page shows an error.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";

import { inChromium } from "./support/chromium.mjs";
import { Folder, makesTheSame } from "./support/command.mjs";
import { given } from "./support/places.mjs";
import { unzipped } from "./support/unzip.mjs";

const SCALED = given("scale_tool/scaled_smooth.osim", "scaled.osim");
const GENERIC = given("scale_tool/generic_smooth.osim", "generic.osim");
const HUMAN = given("table1/human_62kg_smooth_sphere.osim", "human.osim");
const RECORDING = ["walker.osim", "walk.mot", "plates.sto", "plates.xml"].map((name) => given(`motion/${name}`));
const OPEN = "Open files…";
const ADD_ORIGINAL = "Add a file… for “Model that it was scaled from”";
const FOLLOW = "Move the spheres with the bones and make the contacts right for 52 kg";

/** Each job: its actions, and what shows that it is done. */
const JOBS = {
  "check a scaled model": {
    most: 2,
    act: async (hand) => {
      await hand.choose(OPEN, SCALED);
      await hand.choose(ADD_ORIGINAL, GENERIC);
      await hand.user.region("scaled.osim").getByText("6 of 6 spheres did not follow the bones").first().waitFor();
    },
  },
  "make its contacts follow": {
    most: 4,
    act: async (hand) => {
      await hand.choose(OPEN, SCALED);
      await hand.choose(ADD_ORIGINAL, GENERIC);
      await hand.press(FOLLOW);
      await hand.user.outcome.getByText(/^floor, .*sizes/).waitFor();
      const file = await hand.download("Download scaled.scaled.osim");
      await makesTheSame("osim-contact-scale transfer scaled.osim --from generic.osim --follow-bodies --level", [SCALED, GENERIC], [file]);
    },
  },
  "another mass": {
    most: 3,
    act: async (hand) => {
      await hand.choose(OPEN, HUMAN);
      await hand.type("Target mass (kg)", "80");
      const file = await hand.download("Download human.scaled.osim");
      await makesTheSame("osim-contact-scale rescale human.osim --target-mass 80", [HUMAN], [file]);
    },
  },
  "a model without contacts": {
    most: 3,
    act: async (hand) => {
      const folder = new Folder(GENERIC);
      await folder.run("remove", "generic.osim", "-o", "bare.osim");
      const bare = { name: "bare.osim", bytes: folder.read("bare.osim") };
      folder.end();
      await hand.choose(OPEN, bare);
      await hand.choose("Add a file… for “Source of the contacts”", GENERIC);
      const file = await hand.download("Download bare.scaled.osim");
      await makesTheSame("osim-contact-scale add bare.osim --from generic.osim", [bare, GENERIC], [file]);
    },
  },
  "a folder of scaled subjects": {
    most: 2,
    act: async (hand) => {
      const subjects = ["s1.osim", "s2.osim", "s3.osim"].map((name) => ({ ...SCALED, name }));
      const folder = new Folder(GENERIC, ...subjects.map((one) => ({ ...one, name: `subjects/${one.name}` })));
      await hand.choose(OPEN, GENERIC, ...subjects);
      const zip = await hand.download("Move the spheres of 3 models with the bones, and download a ZIP");
      const { status, stderr } = await folder.run("transfer", "subjects", "--from", "generic.osim", "--follow-bodies", "--level", "-d", "out");
      assert.equal(status, 0, stderr);
      const files = unzipped(zip.bytes);
      assert.deepEqual([...files.keys()].sort(), ["s1.scaled.osim", "s2.scaled.osim", "s3.scaled.osim"]);
      for (const [name, bytes] of files) assert.ok(folder.read(`out/${name.replace(".scaled", "")}`).equals(bytes), name);
      folder.end();
    },
  },
  "a recording with plates": {
    most: 2,
    act: async (hand) => {
      await hand.choose(OPEN, ...RECORDING);
      await hand.user.page.locator(".recording-words").getByRole("listitem").first().waitFor();
      await hand.press("Play the motion");
      await hand.user.button("Stop").waitFor();
    },
  },
  "a recording that is corrected": {
    most: 3,
    act: async (hand) => {
      await hand.choose(OPEN, ...RECORDING);
      await hand.press("Correct the motion");
      await hand.user.page.locator(".correction .tag.good").waitFor({ timeout: 60_000 });
      const { name } = await hand.download("Download walk.corrected.sto");
      assert.equal(name, "walk.corrected.sto");
    },
  },
};

for (const [name, { most, act }] of Object.entries(JOBS)) {
  for (const Kind of ["mouse", "keys"]) {
    inChromium(`${name}, by ${Kind}: ${most} actions`, { ...(Kind === "mouse" ? { width: 1280, height: 720 } : {}), limit: 120_000 }, async (user, test) => {
      const hand = Kind === "mouse" ? new Mouse(user) : new Keys(user);
      await act(hand);
      const keys = hand.tabs === undefined ? "" : `, ${hand.tabs} times Tab`;
      test.diagnostic(`${name}, by ${Kind}: ${hand.count} actions, ${hand.wrong} wrong turns${keys}`);
      assert.ok(hand.count <= most, `${hand.count} actions`);
      assert.equal(hand.wrong, 0, "wrong turns");
      assert.equal(await user.page.getByRole("alert").filter({ visible: true }).count(), 0, "no error is shown");
    });
  }
}

class Mouse {
  constructor(user) {
    Object.assign(this, { user, count: 0, wrong: 0 });
  }

  async press(name) {
    await this.user.button(name).click();
    await this.countAction();
  }

  /** Counts an action, and whether it was a wrong turn. */
  async countAction() {
    this.count += 1;
    await this.user.settled();
    if ((await this.user.page.getByRole("alert").filter({ visible: true }).count()) > 0) this.wrong += 1;
  }

  /** Opens files by a button: one action with what follows in the window of the browser. */
  async choose(name, ...files) {
    const chooser = this.user.page.waitForEvent("filechooser");
    await this.press(name);
    await (await chooser).setFiles(files.map(({ name: file, bytes }) => ({ name: file, mimeType: "text/xml", buffer: Buffer.from(bytes) })));
  }

  async type(label, text) {
    await this.user.field(label).fill(text);
    await this.countAction();
  }

  async download(name) {
    const download = this.user.page.waitForEvent("download");
    await this.press(name);
    const done = await download;
    return { name: done.suggestedFilename(), bytes: await readFile(await done.path()) };
  }
}

class Keys extends Mouse {
  tabs = 0;

  async press(name) {
    await this.user.button(name).waitFor();
    await this.#reach(name);
    await this.user.page.keyboard.press("Enter");
    await this.countAction();
  }

  async type(label, text) {
    await this.user.field(label).waitFor();
    await this.#reach(label);
    await this.user.page.keyboard.type(text);
    await this.countAction();
  }

  /** Presses Tab until the control with this name has the focus. */
  async #reach(name) {
    for (let count = 0; count < 150; count += 1) {
      const now = await this.user.page.evaluate(() => {
        const one = document.activeElement;
        return (one.ariaLabel ?? one.labels?.[0]?.textContent ?? one.textContent).trim().replace(/\s+/g, " ");
      });
      if (now === name) return;
      this.tabs += 1;
      await this.user.page.keyboard.press("Tab");
    }
    assert.fail(`${name} is not reached`);
  }
}
