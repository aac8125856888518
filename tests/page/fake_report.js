// SPDX-License-Identifier: Apache-2.0
// A learning system for tests: it keeps what it is told in `window.reported`, and says that what
// `window.answeredBefore` holds was answered in an attempt before.

/** @import { CreateReporter } from "../../resources/page/reporter.d.ts" */

/** @type {CreateReporter} */
export function createReporter(kind) {
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
