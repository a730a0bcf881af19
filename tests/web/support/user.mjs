// Actions of a user on the page. Elements are found by their role and name.

import { readFile } from "node:fs/promises";

const QUIET_MS = 300;

export class User {
  constructor(page, context, watched) {
    Object.assign(this, { page, context, watched });
    // Else the browser may show its own window before somebody waits for it.
    page.on("filechooser", () => undefined);
    this.started = [];
    page.on("download", (download) => {
      this.started.push(download);
      this.onDownload?.();
    });
  }

  button(name, within = this.page) {
    return within.getByRole("button", { name, exact: typeof name === "string" });
  }

  region(name) {
    return this.page.getByRole("region", { name, exact: typeof name === "string" });
  }

  get result() {
    return this.region("What would change");
  }

  /** The third step: what becomes of the change, with its verdicts, errors and questions. */
  get outcome() {
    return this.region("The result");
  }

  /** The second step: the original, and the button for what the check proposes. */
  get proposal() {
    return this.page.locator("#proposal");
  }

  /** Clicks what the check proposes, keeps it, and waits for the model that it makes. */
  async keepProposal(name) {
    await this.proposal.getByRole("group", { name: "Most likely" }).getByRole("button").click();
    await this.done(name);
    await this.keep(name);
  }

  /** The buttons that are always in sight. */
  get acts() {
    return this.page.getByRole("group", { name: "What to do with this model" });
  }

  get form() {
    return this.region("Change this model");
  }

  /** Drops files on the page: real File objects in a real DataTransfer. */
  async drop(...files) {
    const given = files.map(({ name, bytes }) => ({ name, base64: Buffer.from(bytes).toString("base64") }));
    await this.page.evaluate((all) => {
      const transfer = new DataTransfer();
      for (const { name, base64 } of all) {
        const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
        transfer.items.add(new File([bytes], name));
      }
      for (const kind of ["dragenter", "dragover", "drop"]) {
        document.body.dispatchEvent(new DragEvent(kind, { dataTransfer: transfer, bubbles: true, cancelable: true }));
      }
    }, given);
  }

  /** Drops files and folders of the disk, as a desktop does: they are real entries then. */
  async dropFromDisk(...paths) {
    const session = await this.page.context().newCDPSession(this.page);
    const data = { items: [], files: paths, dragOperationsMask: 1 };
    for (const type of ["dragEnter", "dragOver", "drop"]) {
      await session.send("Input.dispatchDragEvent", { type, x: 200, y: 200, data });
    }
    await session.detach();
  }

  /** Chooses files by a button that opens the browser's own window. */
  async choose(files, by = this.button("Open files…")) {
    const chooser = this.page.waitForEvent("filechooser");
    await by.click();
    await (await chooser).setFiles(typeof files === "string" ? files : files.map(asPayload));
  }

  /** Opens files, and waits until the page shows all models among them. */
  async open(...files) {
    await this.choose(files);
    await this.announced(/opened|added/);
    await this.opened(files.find(({ name }) => name.endsWith(".osim")).name);
  }

  /** Waits until a model is shown; returns its region of the page. */
  async opened(name) {
    const region = this.region(name);
    await region.locator("details.verdict").first().waitFor();
    return region;
  }

  async verb(name) {
    await this.form.getByRole("radio", { name, exact: true }).check();
  }

  field(name, within = this.form) {
    return within.getByLabel(name, { exact: typeof name === "string" });
  }

  /** Ticks values of a field that takes several. */
  async tick(field, ...values) {
    const group = this.form.getByRole("group").filter({ hasText: field }).last();
    await group.locator("summary").click();
    for (const value of values) await group.getByRole("checkbox", { name: value, exact: true }).check();
  }

  /** Waits until the result belongs to the present form and nothing moves any more; returns the state of the result. */
  async settled() {
    return this.page.evaluate(async (quiet) => {
      const result = document.getElementById("result");
      let since = performance.now();
      let update = result.dataset.update;
      while (performance.now() - since < quiet) {
        await new Promise((resolve) => setTimeout(resolve, 15));
        if (update === result.dataset.update && document.getElementById("working").hidden) continue;
        [since, update] = [performance.now(), result.dataset.update];
      }
      return result.dataset.state;
    }, QUIET_MS);
  }

  /** Waits for a result with this file; returns the button that downloads it. */
  async done(name) {
    const button = this.button(`Download ${name}`, this.acts);
    await button.waitFor();
    await this.settled();
    return button;
  }

  /** Keeps the result, and waits until the page shows the changed model and its name has the focus. */
  async keep(name) {
    await this.button("Keep and continue", this.acts).click();
    await this.opened(name);
    await this.page.waitForFunction((one) => document.activeElement.textContent === one, name);
  }

  /** Clicks a button, and returns the downloaded files when there are `count`. */
  async downloads(button, count = 1) {
    this.started = [];
    const all = new Promise((resolve) => (this.onDownload = () => this.started.length === count && resolve()));
    await button.click();
    await all;
    return Promise.all(this.started.map(async (one) => ({ name: one.suggestedFilename(), bytes: await readFile(await one.path()) })));
  }

  /** The change as a call in a language, as the page shows it. */
  async spelled(language = "Command") {
    await this.button("Share…", this.acts).click();
    const dialog = this.page.getByRole("dialog", { name: "Share" });
    const text = dialog.getByRole("textbox", { name: language, exact: true });
    await this.page.waitForFunction((one) => one.value !== "", await text.elementHandle());
    const spelled = await text.inputValue();
    await this.button("Close", dialog).click();
    return spelled;
  }

  /** Unfolds a row of verdicts about the model. */
  async unfold(row) {
    await this.page.locator(`#model details.verdict[data-on=${row}] summary`).first().click();
  }

  get details() {
    return this.region("The model in detail");
  }

  /** Opens the groups further down in the form. */
  async more() {
    await this.form.getByText("More options").click();
  }

  /** Waits until the page announces a text to screen readers. */
  async announced(text) {
    await this.page.getByRole("status").filter({ hasText: text }).first().waitFor({ state: "attached" });
  }
}

function asPayload({ name, bytes }) {
  return { name, mimeType: "application/octet-stream", buffer: Buffer.from(bytes) };
}
