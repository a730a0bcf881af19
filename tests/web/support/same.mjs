// Compares a download of the page with the files that the command makes.

import { makesTheSame } from "./command.mjs";

/** Downloads the result, whose first file is `name`, and asserts that the command line on the page makes the same files. */
export async function downloadsWhatTheCommandMakes(user, files, name, more = []) {
  const button = await user.done(more.length > 0 ? [name, ...more].join(" and ") : name);
  const downloads = await user.downloads(button, 1 + more.length);
  await makesTheSame(await user.spelled(), files, downloads);
  return downloads;
}
