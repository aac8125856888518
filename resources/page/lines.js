// SPDX-License-Identifier: Apache-2.0
// Texts of views, notes and callouts as elements; names in them may be links.

import { make } from "./elements.js";

/** @import { Lines, Run } from "./facts.d.ts" */
/** @import { Links } from "./links.js" */

/**
 * @param {Run} run
 * @param {Links} links
 * @returns {Node}
 */
function runElement(run, links) {
  /** @type {Node} */
  let out = document.createTextNode(run.text);
  if (run.bold) out = make("strong", {}, out);
  if (run.italic) out = make("em", {}, out);
  if (run.raised) out = make("sup", {}, out);
  if (run.lowered) out = make("sub", {}, out);
  const link =
    run.structure !== undefined
      ? links.toStructure(run.structure)
      : run.view !== undefined
        ? links.toView(run.view)
        : undefined;
  if (!link) return out;
  return make("a", { href: link, click: (event) => links.followed(event, link) }, out);
}

/**
 * Paragraphs; lines that begin with a bullet become a list.
 * @param {Lines} lines
 * @param {string} language
 * @param {Links} links
 */
export function linesElement(lines, language, links) {
  const out = make("div", { class: "lines", lang: language, dir: "auto" });
  /** @type {HTMLUListElement | undefined} */
  let list;
  for (const runs of lines) {
    const bullet = runs[0]?.text.startsWith("\u2022");
    const rest = bullet ? [{ ...runs[0], text: runs[0].text.replace(/^\u2022\s*/, "") }, ...runs.slice(1)] : runs;
    const inside = rest.map((run) => runElement(run, links));
    if (!bullet) {
      list = undefined;
      if (rest.some((run) => run.text.trim())) out.append(make("p", {}, ...inside));
      continue;
    }
    if (!list) out.append((list = make("ul", {})));
    list.append(make("li", {}, ...inside));
  }
  return out;
}
