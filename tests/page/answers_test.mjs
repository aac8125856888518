// SPDX-License-Identifier: Apache-2.0
// Hashes of names, and which spellings pass.
import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";
import { answerHash, judged, shortHash } from "../../resources/page/answers.js";
import { normalised } from "../../resources/page/words.js";
import { engineModules, here, pageModules } from "./assemble.mjs";
import { hashed } from "./lesson.mjs";

test("names are compared and hashed as the exporter does", () => {
  for (const { salt, name, normal, hash } of JSON.parse(readFileSync(join(here, "answers.json"), "utf8")).rows) {
    assert.equal(normalised(name), normal, name);
    const wanted = createHash("sha256")
      .update(salt + normal)
      .digest("hex")
      .slice(0, 16);
    assert.equal(answerHash(salt, name), wanted, name);
    if (hash) assert.equal(wanted, hash);
  }
});

test("SHA-256 of every length around a block's end", () => {
  for (let length = 0; length < 200; ++length) {
    const text = "é".repeat(length % 3) + "x".repeat(length);
    assert.equal(shortHash(text), createHash("sha256").update(text).digest("hex").slice(0, 16), `${length}`);
  }
});

test("slips of spelling pass, other names do not", () => {
  const salt = "b3";
  const answers = (...names) => names.map((name) => hashed(salt, name));
  const others = answers("Left ureter", "Left urethra", "Abductor hallucis");
  const rows = [
    ["Right ureter", "Right ureter", "right"],
    ["right  URETER", "Right ureter", "right"],
    ["ureter, right", "Right ureter", "right"],
    ["the right ureter", "Right ureter", "right"],
    ["rigth ureter", "Right ureter", "nearly"],
    ["right uretr", "Right ureter", "nearly"],
    ["left ureter", "Right ureter", "wrong"],
    ["", "Right ureter", "wrong"],
    ["   ", "Right ureter", "wrong"],
    ["urinary blader", "Urinary bladder", "nearly"],
    ["urinary bladdder", "Urinary bladder", "nearly"],
    ["urinary blatter", "Urinary bladder", "wrong"],
    ["bladder", "Urinary bladder", "wrong"],
    ["Harnroehre", "Harnröhre", "nearly"],
    ["Harnrohre", "Harnröhre", "right"],
    ["Oesophagus", "Ösophagus", "nearly"],
    ["arteria iliaka", "Arteria iliaca", "nearly"],
    ["difragm", "Diaphragm", "wrong"],
    ["diafragm", "Diaphragm", "nearly"],
    ["adductor hallucis", "Adductor hallucis", "right"],
    ["abductor hallucis", "Adductor hallucis", "wrong"],
    ["ileum", "Ilium", "wrong"],
    ["perineal nerve", "Peroneal nerve", "wrong"],
    ["rib 7", "Rib 8", "wrong"],
    ["segment VII", "Segment VIII", "wrong"],
    ["segmnet VIII", "Segment VIII", "nearly"],
    ["rectum", "Rectum", "right"],
    ["rektum", "Rectum", "nearly"],
    ["os", "As", "wrong"],
  ];
  for (const [typed, name, wanted] of rows)
    assert.equal(judged(typed, { answers: answers(name), others, salt }), wanted, `${typed} for ${name}`);
});

test("judging takes no longer than a blink", () => {
  const began = performance.now();
  judged("musculus extensor digitorum longus", { answers: ["0".repeat(16)], others: [], salt: "s" });
  assert.ok(performance.now() - began < 1500, `${performance.now() - began} ms`);
});

test("no script reads text as HTML or as a script, or keeps anything", () => {
  const text = [...engineModules(), ...pageModules()].map((file) => readFileSync(file, "utf8")).join("\n");
  assert.doesNotMatch(
    text,
    /<\/script|<!--|innerHTML|insertAdjacentHTML|document\.write|\beval\(|localStorage|sessionStorage|indexedDB|document\.cookie/i,
  );
});
