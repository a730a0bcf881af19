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
  const damaged = (why: string) => new Error(`${name}: this ZIP is damaged, ${why}; pack it again, or open the folder`);
  let size = 0;
  const bytes = new Uint8Array(await file.arrayBuffer());
  let entries: ReturnType<typeof unzipSync>;
  try {
    entries = unzipSync(bytes, {
      filter: (entry) => {
        // No program packs a name that leads out of the folder.
        if (entry.name.split(/[/\\]/).includes("..")) throw damaged("a name in it leads out of its folder");
        const useful = !entry.name.endsWith("/") && isUseful(`/${entry.name}`);
        size += useful ? entry.originalSize : 0;
        if (size > MAX_BYTES) throw damaged("or it unpacks to more than 500 MB");
        return useful;
      },
    });
  } catch (error) {
    throw error instanceof Error && error.message.startsWith(name) ? error : damaged("it cannot be unpacked");
  }
  return Object.entries(entries).map(([path, content]) => ({ name: path, file: new File([content as BlobPart], path.split("/").pop() ?? path) }));
}
