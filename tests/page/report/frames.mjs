// SPDX-License-Identifier: Apache-2.0
// A browser's window, as far as reporters need one: with frames around it, events, and timers that
// run when the test lets them.
import { execFileSync } from "node:child_process";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import vm from "node:vm";

const pageFolder = join(dirname(fileURLToPath(import.meta.url)), "..", "..", "..", "resources", "page");
const source = execFileSync(
  process.env.SLINE_ESBUILD ?? "esbuild",
  ["--bundle", "--format=iife", "--global-name=reporters", "--log-level=warning"],
  { cwd: pageFolder, encoding: "utf8", input: 'export * from "./report_kinds.js"; export * from "./report_texts.js";' },
);
const program = new vm.Script(`${source}\nreporters;`);

/** A frame that holds others: `api` are its own properties. */
export function frameAround(api = {}, parent = undefined, opener = null) {
  const frame = { opener, ...api };
  frame.parent = parent ?? frame;
  frame.top = parent ? parent.top : frame;
  return frame;
}

export class PageWindow {
  /** @param {{parent?: object, opener?: object, search?: string, fetch?: Function}} around */
  constructor({ parent, opener = null, search = "", fetch = () => Promise.reject(new Error("offline")) } = {}) {
    this.listeners = new Map();
    this.timers = new Map();
    this.lastTimer = 0;
    this.reloads = 0;
    const listen = (type, listener) => this.listeners.set(type, [...(this.listeners.get(type) ?? []), listener]);
    const window = {
      opener,
      location: { search, reload: () => ++this.reloads },
      addEventListener: listen,
      setTimeout: (task) => (this.timers.set(++this.lastTimer, task), this.lastTimer),
      clearTimeout: (timer) => this.timers.delete(timer),
    };
    window.parent = parent ?? window;
    window.top = parent ? parent.top : window;
    this.window = window;
    this.document = { visibilityState: "visible", addEventListener: listen };
    const globals = { window, document: this.document, crypto, URLSearchParams, structuredClone, fetch, Date };
    this.scripts = program.runInContext(vm.createContext(globals));
  }

  reporter(kind) {
    return this.scripts.createReporter(kind);
  }

  tell(type, event = {}) {
    for (const listener of this.listeners.get(type) ?? []) listener(event);
  }

  /** Lets the timers run that wait, once. */
  runTimers() {
    const waiting = [...this.timers.values()];
    this.timers.clear();
    for (const task of waiting) task();
  }
}

/** Lets promises settle. */
export async function settled() {
  for (let i = 0; i < 20; ++i) await new Promise((done) => setImmediate(done));
}

/** Numbers by chance, the same each time (Steele, Lea, Flood: SplitMix, 2014, with 32 bits). */
export class Chance {
  constructor(seed) {
    this.state = seed >>> 0;
  }
  next() {
    this.state = (this.state + 0x9e3779b9) >>> 0;
    let mixed = this.state;
    mixed = Math.imul(mixed ^ (mixed >>> 16), 0x21f0aaad);
    mixed = Math.imul(mixed ^ (mixed >>> 15), 0x735a2d97);
    return ((mixed ^ (mixed >>> 15)) >>> 0) / 2 ** 32;
  }
  below(count) {
    return Math.floor(this.next() * count);
  }
  happens(share) {
    return this.next() < share;
  }
}
