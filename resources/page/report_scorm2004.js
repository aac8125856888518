// SPDX-License-Identifier: Apache-2.0
// Tells answers by SCORM 2004.

import { ScormReporter } from "./report_scorm.js";
import { decimal, identifier, isoTime, shareOf, shortened, suspendedText } from "./report_texts.js";

/** @import { Answer } from "./reporter.d.ts" */

/** @type {{[kind: string]: string}} */
const scorm2004Types = { name: "fill-in", choose: "fill-in" };

export class Scorm2004Reporter extends ScormReporter {
  constructor() {
    super("API_1484_11", "");
  }

  /** @override @param {string} error */
  alreadyOpen(error) {
    return error === "103";
  }

  /** @override */
  modeElement() {
    return "cmi.mode";
  }

  /** @override */
  finishName() {
    return "Terminate";
  }

  /** @override */
  start() {
    const status = this.get("cmi.completion_status");
    if (status !== "completed") this.set("cmi.completion_status", "incomplete");
    // Said beforehand, as a page may be closed without another word.
    this.set("cmi.exit", "suspend");
  }

  /** @override @param {Answer} answer @param {string} at */
  writeAnswer(answer, at) {
    this.set(at + "id", identifier(answer.id));
    this.set(at + "type", scorm2004Types[answer.kind] ?? "other");
    // A zone stands behind parts of a second alone.
    this.set(at + "timestamp", new Date().toISOString().replace(/(\.\d\d)\d*Z$/, "$1Z"));
    this.set(at + "learner_response", shortened(answer.response, 250));
    this.set(at + "result", answer.correct ? "correct" : "incorrect");
    this.set(at + "weighting", "1");
    this.set(at + "latency", isoTime(answer.seconds));
    this.set(at + "description", shortened(answer.words, 250));
  }

  /** @override @param {boolean} ended */
  writeState(ended) {
    const share = shareOf(this.right, this.total);
    const told = this.set("cmi.score.scaled", decimal(share));
    this.set("cmi.score.raw", decimal(100 * share));
    this.set("cmi.score.min", "0");
    this.set("cmi.score.max", "100");
    this.set("cmi.progress_measure", decimal(ended ? 1 : shareOf(this.answered.size, this.total)));
    this.set("cmi.session_time", isoTime(this.seconds()));
    if (ended) {
      const passing = Number.parseFloat(this.get("cmi.scaled_passing_score"));
      this.set("cmi.completion_status", "completed");
      if (!Number.isNaN(passing)) this.set("cmi.success_status", share >= passing ? "passed" : "failed");
      this.set("cmi.exit", "normal");
    }
    return this.set("cmi.suspend_data", suspendedText(this.answered, 4000)) || told;
  }
}
