// Chromium with the page in it, for tests, benchmark and pictures.

import { chromium } from "playwright-core";

import { CHROMIUM, PAGE_ADDRESS } from "./places.mjs";
import { User } from "./user.mjs";

const BROWSER_ARGUMENTS = [
  "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update",
  "--disable-sync",
];
const PATIENCE_MS = 15_000;

export function launch() {
  return chromium.launch({ executablePath: CHROMIUM, args: BROWSER_ARGUMENTS });
}

/** Opens a window without the page; `watched` records the requests and errors in it. */
export async function windowIn(browser, { width = 1280, height = 900, scheme = "light", permissions = [] } = {}) {
  const viewport = { width, height };
  // Animals that fall while a page starts would keep a processor busy: the test of these asks for motion.
  const context = await browser.newContext({ viewport, colorScheme: scheme, acceptDownloads: true, permissions, reducedMotion: "reduce" });
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE_MS);
  return { context, page, watched: watch(context, page) };
}

/** The page, ready, in a window of its own. */
export async function pageIn(browser, { address = PAGE_ADDRESS, hash = "", ...options } = {}) {
  const { context, page, watched } = await windowIn(browser, options);
  await page.goto(address + hash);
  await page.locator("html[data-ready]").waitFor({ state: "attached" });
  return new User(page, context, watched);
}

function watch(context, page) {
  const watched = { requests: [], problems: [] };
  context.on("request", (request) => watched.requests.push(request.url()));
  context.on("page", (other) => watched.requests.push(`window: ${other.url()}`));
  page.on("websocket", (socket) => watched.requests.push(socket.url()));
  page.on("pageerror", (error) => watched.problems.push(String(error)));
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && !isOfDriver(message) && watched.problems.push(message.text()));
  return watched;
}

/** Whether a message is a warning of the graphics driver that screenshots are slow without a graphics card. */
function isOfDriver(message) {
  return message.text().includes("GPU stall due to ReadPixels");
}
