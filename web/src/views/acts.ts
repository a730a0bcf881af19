// What can always be done with the model that is open, always in sight: download, keep, undo, redo, report, share.

import { redo, undo } from "../actions/apply";
import { downloadModel, downloadReport, downloadResult } from "../actions/download";
import { keepResult } from "../actions/keep";
import { button, byId, setText } from "../dom/element";
import type { Failure, Request } from "../engine/types";
import { QUESTIONS } from "../forms/all";
import { answered } from "../state/answers";
import { fileOf } from "../state/model";
import type { Session } from "../state/session";
import { shareDialog } from "./share";

export function actsView(session: Session): void {
  const bar = byId("acts");
  const fail = (failure: Failure | undefined) => failure && session.failed.set(failure);
  const share = shareDialog(session);
  const done = () => {
    const preview = session.preview.value;
    return preview.state === "done" && !preview.change.unchanged ? preview : undefined;
  };
  const about = (): Request | undefined => {
    const model = session.model();
    return done()?.request ?? (model?.inspected ? { ...answered(model, QUESTIONS), verb: "inspect", models: [fileOf(model)] } : undefined);
  };
  const save = button("Download", () => {
    const [change, model] = [done(), session.model()];
    if (change) void downloadResult(session, change.request).then(fail);
    else if (model) void downloadModel(session, model).then(fail);
  }, { class: "primary", id: "download" });
  const keep = button("Keep and go on", () => void keepResult(session).then(fail), { id: "keep" });
  const back = button("Undo", () => keepFocus(back, () => undo(session)), { id: "undo", "aria-keyshortcuts": "Control+Z" });
  const again = button("Redo", () => keepFocus(again, () => redo(session)), { id: "redo", "aria-keyshortcuts": "Control+Shift+Z" });
  const report = button("Report", () => {
    const request = about();
    if (request) void downloadReport(session, request).then(fail);
  }, { id: "report" });
  const shared = button("Share…", () => {
    const request = about();
    if (request) share(request);
  }, { id: "share", "aria-haspopup": "dialog" });
  bar.append(save, keep, back, again, report, shared);
  const update = () => {
    const [model, change] = [session.model(), done()];
    bar.hidden = !model;
    if (!model) return;
    save.hidden = !change && model.at === 0;
    setText(save, `Download ${change ? change.change.results.map(({ name }) => name).join(" and ") : fileOf(model)}`);
    keep.hidden = !change;
    back.disabled = model.at === 0;
    again.disabled = model.at === model.steps.length;
    report.hidden = shared.hidden = !model.inspected;
    setText(report, change ? "Report about the change" : "Report about this model");
  };
  session.models.watch(update);
  session.chosen.watch(update);
  session.preview.watch(update);
}

/** A button that has nothing more to do does not lose the reader's place. */
function keepFocus(pressed: HTMLButtonElement, act: () => void): void {
  act();
  (pressed.disabled ? byId("model-title") : pressed).focus();
}
