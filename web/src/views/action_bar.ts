// The bar of buttons for the open model, always visible: download, keep, undo, redo, report, share.

import { redo, undo } from "../actions/apply";
import { downloadModel, downloadReport, downloadResult } from "../actions/download";
import { keepResult } from "../actions/keep";
import { previewOfForm } from "../actions/live";
import { button, byId, el, setText } from "../dom/element";
import type { Failure, Request } from "../engine/types";
import { QUESTIONS } from "../forms/all";
import { answersFor } from "../state/answers";
import { currentFile } from "../state/model";
import type { Session } from "../state/session";
import { shareDialog } from "./share";

/** The three steps. On a narrow screen they scroll away, and these buttons stay. */
const STEPS = [["model", "1 File"], ["proposal", "2 Original"], ["outcome", "3 Result"]] as const;

/** Fills the bar of buttons for the open model: download, keep, undo, redo, report, share. */
export function actionBar(session: Session): void {
  const bar = byId("acts");
  // A success ends the failure before it.
  const fail = (failure: Failure | undefined) => session.failed.set(failure ?? null);
  const share = shareDialog(session);
  const finishedPreview = () => {
    const preview = session.preview.value;
    return preview.state === "done" && !preview.change.unchanged ? preview : undefined;
  };
  const subjectRequest = (): Request | undefined => {
    const model = session.model();
    return finishedPreview()?.request ?? (model?.inspected ? { ...answersFor(model, QUESTIONS), verb: "inspect", models: [currentFile(model)] } : undefined);
  };
  // A button that is clicked while the result is computed waits for it: it never acts on a number that was changed since.
  const act = (does: () => void) => () => void previewOfForm(session).then(does);
  const save = button("Download", act(() => {
    const [change, model] = [finishedPreview(), session.model()];
    if (change) void downloadResult(session, change.request).then(fail);
    else if (model) void downloadModel(session, model).then(fail);
  }), { class: "primary", id: "download", "aria-keyshortcuts": "Control+S" });
  const keep = button("Keep and continue", act(() => void keepResult(session).then(fail)), { id: "keep" });
  const back = button("Undo", () => keepFocus(back, () => undo(session)), { id: "undo", "aria-keyshortcuts": "Control+Z" });
  const forward = button("Redo", () => keepFocus(forward, () => redo(session)), { id: "redo", "aria-keyshortcuts": "Control+Shift+Z" });
  const report = button("Report", act(() => {
    const request = subjectRequest();
    if (request) void downloadReport(session, request).then(fail);
  }), { id: "report" });
  const shareButton = button("Share…", act(() => {
    const request = subjectRequest();
    if (request) share(request);
  }), { id: "share", "aria-haspopup": "dialog" });
  const toSteps = STEPS.map(([id, text]) => button(text, () => byId(id).scrollIntoView(), { class: "small" }));
  bar.append(el("div", { class: "to-steps", role: "group", "aria-label": "Steps of the work" }, ...toSteps), save, keep, back, forward, report, shareButton);
  const update = () => {
    const [model, change] = [session.model(), finishedPreview()];
    bar.hidden = !model;
    if (!model) return;
    save.hidden = !change && model.stepCount === 0;
    setText(save, `Download ${change ? change.change.results.map(({ name }) => name).join(" and ") : currentFile(model)}`);
    keep.hidden = !change;
    back.disabled = model.stepCount === 0;
    forward.disabled = model.stepCount === model.steps.length;
    report.hidden = shareButton.hidden = !model.inspected;
    setText(report, change ? "Report about the change" : "Report about this model");
  };
  session.models.watch(update);
  session.chosen.watch(update);
  session.preview.watch(update);
}

/** Calls `act`; if the button is disabled afterwards, the title gets the focus. */
function keepFocus(pressed: HTMLButtonElement, act: () => void): void {
  act();
  (pressed.disabled ? byId("model-title") : pressed).focus();
}
