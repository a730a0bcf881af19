// Copies text to the clipboard.

/** Whether it worked; where the browser does not allow it, `shown` is selected so that the user can copy it. */
export async function copy(text: string, shown: HTMLTextAreaElement): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    shown.focus();
    shown.select();
    return document.execCommand("copy");
  }
}
