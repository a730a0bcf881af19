// Starts the page: checks the browser, starts the engine, and puts everything in its place.

import { redo, undo } from "./actions/apply";
import { Live } from "./actions/live";
import { openFiles, openRead } from "./actions/open";
import { refreshPresets } from "./actions/presets";
import { byId } from "./dom/element";
import { wholePage } from "./dom/whole";
import { Client } from "./engine/client";
import { failureOf } from "./engine/failure";
import { packed, unpack, unpackedText } from "./engine/unpack";
import { acceptDrops } from "./files/drop";
import type { Source } from "./forms/declaration";
import { Session } from "./state/session";
import { missingSupport } from "./support";
import { actsView } from "./views/acts";
import { wireAddress } from "./views/address";
import { showBusy } from "./views/busy";
import { calculatorView } from "./views/calculator";
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
import { ResultView } from "./views/result";
import { StageView } from "./views/stage";
import { showFalls } from "./views/start";

const NEWER = "Please use a newer one. The end of the page lists those that work.";
const EXAMPLE = "human_62kg_smooth_sphere.osim";

function main(): void {
  const missing = missingSupport();
  if (missing.length > 0) return cannot(`This browser lacks what the page needs: ${missing.join(", ")}. ${NEWER}`);
  const session = new Session(new Client(unpackedText("worker")));
  // The worker unpacks the engine while this thread makes the page.
  const started = wholePage().then(async () => {
    const engine = session.engine.start(packed("engine"));
    const stage = wire(session);
    await engine;
    return stage;
  });
  started.then((stage) => ready(session, stage), (error) => cannot(`The page could not start: ${failureOf(error).message}`));
}

function wire(session: Session): StageView {
  const refuse = (why: string) => session.announce(`This could not be read: ${why}.`);
  const open = (given: Parameters<typeof openFiles>[1]) => void openFiles(session, given).catch((error) => refuse(failureOf(error).message));
  const addFile = async (source: Source) => {
    const given = await chooseOne(acceptedFor(source));
    // A model to take contacts from is not one to be changed.
    await openFiles(session, given, "at hand");
    return given.map(({ name }) => name);
  };
  showBusy(session.engine);
  showExplanations(session);
  new LibraryView(session);
  const stage = new StageView(session);
  new ModelView(session, addFile, stage.works);
  new ResultView(session, addFile);
  actsView(session);
  calculatorView(session, addFile);
  filesView(session);
  footerView();
  manualView();
  showWhatIsOpen(session);
  wireButtons(open);
  acceptDrops(open, refuse);
  wireKeys(() => undo(session), () => redo(session));
  // All of the zone is a button, but for what is one itself.
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
  keepLive(session);
  return stage;
}

/** The preview and the address follow the form. */
function keepLive(session: Session): void {
  const live = new Live(session);
  live.onRest(wireAddress(session));
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
  await wholePage();
  performance.mark("open");
  const bytes = unpack(packed("example"));
  await openRead(session, [{ name: EXAMPLE, bytes, kind: "model" }]);
}

async function ready(session: Session, stage: StageView): Promise<void> {
  document.documentElement.dataset["ready"] = "true";
  performance.mark("ready");
  session.engine.warmUp(packed("example"));
  // When the page is there.
  setTimeout(() => stage.warmUp(), 0);
  void showFalls(session);
  await refreshPresets(session);
}

function cannot(text: string): void {
  const box = byId("unsupported");
  box.textContent = text;
  box.hidden = false;
}

main();
