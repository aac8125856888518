// SPDX-License-Identifier: Apache-2.0
// Chooses languages, and among words those of a language.

/** @import { Lines } from "./facts.d.ts" */

const rightToLeft = new Set(["ar", "dv", "fa", "he", "ku", "ps", "sd", "ug", "ur", "yi"]);

/** @param {string} language */
export function directionOf(language) {
  return rightToLeft.has(language.split("-")[0]) ? "rtl" : "ltr";
}

/**
 * The tag under which the page knows a browser's language.
 * @param {string} tag
 */
function knownTag(tag) {
  const short = tag.toLowerCase().split("-")[0];
  return short === "no" || short === "nn" ? "nb" : short;
}

/**
 * @param {readonly string[]} wanted as navigator.languages
 * @param {readonly string[]} there
 * @returns {string | undefined}
 */
export function firstOf(wanted, there) {
  return wanted.map(knownTag).find((tag) => there.includes(tag));
}

/**
 * What is there in the language, else in one that the scene falls back on, with that language.
 * @template T
 * @param {{[language: string]: T} | undefined} words
 * @param {readonly string[]} languages in order of preference
 * @returns {{language: string, words: T} | undefined}
 */
export function wordsIn(words, languages) {
  if (!words) return undefined;
  for (const language of [...languages, ...Object.keys(words)])
    if (Object.prototype.hasOwnProperty.call(words, language) && words[language])
      return { language, words: words[language] };
  return undefined;
}

/** @param {Lines} lines */
export function plainLines(lines) {
  return lines.map((runs) => runs.map((run) => run.text).join(""));
}

/**
 * A name as names are compared: without marks, case, blanks and punctuation. The exporter hashes
 * names in this form (normalisedAnswer), so both change together.
 * @param {string} name
 */
export function normalised(name) {
  return name
    .normalize("NFKD")
    .toLowerCase()
    .replace(/[^\p{L}\p{Nd}]/gu, "")
    .replace(/ς/g, "σ");
}

/**
 * The name as it stands in a link: "left-ureter".
 * @param {string} name
 */
export function linkName(name) {
  return name
    .normalize("NFKD")
    .replace(/\p{M}/gu, "")
    .toLowerCase()
    .replace(/[^\p{L}\p{N}]+/gu, "-")
    .replace(/^-|-$/g, "");
}

/** A language's name in itself. @param {string} tag */
export function languageName(tag) {
  if (tag === "la") return "Latina";
  if (tag === "nb") return "Norsk";
  try {
    const name = new Intl.DisplayNames([tag], { type: "language" }).of(tag) ?? tag;
    return name.charAt(0).toLocaleUpperCase(tag) + name.slice(1);
  } catch {
    return tag;
  }
}
