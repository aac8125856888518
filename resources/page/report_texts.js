// SPDX-License-Identifier: Apache-2.0
// Writes answers in the forms that learning systems have for them.

/**
 * What was answered, in few characters, as systems keep 4096 of them at the least: the names of
 * questions after "+" where the answer was right, after "-" where it was not.
 * @param {ReadonlyMap<string, boolean>} answered
 * @param {number} most characters; the last answers are left out where there are more
 */
export function suspendedText(answered, most) {
  let text = "sline1";
  for (const [id, right] of answered) {
    const more = (right ? "+" : "-") + encodeURIComponent(id).replace(/-/g, "%2D");
    if (text.length + more.length > most) break;
    text += more;
  }
  return text;
}

/**
 * @param {string} text
 * @returns {Map<string, boolean>} none where the text is another program's
 */
export function answeredIn(text) {
  /** @type {Map<string, boolean>} */
  const answered = new Map();
  const parts = /^sline1((?:[+-][^+-]+)*)$/.exec(text)?.[1].match(/[+-][^+-]+/g) ?? [];
  try {
    for (const part of parts) answered.set(decodeURIComponent(part.slice(1)), part[0] === "+");
  } catch {
    answered.clear();
  }
  return answered;
}

/** @param {string} text @param {number} most characters; none is cut in two */
export function shortened(text, most) {
  const line = text.replace(/[\p{Cc}\p{Cs}\s]+/gu, " ").trim();
  let short = "";
  for (const character of line) {
    if (short.length + character.length > most) break;
    short += character;
  }
  return short;
}

/** A name that every system takes for an identifier. @param {string} id */
export function identifier(id) {
  return shortened(id.replace(/[^A-Za-z0-9_]/g, "_"), 250) || "_";
}

/** @param {number} seconds @returns {string} "0001:02:03.50" */
export function clockTime(seconds) {
  const whole = Math.min(Math.max(0, seconds), 9999 * 3600);
  const hours = Math.floor(whole / 3600);
  const minutes = Math.floor(whole / 60) % 60;
  const rest = (Math.floor(100 * whole) % 6000) / 100;
  return `${String(hours).padStart(4, "0")}:${String(minutes).padStart(2, "0")}:${rest.toFixed(2).padStart(5, "0")}`;
}

/** @param {number} seconds @returns {string} "PT63.5S" */
export function isoTime(seconds) {
  return `PT${Math.max(0, Math.round(100 * seconds) / 100)}S`;
}

/** The share of right answers, 0 … 1. @param {number} right @param {number} total */
export function shareOf(right, total) {
  return total > 0 ? Math.min(1, Math.max(0, right / total)) : 0;
}

/** @param {number} share @returns {string} with as many digits as systems read */
export function decimal(share) {
  return String(Math.round(10_000 * share) / 10_000);
}
