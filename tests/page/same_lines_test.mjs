// SPDX-License-Identifier: Apache-2.0
// The program of the page finds the lines that the workstation finds: the same rooms, compiled for
// WebAssembly and for this machine, give the same segments for the same scene and camera.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";

const bin = process.env.PAGE_PROGRAMS ?? "";
const glue = process.env.PAGE_GLUE ?? "";
const absent = [glue, join(bin, "sline"), join(bin, "sline-page-lines")].find((file) => !existsSync(file));
// Where nothing may be absent, what is not built fails the test.
const skip = absent && !process.env.SLINE_NOTHING_ABSENT && `${absent} is not built`;

/** The segments in words that do not depend on the last bits of sines and roots: a tenth of a micrometre. */
function segmentSet(ends) {
  const set = new Map();
  for (let at = 0; at < ends.length; at += 6) {
    const key = Array.from(ends.slice(at, at + 6), (x) => Math.round(x * 1e4)).join(" ");
    set.set(key, (set.get(key) ?? 0) + 1);
  }
  return set;
}

/** How many of one set have no partner in the other within two micrometres. */
function unmatched(from, to) {
  let alone = 0;
  const exact = segmentSet(to);
  const rest = [];
  for (let at = 0; at < from.length; at += 6) {
    const ends = from.slice(at, at + 6);
    const key = Array.from(ends, (x) => Math.round(x * 1e4)).join(" ");
    if (!exact.has(key)) rest.push(ends);
  }
  for (const ends of rest) {
    let found = false;
    for (let at = 0; at < to.length && !found; at += 6) {
      found = true;
      for (let k = 0; k < 6 && found; ++k) found = Math.abs(to[at + k] - ends[k]) < 2e-3;
    }
    if (!found) ++alone;
  }
  return alone;
}

test("WebAssembly finds the workstation's segments", { skip }, async () => {
  const folder = mkdtempSync(join(tmpdir(), "sline-lines-"));
  try {
    const scene = join(folder, "scene.sline");
    const pack = join(folder, "scene.pack");
    execFileSync(join(bin, "sline"), ["demo", "pelvis", "-o", scene]);
    const desktop = JSON.parse(execFileSync(join(bin, "sline-page-lines"), [scene, pack], { maxBuffer: 1 << 30 }));
    const { default: create } = await import(glue);
    const module = await create({ wasmBinary: readFileSync(join(bin, "page", "engine.wasm")) });
    module._slineOpen();
    module._slineSize(1280, 720, 1);
    const bytes = readFileSync(pack);
    const place = module._malloc(bytes.length);
    module.HEAPU8.set(bytes, place);
    assert.ok(module._slineTake(place, bytes.length));
    for (const { camera, ends } of desktop) {
      const at = module._malloc(48);
      module.HEAPF32.set(camera, at / 4);
      module._slineSetCamera(at);
      const first = module._slineSegments() / 4;
      const own = Float32Array.from(module.HEAPF32.subarray(first + 1, first + module.HEAPF32[first]));
      assert.ok(ends.length > 6 * 1000, "the scene has lines");
      const all = ends.length / 6;
      const missing = unmatched(ends, own);
      const more = unmatched(own, ends);
      console.log(`${all} segments; ${missing} of them only on the desktop, ${more} only in WebAssembly`);
      assert.ok(missing <= 1e-4 * all && more <= 1e-4 * all);
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
});
