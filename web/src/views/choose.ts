// Opens files by buttons.

import { byId } from "../dom/element";
import { type GivenFile, filesOfInput } from "../files/read";

function inputById(id: string): HTMLInputElement {
  return byId(id) as HTMLInputElement;
}

/** Wires the buttons that open files and folders. */
export function wireButtons(open: (files: GivenFile[]) => void): void {
  for (const [button, chooser] of [["choose-files", "files-input"], ["choose-folder", "folder-input"]] as const) {
    const files = inputById(chooser);
    byId(button).addEventListener("click", () => files.click());
    files.addEventListener("change", () => {
      open(filesOfInput(files.files));
      // Without this, the browser would not report the same file again.
      files.value = "";
    });
  }
}

/** Lets the user choose one file; an empty list if the user cancels. */
export function chooseOne(accepted: string): Promise<GivenFile[]> {
  const file = inputById("file-input");
  file.accept = accepted;
  file.value = "";
  return new Promise((resolve) => {
    file.onchange = () => resolve(filesOfInput(file.files));
    file.oncancel = () => resolve([]);
    file.click();
  });
}
