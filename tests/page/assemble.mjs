// SPDX-License-Identifier: Apache-2.0
// Assembles a page as the exporter does, from resources/page, with whatever engine and scene it is
// given. page.html says what stands where.
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

export const here = dirname(fileURLToPath(import.meta.url));
export const pageFolder = join(here, "..", "..", "resources", "page");

function ordered() {
  return readFileSync(join(pageFolder, "order.txt"), "utf8").split("\n").map((line) => line.trim()).filter((name) => name);
}

/** The page's own scripts in their order; tests have an engine and a reporter of their own. */
export function pageScripts() {
  return ordered().filter((name) => !name.startsWith("engine") && !name.startsWith("report_"))
    .map((name) => join(pageFolder, name));
}

/** The scripts that report to learning systems. */
export function reporterScripts() {
  return ordered().filter((name) => name.startsWith("report_")).map((name) => join(pageFolder, name));
}

const escaped = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/"/g, "&quot;");
const source = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
const packed = (bytes) => gzipSync(bytes, { level: 9 }).toString("base64");

/**
 * Returns the page in one file: `facts`; `stills`, its HTML; `program`, `scene` and maybe `context`,
 * bytes; `engine` and `reporter`, files of scripts, one or several.
 */
export function assembled({ facts, stills = "", program, scene, context, engine, reporter }) {
  const files = [engine, reporter, pageScripts()].flat();
  const script = `(() => {\n"use strict";\n${files.map((file) => readFileSync(file, "utf8")).join("\n")}})();\n`;
  const style = readFileSync(join(pageFolder, "page.css"), "utf8");
  if (/<\/script/i.test(script)) throw new Error("a script ends its element");
  const data = Object.entries({ program, scene, "scene-context": context }).filter(([, bytes]) => bytes)
    .map(([id, bytes]) => `<script type="text/plain" id="${id}">${packed(bytes)}</script>`).join("\n");
  const values = {
    LANGUAGE: facts.language, DIRECTION: "ltr", TITLE: escaped(facts.title),
    POLICY: `default-src 'none'; script-src ${source(script)} 'wasm-unsafe-eval'; style-src ${source(style)}; ` +
            "img-src data: blob:; base-uri 'none'; form-action 'none'",
    STYLE: `<style>${style}</style>`, STILLS: stills, DATA: data,
    FACTS: JSON.stringify(facts).replace(/</g, "\\u003c"), SCRIPT: `<script>${script}</script>`,
  };
  return readFileSync(join(pageFolder, "page.html"), "utf8").replace(/<!--[\s\S]*?-->\n/, "")
    .replace(/\{\{([A-Z]+)\}\}/g, (_, name) => values[name]);
}
