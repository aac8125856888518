// SPDX-License-Identifier: Apache-2.0
// A learning system for tests: it keeps what it is told in `window.reported`, and says that what
// `window.answeredBefore` holds was answered in an attempt before.

/** @param {"scorm12" | "scorm2004" | "cmi5" | undefined} kind @returns {Reporter} */
function createReporter(kind) {
  /** @type {unknown[]} */
  const told = [];
  Object.assign(window, { reported: told });
  return {
    async begin(total) {
      told.push({ begin: total, kind });
      const before = /** @type {{answeredBefore?: {[id: string]: boolean}}} */ (window).answeredBefore;
      return { answered: before ?? {} };
    },
    answer(answer) {
      told.push({ answer });
    },
    end(right, total) {
      told.push({ end: { right, total } });
    },
    suspend() {
      told.push("suspend");
    },
  };
}
