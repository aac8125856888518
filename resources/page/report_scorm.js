// SPDX-License-Identifier: Apache-2.0
// Tells answers to a learning system by SCORM: what its versions have in common.

import { DeliveryQueue } from "./report_queue.js";
import { answeredIn } from "./report_texts.js";

/** @import { Answer } from "./reporter.d.ts" */

/** @typedef {{[name: string]: unknown}} ScormApi */

/** How far up the frames an API is looked for. */
const mostFrames = 500;

/**
 * Looks in the window and those around it.
 * @param {Window | null} from
 * @param {string} name
 * @returns {ScormApi | undefined}
 */
function apiAround(from, name) {
  let frame = from;
  for (let i = 0; frame && i < mostFrames; ++i) {
    try {
      const there = /** @type {any} */ (frame)[name];
      if (there) return there;
      if (!frame.parent || frame.parent === frame) return undefined;
      frame = frame.parent;
    } catch {
      return undefined; // of another origin
    }
  }
  return undefined;
}

/** @param {string} name @returns {ScormApi | undefined} */
function findApi(name) {
  const near = apiAround(window, name);
  if (near) return near;
  try {
    return apiAround(window.opener, name) ?? apiAround(window.top?.opener ?? null, name);
  } catch {
    return undefined;
  }
}

/**
 * What is told: an answer, which keeps its number from its first try on, or just how things stand.
 * @typedef {{answer?: Answer, number?: number}} ScormJob
 */

/** One version says which elements there are, and what is written into them. */
export class ScormReporter {
  /** @param {string} apiName @param {string} prefix of the API's functions */
  constructor(apiName, prefix) {
    this.api = findApi(apiName);
    this.prefix = prefix;
    this.began = Date.now();
    this.open = false;
    this.silent = false;
    this.ended = false;
    this.left = false;
    this.total = 0;
    this.right = 0;
    this.next = 0;
    /** @type {Map<string, boolean>} */
    this.answered = new Map();
    /** @type {DeliveryQueue<ScormJob>} */
    this.queue = new DeliveryQueue((jobs) => this.deliver(jobs));
    window.addEventListener("pagehide", () => this.suspend());
  }

  /** @param {string} name @param {...string} values @returns {string} empty where it fails */
  call(name, ...values) {
    const asked = this.api?.[this.prefix + name];
    if (typeof asked !== "function") return "";
    try {
      return String(asked.apply(this.api, values) ?? "");
    } catch {
      return "";
    }
  }

  /** @param {string} element */
  get(element) {
    const value = this.call("GetValue", element);
    return value === "undefined" || value === "null" ? "" : value;
  }

  /** @param {string} element @param {string} value */
  set(element, value) {
    return this.call("SetValue", element, value) === "true";
  }

  /** Begins talking; a system where that has been done already goes on. */
  initialize() {
    if (this.open || !this.api) return this.open;
    const began = this.call("Initialize", "") === "true";
    this.open = began || this.alreadyOpen(this.call("GetLastError"));
    return this.open;
  }

  /** @param {number} total */
  async begin(total) {
    this.total = total;
    if (this.initialize()) this.resume();
    return { answered: Object.fromEntries(this.answered) };
  }

  /** Reads what an attempt before has left. */
  resume() {
    // A system that tells no mode has the usual one. What is reviewed or browsed is not told.
    this.silent = ["review", "browse"].includes(this.get(this.modeElement()));
    for (const [id, right] of answeredIn(this.get("cmi.suspend_data"))) {
      this.answered.set(id, right);
      if (right) ++this.right;
    }
    this.next = Number.parseInt(this.get("cmi.interactions._count"), 10) || 0;
    if (this.silent) return;
    this.start();
    this.call("Commit", "");
  }

  /** @param {Answer} answer */
  answer(answer) {
    if (!this.api || this.silent || this.answered.has(answer.id)) return;
    this.answered.set(answer.id, answer.correct);
    if (answer.correct) ++this.right;
    this.queue.add({ answer });
  }

  /** @param {number} right @param {number} total */
  end(right, total) {
    if (!this.api || this.silent || this.ended) return;
    this.right = right;
    this.total = total;
    this.ended = true;
    this.queue.add({});
  }

  /** The page is left. Until then the system is not told to close it, so that results can be read. */
  suspend() {
    if (!this.api || this.left) return;
    this.left = true;
    if (!this.silent) this.queue.add({});
    else if (this.open) this.call(this.finishName(), "");
  }

  /**
   * Writes all that has happened and has it kept. Nothing counts as arrived before it is kept.
   * @param {readonly ScormJob[]} jobs
   */
  deliver(jobs) {
    if (!this.initialize()) return 0;
    for (const job of jobs) {
      if (!job.answer) continue;
      job.number ??= this.next++;
      this.writeAnswer(job.answer, `cmi.interactions.${job.number}.`);
    }
    const told = this.writeState(this.ended);
    const kept = this.call("Commit", "") === "true";
    if (this.left) this.call(this.finishName(), "");
    if (!told || this.left) this.open = false; // it may have forgotten the session
    return told && kept ? jobs.length : 0;
  }

  seconds() {
    return (Date.now() - this.began) / 1000;
  }

  // What follows is what the versions differ in.

  /** @param {string} _error @returns {boolean} */
  alreadyOpen(_error) {
    return false;
  }
  modeElement() {
    return "";
  }
  finishName() {
    return "";
  }
  /** Says that an attempt is on its way. */
  start() {}
  /** @param {Answer} _answer @param {string} _at */
  writeAnswer(_answer, _at) {}
  /** @param {boolean} _ended @returns {boolean} whether anything of it was taken */
  writeState(_ended) {
    return false;
  }
}
