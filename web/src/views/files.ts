// The table of all open files.

import { inspectAgain } from "../actions/inspect";
import { openAsModel } from "../actions/open";
import { refreshPresets } from "../actions/presets";
import { removeFiles } from "../actions/file_list";
import { button, byId, el } from "../dom/element";
import { keepingFocus } from "../dom/focus";
import { boxedTable, type Head, headCells } from "../dom/table";
import { bytesText, counted } from "../dom/number";
import { type FileEntry, KIND_TEXTS } from "../files/kinds";
import type { OpenModel } from "../state/model";
import type { Session } from "../state/session";

const HEADS: readonly Head[] = [
  { text: "file", words: true }, { text: "kind", words: true }, { text: "size" }, { text: "what to do", hidden: true },
];

export function filesView(session: Session): void {
  const section = byId("files");
  const title = el("h2", { id: "files-title" });
  const rows = el("tbody");
  const box = boxedTable("Files", "Files that are open in this page.", el("tr", {}, ...headCells(HEADS)), rows);
  section.append(el("details", { id: "files-list" }, el("summary", {}, title), box));
  const update = () => {
    const files = session.files.value;
    section.hidden = files.length === 0;
    title.textContent = counted(files.length, "file");
    keepingFocus(rows, () => byId("content"), () => rows.replaceChildren(...files.map((file) => fileRow(session, file))));
  };
  session.files.watch(update);
  session.models.watch(update);
}

function fileRow(session: Session, file: FileEntry): HTMLElement {
  const isOpen = session.models.value.some((model) => isFileOfModel(model, file.name));
  const openable = (file.kind === "forces" || file.kind === "model") && !isOpen;
  const open = () => button("Open as a model", () => void openAsModel(session, file.name), buttonAttributes(`Open ${file.name} as a model`));
  const remove = () => button("Remove", () => void removeFile(session, file), buttonAttributes(`Remove ${file.name}`));
  return el("tr", {},
    el("th", { scope: "row" }, file.name), el("td", { class: "words" }, KIND_TEXTS[file.kind]), el("td", {}, bytesText(file.bytes)),
    el("td", { class: "acts" }, ...(openable ? [open()] : []), ...(isOpen ? [] : [remove()])));
}

/** Whether a file is an open model, before or after one of its steps. */
function isFileOfModel({ origin, steps }: OpenModel, name: string): boolean {
  return origin === name || steps.some(({ names }) => names.includes(name));
}

function buttonAttributes(name: string): Record<string, string> {
  return { class: "small", "aria-label": name };
}

async function removeFile(session: Session, { name }: FileEntry): Promise<void> {
  await removeFiles(session, [name]);
  await refreshPresets(session);
  session.announce(`${name} is removed.`);
  await inspectAgain(session);
}
