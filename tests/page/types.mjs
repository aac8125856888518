// SPDX-License-Identifier: Apache-2.0
// types.mjs FOLDER: writes there what tsc is to check: page.json, the page's scripts together; and for
// each engine a project that compares it with engine.d.ts. Prints the projects' names.
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { here, pageFolder, pageScripts, reporterScripts } from "./assemble.mjs";

const folder = process.argv[2];
mkdirSync(folder, { recursive: true });

function project(name, files) {
  for (const file of files) if (!existsSync(file)) throw new Error(`${file} is not there`);
  const settings = JSON.parse(readFileSync(join(here, "tsconfig.json"), "utf8"));
  const path = join(folder, `${name}.json`);
  writeFileSync(path, JSON.stringify({ ...settings, files }, undefined, 2));
  console.log(path);
}

const declared = readdirSync(pageFolder).filter((name) => name.endsWith(".d.ts")).map((name) => join(pageFolder, name));
const reporters = reporterScripts();
project("page", [...declared, ...(reporters.length ? reporters : [join(here, "fake_report.js")]), ...pageScripts()]);

// engine.d.ts declares the class that an engine defines: for the comparison it is given another name.
const shape = join(folder, "engine_shape.d.ts");
writeFileSync(shape, readFileSync(join(pageFolder, "engine.d.ts"), "utf8").replace("declare class Engine {", "declare class EngineShape {") +
                     "\ndeclare var createEngineModule: (settings: object) => Promise<any>;\n");
const compared = join(folder, "engine_compared.js");
writeFileSync(compared, `/** @type {(engine: Engine) => EngineShape} */
const engineAsShape = (engine) => engine;
/** @type {(options: EngineOptions) => Promise<EngineShape>} */
const startAsShape = (options) => Engine.start(options);
`);
for (const engine of [join(here, "fake_engine.js"), join(here, "..", "..", "render", "web", "engine.js")])
  project(basename(engine, ".js"), [shape, engine, compared]);
