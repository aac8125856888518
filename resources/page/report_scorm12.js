// SPDX-License-Identifier: Apache-2.0
// Tells answers by SCORM 1.2.

import { ScormReporter } from "./report_scorm.js";
import { clockTime, decimal, identifier, shareOf, shortened, suspendedText } from "./report_texts.js";

/** @import { Answer } from "./reporter.d.ts" */

/** @type {{[kind: string]: string}} */
const scorm12Types = { name: "fill-in", choose: "fill-in" };

export class Scorm12Reporter extends ScormReporter {
  constructor() {
    super("API", "LMS");
  }

  /** @override @param {string} error */
  alreadyOpen(error) {
    return error === "101" && this.get("cmi.core._children") !== "";
  }

  /** @override */
  modeElement() {
    return "cmi.core.lesson_mode";
  }

  /** @override */
  finishName() {
    return "Finish";
  }

  /** @override */
  start() {
    const status = this.get("cmi.core.lesson_status");
    if (status === "" || status === "not attempted") this.set("cmi.core.lesson_status", "incomplete");
    // Said beforehand, as a page may be closed without another word.
    this.set("cmi.core.exit", "suspend");
  }

  /** @override @param {Answer} answer @param {string} at */
  writeAnswer(answer, at) {
    this.set(at + "id", identifier(answer.id));
    this.set(at + "type", scorm12Types[answer.kind] ?? "performance");
    this.set(at + "time", new Date().toTimeString().slice(0, 8));
    this.set(at + "student_response", shortened(answer.response, 255));
    this.set(at + "result", answer.correct ? "correct" : "wrong");
    this.set(at + "weighting", "1");
    this.set(at + "latency", clockTime(answer.seconds));
  }

  /** @override @param {boolean} ended */
  writeState(ended) {
    const share = shareOf(this.right, this.total);
    const told = this.set("cmi.core.score.raw", decimal(100 * share));
    this.set("cmi.core.score.min", "0");
    this.set("cmi.core.score.max", "100");
    this.set("cmi.core.session_time", clockTime(this.seconds()));
    if (ended) {
      const mastery = Number.parseFloat(this.get("cmi.student_data.mastery_score"));
      this.set(
        "cmi.core.lesson_status",
        Number.isNaN(mastery) ? "completed" : 100 * share >= mastery ? "passed" : "failed",
      );
      this.set("cmi.core.exit", "");
    }
    return this.set("cmi.suspend_data", suspendedText(this.answered, 4096)) || told;
  }
}
