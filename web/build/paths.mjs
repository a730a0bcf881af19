// Where things are. Everything that is made is below target/, which git does not know.

import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

export const WEB = dirname(dirname(fileURLToPath(import.meta.url)));
export const ROOT = dirname(WEB);
export const OUTPUT = join(ROOT, "target", "web");
export const ENGINE = join(OUTPUT, "engine");
export const PAGE = "osim-contact-scale.html";
