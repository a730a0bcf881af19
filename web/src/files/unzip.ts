// Opens a ZIP like the folder that it contains.

import { unzipSync } from "fflate";

import { isUseful } from "./kinds";
import type { GivenFile } from "./read";

/** Limit of the unpacked size: a small archive can unpack to any size. */
const MAX_BYTES = 500e6;

/** The files, with each archive replaced by the files in it. Throws if an archive is damaged. */
export async function expandArchives(files: readonly GivenFile[]): Promise<GivenFile[]> {
  const all = await Promise.all(files.map((one) => (/\.zip$/i.test(one.name) ? filesInArchive(one) : [one])));
  return all.flat();
}

async function filesInArchive({ name, file }: GivenFile): Promise<GivenFile[]> {
  const refused = (why: string) => new Error(`${name}: ${why}; pack it again, or open the folder`);
  const damaged = (why: string) => refused(`this ZIP is damaged, ${why}`);
  let size = 0;
  const bytes = new Uint8Array(await file.arrayBuffer());
  const packed = new Map<string, { size: number; sum: number }>();
  let entries: ReturnType<typeof unzipSync>;
  try {
    const sums = checksums(bytes);
    entries = unzipSync(bytes, {
      filter: (entry) => {
        const sum = sums.next().value ?? 0;
        // No program packs a name that leads out of the folder.
        if (entry.name.split(/[/\\]/).includes("..")) throw damaged("a name in it leads out of its folder");
        const useful = !entry.name.endsWith("/") && isUseful(`/${entry.name}`);
        if (useful && packed.has(entry.name)) throw refused(`this ZIP has two files called ${entry.name}`);
        if (useful) packed.set(entry.name, { size: entry.originalSize, sum });
        size += useful ? entry.originalSize : 0;
        if (size > MAX_BYTES) throw damaged("or it unpacks to more than 500 MB");
        return useful;
      },
    });
  } catch (error) {
    throw error instanceof Error && error.message.startsWith(name) ? error : damaged("it cannot be unpacked");
  }
  for (const [path, { size, sum }] of packed) {
    const content = entries[path];
    if (content?.length !== size || crc32(content) !== sum) throw damaged(`${path} in it is not what was packed`);
  }
  return Object.entries(entries).map(([path, content]) => ({ name: path, file: new File([content as BlobPart], path.split("/").pop() ?? path) }));
}

/** The checksum of each entry, in the order of the directory at the end of an archive, which fflate reads without the checksums. */
function* checksums(bytes: Uint8Array): Generator<number, void> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let end = bytes.length - 22;
  while (view.getUint32(end, true) !== 0x06054b50) end -= 1;
  let at = view.getUint32(end + 16, true);
  // A large archive has the place of its directory in a record of its own.
  if (at === 0xffffffff) at = view.getUint32(view.getUint32(end - 12, true) + 48, true);
  for (;;) {
    yield view.getUint32(at + 16, true);
    at += 46 + view.getUint16(at + 28, true) + view.getUint16(at + 30, true) + view.getUint16(at + 32, true);
  }
}

const CRC_OF_BYTE = Int32Array.from({ length: 256 }, (_, byte) => {
  let crc = byte;
  for (let bit = 0; bit < 8; bit += 1) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
  return crc;
});

function crc32(bytes: Uint8Array): number {
  let crc = -1;
  for (const byte of bytes) crc = (CRC_OF_BYTE[(crc ^ byte) & 255] ?? 0) ^ (crc >>> 8);
  return ~crc >>> 0;
}
