// A download of the page, and what the command makes of the same.

import { makesTheSame } from "./command.mjs";

/** Downloads the result, whose first file has this name: the command that the page spells makes the same files. */
export async function downloadsWhatTheCommandMakes(user, files, name, more = []) {
  const button = await user.done(more.length > 0 ? [name, ...more].join(" and ") : name);
  const downloads = await user.downloads(button, 1 + more.length);
  await makesTheSame(await user.spelled(), files, downloads);
  return downloads;
}
