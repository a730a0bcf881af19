// Files in a ZIP, as if its folder had been given.

import { unzipSync } from "fflate";

import { isUseful } from "./kinds";
import type { Given } from "./read";

/** More than this, unpacked, is no folder of a model: a small archive can unpack to anything. */
const MOST_BYTES = 500e6;

/** The same files with those in archives in the place of these. Throws where an archive is damaged. */
export async function unzipped(given: readonly Given[]): Promise<Given[]> {
  const all = await Promise.all(given.map((one) => (/\.zip$/i.test(one.name) ? inArchive(one) : [one])));
  return all.flat();
}

async function inArchive({ name, file }: Given): Promise<Given[]> {
  const damaged = (why: string) => new Error(`${name}: this ZIP is damaged, ${why}; pack it again, or open the folder`);
  let size = 0;
  const bytes = new Uint8Array(await file.arrayBuffer());
  let found: ReturnType<typeof unzipSync>;
  try {
    found = unzipSync(bytes, {
      filter: (entry) => {
        // A name that leads out of the folder is never that of a file that somebody packed.
        if (entry.name.split(/[/\\]/).includes("..")) throw damaged("a name in it leads out of its folder");
        const useful = !entry.name.endsWith("/") && isUseful(`/${entry.name}`);
        size += useful ? entry.originalSize : 0;
        if (size > MOST_BYTES) throw damaged("or it unpacks to more than 500 MB");
        return useful;
      },
    });
  } catch (error) {
    throw error instanceof Error && error.message.startsWith(name) ? error : damaged("it cannot be unpacked");
  }
  return Object.entries(found).map(([path, content]) => ({ name: path, file: new File([content as BlobPart], path.split("/").pop() ?? path) }));
}
