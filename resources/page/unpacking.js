// SPDX-License-Identifier: Apache-2.0
// Unpacks what the page carries: the program and the scene.

import { textIn } from "./texts.js";

/** @import { Facts } from "./facts.d.ts" */

/** What went wrong, as a row of the table of texts. */
export class PageError extends Error {
  /** @param {string} key @param {...string} parts */
  constructor(key, ...parts) {
    super(textIn("en", key, parts));
    this.key = key;
    this.parts = parts;
  }
}

/** @param {string} text base64, line breaks allowed */
function bytesOf(text) {
  try {
    const letters = atob(text.replace(/\s+/g, ""));
    const bytes = new Uint8Array(letters.length);
    for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
    return bytes;
  } catch {
    throw new PageError("spoiled");
  }
}

/** @param {Uint8Array} bytes gzip, or what is not packed */
async function gunzipped(bytes) {
  if (bytes[0] !== 0x1f || bytes[1] !== 0x8b) return bytes;
  if (typeof DecompressionStream === "undefined") throw new PageError("oldBrowser");
  try {
    const stream = new Blob([/** @type {BlobPart} */ (bytes)]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch {
    throw new PageError("spoiled");
  }
}

/** @param {string} name of a file beside the page */
async function fileBeside(name) {
  try {
    const answer = await fetch(name);
    if (answer.ok) return new Uint8Array(await answer.arrayBuffer());
  } catch {
    // A page from file:// may not read what lies beside it.
  }
  throw new PageError("beside", name);
}

/**
 * @param {string} id of the element that holds it
 * @returns {Promise<Uint8Array | undefined>} undefined where the page has none
 */
export async function unpacked(id) {
  const holder = document.getElementById(id);
  if (!holder) return undefined;
  const file = holder.getAttribute("data-src");
  const bytes = file ? await fileBeside(file) : bytesOf(holder.textContent ?? "");
  // The text is as large again as what was made of it.
  holder.textContent = "";
  return gunzipped(bytes);
}

/** @returns {Facts} */
export function readFacts() {
  const facts = JSON.parse(document.getElementById("facts")?.textContent ?? "null");
  if (facts?.schema !== 1 || !Array.isArray(facts.nodes)) throw new PageError("spoiled");
  return facts;
}
