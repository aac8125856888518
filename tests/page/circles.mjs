// SPDX-License-Identifier: Apache-2.0
// circles.mjs FILE: FILE is what the bundler tells of modules. Fails where modules import each other in a
// circle, and where a module of the page is in no bundle.
import { readdirSync, readFileSync } from "node:fs";
import { pageFolder } from "./assemble.mjs";

const { inputs } = JSON.parse(readFileSync(process.argv[2], "utf8"));
const faults = [];
const done = new Set();

/** Follows the imports of a module; `path` are those that led to it. */
function follow(module, path) {
  if (path.includes(module)) faults.push(`a circle: ${[...path.slice(path.indexOf(module)), module].join(" -> ")}`);
  if (path.includes(module) || done.has(module)) return;
  for (const { path: imported } of inputs[module]?.imports ?? []) follow(imported, [...path, module]);
  done.add(module);
}

for (const module of Object.keys(inputs)) follow(module, []);
for (const name of readdirSync(pageFolder).filter((one) => one.endsWith(".js")))
  if (!(`resources/page/${name}` in inputs)) faults.push(`resources/page/${name} is imported by nobody`);
for (const fault of faults) console.error(fault);
process.exitCode = faults.length ? 1 : 0;
