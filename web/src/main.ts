// Starts the page: checks the browser, starts the engine, and builds the views.

import { redo, undo } from "./actions/apply";
import { LivePreview } from "./actions/live";
import { openFiles, openRead } from "./actions/open";
import { refreshPresets } from "./actions/presets";
import { byId } from "./dom/element";
import { Client } from "./engine/client";
import { toFailure } from "./engine/failure";
import { packed, unpack } from "./engine/unpack";
import { acceptDrops } from "./files/drop";
import type { Source } from "./forms/declaration";
import { Session } from "./state/session";
import { missingSupport } from "./support";
import { actionBar } from "./views/action_bar";
import { wireAddress } from "./views/address";
import { showBusy } from "./views/busy";
import { calculatorView } from "./views/calculator";
import { changeView } from "./views/change";
import { chooseOne, wireButtons } from "./views/choose";
import { showAnnouncements } from "./views/announcement";
import { acceptedFor } from "./views/context";
import { showExplanations } from "./views/explanation";
import { filesView } from "./views/files";
import { footerView } from "./views/footer";
import { manualView } from "./views/manual";
import { wireKeys } from "./views/keys";
import { warnBeforeLeaving } from "./views/leaving";
import { LibraryView } from "./views/library";
import { ModelView } from "./views/model";
import { ProposalView } from "./views/proposal";
import { ResultView } from "./views/result";
import { StageView } from "./views/stage";
import { showFalls } from "./views/start";

const BROWSER_ADVICE = "Please use a newer one. The end of the page lists those that work.";
const EXAMPLE = "human_62kg_smooth_sphere.osim";

function main(): void {
  const missing = missingSupport();
  if (missing.length > 0) return showUnsupported(`This browser lacks what the page needs: ${missing.join(", ")}. ${BROWSER_ADVICE}`);
  start().catch((error) => showUnsupported(`The page could not start: ${toFailure(error).message}`));
}

async function start(): Promise<void> {
  const { startedWorker } = globalThis as unknown as { startedWorker: Promise<Worker> };
  const session = new Session(new Client(await startedWorker));
  // The worker unpacks the engine while this thread makes the page.
  const started = session.engine.start(packed("engine"));
  const buildModelViews = buildPage(session);
  await started;
  void ready(session, buildModelViews);
}

/** Builds the views, and gives what builds those of an open model. */
function buildPage(session: Session): () => void {
  const announceUnreadable = (why: string) => session.announce(`This could not be read: ${why}.`);
  const open = (files: Parameters<typeof openFiles>[1]) => void openFiles(session, files).catch((error) => announceUnreadable(toFailure(error).message));
  const addFile = async (source: Source) => {
    const files = await chooseOne(acceptedFor(source));
    // A model that only gives its contacts is not opened for changes.
    await openFiles(session, files, "keep");
    return files.map(({ name }) => name);
  };
  showBusy(session.engine);
  showExplanations(session);
  new LibraryView(session, addFile);
  new ProposalView(session, addFile);
  new ResultView(session, addFile);
  changeView(session, addFile);
  actionBar(session);
  calculatorView(session, addFile);
  filesView(session);
  footerView();
  manualView();
  showWhatIsOpen(session);
  wireButtons(open);
  acceptDrops(open, announceUnreadable);
  wireKeys(() => undo(session), () => redo(session));
  // A click anywhere in the start area opens the file chooser, except on buttons, links and pictures.
  byId("start").addEventListener("click", ({ target }) => {
    if (!(target instanceof Element && target.closest("button, a, svg"))) byId("choose-files").click();
  });
  byId("try-example").addEventListener("click", () => void openExample(session));
  byId("skip").addEventListener("click", (event) => {
    event.preventDefault();
    byId("content").focus();
  });
  showAnnouncements(session);
  warnBeforeLeaving(session);
  wireLivePreview(session);
  return () => {
    const stage = new StageView(session);
    new ModelView(session, addFile, stage.works);
    stage.warmUp();
  };
}

/** Keeps the preview and the address up to date with the form. */
function wireLivePreview(session: Session): void {
  const live = new LivePreview(session);
  live.onRest(wireAddress(session, () => void openExample(session)));
  session.values.watch(live.typed);
  session.calculation.watch(live.changed);
  session.verb.watch(live.changed);
  session.models.watch(live.changed);
  session.chosen.watch(live.changed);
}

function showWhatIsOpen(session: Session): void {
  const update = () => {
    const any = session.models.value.length > 0;
    byId("start").hidden = any || session.calculating.value;
    document.documentElement.dataset["open"] = String(any);
  };
  session.models.watch(update);
  session.chosen.watch(update);
  session.calculating.watch(update);
}

async function openExample(session: Session): Promise<void> {
  performance.mark("open");
  const bytes = unpack(packed("example"));
  await openRead(session, [{ name: EXAMPLE, bytes, kind: "model" }]);
}

async function ready(session: Session, buildModelViews: () => void): Promise<void> {
  document.documentElement.dataset["ready"] = "true";
  performance.mark("ready");
  session.engine.warmUp(packed("example"));
  // Before a model can be open. The view of the body waits for the graphics driver, which may start more slowly than the engine.
  setTimeout(buildModelViews, 0);
  void showFalls(session);
  await refreshPresets(session);
}

function showUnsupported(text: string): void {
  const box = byId("unsupported");
  box.textContent = text;
  box.hidden = false;
}

main();
