// SPDX-License-Identifier: Apache-2.0
// Chooses to whom answers are told.

/** Tells nobody. @implements {Reporter} */
class SilentReporter {
  async begin() {
    return { answered: {} };
  }
  answer() {}
  end() {}
  suspend() {}
}

/**
 * @param {"scorm12" | "scorm2004" | "cmi5" | undefined} kind
 * @returns {Reporter}
 */
function createReporter(kind) {
  if (!kind) return new SilentReporter();
  // A page that comes back from the browser's memory has told its system that it was left.
  window.addEventListener("pageshow", (event) => {
    if (event.persisted) window.location.reload();
  });
  if (kind === "scorm12") return new Scorm12Reporter();
  return kind === "scorm2004" ? new Scorm2004Reporter() : new Cmi5Reporter();
}
