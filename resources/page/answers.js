// SPDX-License-Identifier: Apache-2.0
// Compares a typed name with hashes of the right ones, and lets slips of spelling pass. The hash is
// written out here as browsers offer theirs to pages from a secure server only.

import { normalised } from "./words.js";

/** The first 32 bits of the fractions of roots of primes: square roots, then cube roots. */
const [hashStart, hashRounds] = (() => {
  const start = [];
  const rounds = [];
  for (let n = 2; rounds.length < 64; ++n) {
    let prime = true;
    for (let d = 2; d * d <= n && prime; ++d) prime = n % d !== 0;
    if (!prime) continue;
    if (start.length < 8) start.push((Math.sqrt(n) * 2 ** 32) | 0);
    rounds.push((Math.cbrt(n) * 2 ** 32) | 0);
  }
  return [start, rounds];
})();

/** @param {string} text */
function paddedWords(text) {
  const bytes = new TextEncoder().encode(text);
  const words = new Int32Array(((bytes.length + 8) >> 6) * 16 + 16);
  for (let i = 0; i < bytes.length; ++i) words[i >> 2] |= bytes[i] << (24 - (i % 4) * 8);
  words[bytes.length >> 2] |= 0x80 << (24 - (bytes.length % 4) * 8);
  words[words.length - 1] = bytes.length * 8;
  return words;
}

/** @param {Int32Array} hash @param {Int32Array} words @param {number} block @param {Int32Array} w */
function hashBlock(hash, words, block, w) {
  /** @param {number} x @param {number} n */
  const turned = (x, n) => (x >>> n) | (x << (32 - n));
  for (let i = 0; i < 64; ++i) {
    if (i < 16) {
      w[i] = words[block + i];
      continue;
    }
    const a = w[i - 15];
    const b = w[i - 2];
    w[i] =
      w[i - 16] + w[i - 7] + (turned(a, 7) ^ turned(a, 18) ^ (a >>> 3)) + (turned(b, 17) ^ turned(b, 19) ^ (b >>> 10));
  }
  let [a, b, c, d, e, f, g, h] = hash;
  for (let i = 0; i < 64; ++i) {
    const one = (h + (turned(e, 6) ^ turned(e, 11) ^ turned(e, 25)) + ((e & f) ^ (~e & g)) + hashRounds[i] + w[i]) | 0;
    const two = ((turned(a, 2) ^ turned(a, 13) ^ turned(a, 22)) + ((a & b) ^ (a & c) ^ (b & c))) | 0;
    [h, g, f, e, d, c, b, a] = [g, f, e, (d + one) | 0, c, b, a, (one + two) | 0];
  }
  [a, b, c, d, e, f, g, h].forEach((value, i) => (hash[i] += value));
}

/**
 * The first 16 hexadecimal digits of SHA-256 (FIPS 180-4) of a text in UTF-8.
 * @param {string} text
 */
export function shortHash(text) {
  const words = paddedWords(text);
  const hash = Int32Array.from(hashStart);
  const w = new Int32Array(64);
  for (let block = 0; block < words.length; block += 16) hashBlock(hash, words, block, w);
  return [hash[0], hash[1]].map((x) => (x >>> 0).toString(16).padStart(8, "0")).join("");
}

/** @param {string} salt @param {string} name */
export function answerHash(salt, name) {
  return shortHash(salt + normalised(name));
}

/** Words that are a slip of another word, and yet mean something of their own. */
const wordsOfTheirOwn = new Set(
  (
    "ileum ilium ileal ilial iliac carpal tarsal carpus tarsus carpi tarsi " +
    "carpalia tarsalia abductor adductor abduction adduction anterior interior inferior exterior " +
    "perineal peroneal medial median mediana radial facial malleus malleolus ureter urethra " +
    "interosseous sacral cervix cerebrum cerebellum vagina vagus"
  ).split(" "),
);

/** Articles, which may be left out. */
const articles = new Set(["the", "a", "der", "die", "das", "de", "het", "den", "det"]);

/**
 * What else a word may have been meant to be: one letter too many, too few, another or two changed
 * places; never a digit, nor what is short or a word of its own.
 * @param {string} word normalised
 * @returns {string[]}
 */
function slipsOf(word) {
  if (word.length < 5 || /\p{N}/u.test(word) || wordsOfTheirOwn.has(word)) return [];
  const letters = "abcdefghijklmnopqrstuvwxyzßøæ";
  const out = new Set();
  for (let i = 0; i <= word.length; ++i) {
    const before = word.slice(0, i);
    const after = word.slice(i);
    if (after) out.add(before + after.slice(1));
    if (after.length > 1) out.add(before + after[1] + after[0] + after.slice(2));
    for (const letter of letters) {
      out.add(before + letter + after);
      if (after) out.add(before + letter + after.slice(1));
    }
  }
  for (const [a, b] of [
    ["ph", "f"],
    ["ae", "a"],
    ["oe", "o"],
    ["ue", "u"],
    ["oe", "ø"],
    ["ae", "æ"],
    ["ss", "ß"],
    ["k", "c"],
    ["z", "c"],
    ["y", "i"],
    ["th", "t"],
    ["rh", "r"],
  ])
    out.add(word.split(a).join(b)).add(word.split(b).join(a));
  out.add(word.replace(/(.)\1/gu, "$1"));
  out.delete(word);
  return [...out];
}

/**
 * All orders of up to four words; of more only the given one.
 * @param {string[]} words
 * @returns {string[][]}
 */
function ordersOf(words) {
  if (words.length > 4 || words.length < 2) return [words];
  return words.flatMap((word, i) =>
    ordersOf([...words.slice(0, i), ...words.slice(i + 1)]).map((rest) => [word, ...rest]),
  );
}

/**
 * Judges a typed name: "right", "nearly" (right but for a slip) or "wrong". What is exactly the
 * answer of another question is wrong, however near it is.
 * @param {string} typed
 * @param {{answers: string[], others: string[], salt: string}} key hashes, and their salt
 * @returns {"right" | "nearly" | "wrong"}
 */
export function judged(typed, { answers, others, salt }) {
  const words = typed
    .split(/[\s,;()/]+/u)
    .map(normalised)
    .filter((word) => word);
  if (words.length === 0) return "wrong";
  const right = new Set(answers);
  const named = words.filter((word) => !articles.has(word));
  // "A." is an artery at least as often as an article.
  const exact = [words.join(""), ...[words, named].flatMap((some) => ordersOf(some).map((order) => order.join("")))];
  const hashes = exact.map((name) => shortHash(salt + name));
  if (hashes.some((hash) => right.has(hash))) return "right";
  const wrong = new Set(others);
  if (hashes.some((hash) => wrong.has(hash))) return "wrong";
  for (const order of ordersOf(named))
    for (const [place, word] of order.entries())
      for (const slip of slipsOf(word)) {
        const name = [...order.slice(0, place), slip, ...order.slice(place + 1)].join("");
        if (right.has(shortHash(salt + name))) return "nearly";
      }
  return "wrong";
}
