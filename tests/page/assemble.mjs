// SPDX-License-Identifier: Apache-2.0
// Has the exporter's own code put a page together, around the engine and reporter for tests.
import { execFileSync } from "node:child_process";
import { readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

export const here = dirname(fileURLToPath(import.meta.url));
export const pageFolder = join(here, "..", "..", "resources", "page");
const webFolder = join(here, "..", "..", "render", "web");

const modulesIn = (folder) =>
  readdirSync(folder)
    .filter((name) => name.endsWith(".js"))
    .map((name) => join(folder, name));

/** The modules of the page, and of its engine. */
export const pageModules = () => modulesIn(pageFolder);
export const engineModules = () => modulesIn(webFolder);

/** Returns the page in one file: `facts`; `stills`, its HTML; `scene` and maybe `context`, texts. */
export function assembled({ facts, stills, scene, context }) {
  return execFileSync(join(process.env.PAGE_PROGRAMS, "sline-page-assembler"), {
    input: JSON.stringify({ facts, stills, scene, context }),
    encoding: "utf8",
    maxBuffer: 1 << 26,
    env: { ...process.env, SLINE_PAGE: process.env.PAGE_FAKE },
  });
}
