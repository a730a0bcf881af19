// Gives a file to the browser to save. Nothing is sent: the address of the file is one in this page's memory.

export function save(name: string, content: Uint8Array | string, type = "application/octet-stream"): void {
  const address = URL.createObjectURL(new Blob([content as BlobPart], { type }));
  const link = document.createElement("a");
  link.href = address;
  // A browser makes a folder's separator into a sign of its own; the file's own name is enough.
  link.download = name.split(/[/\\]/).pop() ?? name;
  document.body.append(link);
  link.click();
  link.remove();
  // The browser reads it after this.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}
