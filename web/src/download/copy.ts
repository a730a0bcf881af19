// Copies text to the clipboard.

/** Copies text and returns whether it worked. If the browser forbids it, `area` is selected, so that the user can copy it. */
export async function copy(text: string, area: HTMLTextAreaElement): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    area.focus();
    area.select();
    return document.execCommand("copy");
  }
}
