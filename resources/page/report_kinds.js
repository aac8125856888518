// SPDX-License-Identifier: Apache-2.0
// Chooses to whom answers are told.

import { Cmi5Reporter } from "./report_cmi5.js";
import { Scorm12Reporter } from "./report_scorm12.js";
import { Scorm2004Reporter } from "./report_scorm2004.js";

/** @import { CreateReporter, Reporter } from "./reporter.d.ts" */

/** Tells nobody. @implements {Reporter} */
class SilentReporter {
  async begin() {
    return { answered: {} };
  }
  answer() {}
  end() {}
  suspend() {}
}

/** @type {CreateReporter} */
export function createReporter(kind) {
  if (!kind) return new SilentReporter();
  // A page that comes back from the browser's memory has told its system that it was left.
  window.addEventListener("pageshow", (event) => {
    if (event.persisted) window.location.reload();
  });
  if (kind === "scorm12") return new Scorm12Reporter();
  return kind === "scorm2004" ? new Scorm2004Reporter() : new Cmi5Reporter();
}
