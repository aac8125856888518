// SPDX-License-Identifier: Apache-2.0
// Prints the settings with which tsc checks the page's scripts: tsconfig.json and their names.
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { here, pageFolder, pageScripts, reporterScripts } from "./assemble.mjs";

const settings = JSON.parse(readFileSync(join(here, "tsconfig.json"), "utf8"));
const declared = readdirSync(pageFolder).filter((name) => name.endsWith(".d.ts")).map((name) => join(pageFolder, name));
const reporters = reporterScripts();
// engine.d.ts speaks for the engine, whose own types are checked where it is made.
settings.files = [...declared, ...(reporters.length ? reporters : [join(here, "fake_report.js")]), ...pageScripts()];
for (const file of settings.files) if (!existsSync(file)) throw new Error(`order.txt names ${file}, which is not there`);
console.log(JSON.stringify(settings, undefined, 2));
