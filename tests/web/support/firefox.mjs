// Firefox with the page in it, driven by WebDriver BiDi.

import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { setTimeout as wait } from "node:timers/promises";

import puppeteer from "puppeteer-core";

import { FIREFOX, PAGE_ADDRESS } from "./places.mjs";

const PATIENCE_MS = 15_000;

/** Opens the page in its own browser, which downloads files into a temporary folder. */
export async function openFirefox() {
  const downloads = mkdtempSync(join(tmpdir(), "osim-web-firefox-"));
  const browser = await puppeteer.launch({
    browser: "firefox", executablePath: FIREFOX, headless: true,
    extraPrefsFirefox: {
      "browser.download.folderList": 2, "browser.download.dir": downloads, "browser.download.useDownloadDir": true,
      "browser.download.always_ask_before_handling_new_types": false, "browser.helperApps.neverAsk.saveToDisk": "application/xml,text/html",
      "browser.download.alwaysOpenPanel": false,
    },
  });
  const page = await browser.newPage();
  await page.setViewport({ width: 1280, height: 900 });
  const watched = { requests: [], problems: [] };
  page.on("request", (request) => watched.requests.push(request.url()));
  page.on("pageerror", (error) => watched.problems.push(String(error)));
  page.on("console", (message) => ["error", "warn"].includes(message.type()) && watched.problems.push(message.text()));
  page.setDefaultTimeout(PATIENCE_MS);
  await page.goto(PAGE_ADDRESS);
  await page.waitForSelector("html[data-ready]");
  return new FirefoxUser(browser, page, watched, downloads);
}

class FirefoxUser {
  constructor(browser, page, watched, downloads) {
    Object.assign(this, { browser, page, watched, downloads });
  }

  /** The visible element of this kind and name. */
  async find(kind, name) {
    const handle = await this.page.waitForFunction(visibleElement, { polling: 50 }, kind, name);
    return handle.asElement();
  }

  async click(name) {
    await (await this.find("button", name)).evaluate((one) => (one.focus(), one.click()));
  }

  async fill(label, text) {
    await (await this.find("textbox", label)).focus();
    await this.page.keyboard.type(text);
  }

  /** Chooses files by the button for it. */
  async choose(...files) {
    const folder = mkdtempSync(join(tmpdir(), "osim-web-chosen-"));
    for (const { name, bytes } of files) writeFileSync(join(folder, name), bytes);
    const input = await this.page.waitForSelector("#files-input", { visible: false });
    await input.uploadFile(...files.map(({ name }) => join(folder, name)));
    return () => rmSync(folder, { recursive: true });
  }

  /** Waits until the page contains a text. */
  async text(text) {
    await this.page.waitForFunction((one) => document.body.innerText.includes(one), {}, text);
  }

  /** Waits for a download of this name; returns its bytes. */
  async downloaded(name) {
    for (const end = Date.now() + PATIENCE_MS; Date.now() < end; await wait(50)) {
      const names = readdirSync(this.downloads);
      if (names.includes(name) && !names.some((one) => one.endsWith(".part"))) {
        const bytes = readFileSync(join(this.downloads, name));
        if (bytes.length > 0) return bytes;
      }
    }
    throw new Error(`${name} was not downloaded: ${readdirSync(this.downloads)}`);
  }

  async end() {
    await this.browser.close();
    rmSync(this.downloads, { recursive: true, force: true });
  }
}

/** Runs in the page: finds the visible element of this kind whose label, title or text is `name`. */
function visibleElement(kind, name) {
  const texts = { button: "button", heading: "h1, h2, h3", image: "svg title" };
  const named = kind === "textbox" ? document.querySelectorAll("label") : document.querySelectorAll(texts[kind]);
  const found = [...named].find((one) => one.textContent.trim() === name && one.checkVisibility() !== (kind === "image"));
  return kind === "textbox" ? (found?.control ?? null) : (found ?? null);
}
