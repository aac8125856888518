// SPDX-License-Identifier: Apache-2.0
// What the bundler makes of the page's modules: for tests, and for pages where their program is built.
import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";
import { here } from "./assemble.mjs";

const scripts = [join(process.env.PAGE_FAKE, "page.js"), join(process.env.PAGE_PROGRAMS, "page", "page.js")].filter(
  existsSync,
);

test("a page's script is one strict function", () => {
  assert.ok(scripts.length > 0);
  for (const file of scripts)
    assert.match(
      readFileSync(file, "utf8"),
      /^\/\/ SPDX-License-Identifier: Apache-2\.0\n"use strict";\n\(\(\) => \{\n[^]*\n\}\)\(\);\n$/,
      file,
    );
});

test("a page's script can be read, and does not say where it was made", () => {
  const top = join(here, "..", "..");
  for (const file of scripts) {
    const text = readFileSync(file, "utf8");
    const modules = [...text.matchAll(/^ {2}\/\/ (\S+\.m?js)$/gm)].map(([, name]) => name);
    assert.ok(modules.includes("resources/page/main.js"), modules.join());
    for (const name of modules)
      assert.match(name, /^(resources\/page|render\/web|tests\/page)\/\w+\.js$|^engine_module\.mjs$/);
    assert.ok(!text.includes(top), file);
  }
});
