// Lets the browser save a file. Nothing is sent: the address of the file is in this page's memory.

export function save(name: string, content: Uint8Array | string, type = "application/octet-stream"): void {
  const address = URL.createObjectURL(new Blob([content as BlobPart], { type }));
  const link = document.createElement("a");
  link.href = address;
  // Browsers replace the separators of folders; the name without the folder is enough.
  link.download = name.split(/[/\\]/).pop() ?? name;
  document.body.append(link);
  link.click();
  link.remove();
  // The browser reads the file after this function.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}
