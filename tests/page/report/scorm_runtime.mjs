// SPDX-License-Identifier: Apache-2.0
// Learning systems' side of SCORM 1.2 (Run-Time Environment, 3.3 and 3.4) and 2004 (4th edition, 3.1
// and 4.2): the calls in their order, the elements that the page may use with their types, and what
// is kept. Faults of real systems can be switched on.

const clock12 = /^\d{2,4}:[0-5]\d:[0-5]\d(\.\d{1,2})?$/;
const percent = (text) => /^-?\d+(\.\d+)?$/.test(text) && Number(text) >= 0 && Number(text) <= 100;
const oneOf =
  (...values) =>
  (text) =>
    values.includes(text);
const atMost = (count) => (text) => text.length <= count;

const versions = {
  scorm12: {
    api: "API",
    prefix: "LMS",
    finish: "Finish",
    notRunning: "301",
    elements: {
      "cmi.core._children": { reads: true },
      "cmi.core.lesson_mode": { reads: true },
      "cmi.core.entry": { reads: true },
      "cmi.core.lesson_status": { reads: true, takes: oneOf("passed", "completed", "failed", "incomplete", "browsed") },
      "cmi.core.score.raw": { reads: true, takes: percent },
      "cmi.core.score.min": { reads: true, takes: percent },
      "cmi.core.score.max": { reads: true, takes: percent },
      "cmi.core.exit": { takes: oneOf("time-out", "suspend", "logout", "") },
      "cmi.core.session_time": { takes: (text) => clock12.test(text) },
      "cmi.suspend_data": { reads: true, takes: atMost(4096) },
      "cmi.student_data.mastery_score": { reads: true },
      "cmi.interactions._count": { reads: true },
    },
    interaction: {
      id: (text) => /^[\w.-]{1,255}$/.test(text),
      type: oneOf("true-false", "choice", "fill-in", "matching", "performance", "sequencing", "likert", "numeric"),
      time: (text) => /^([01]\d|2[0-3]):[0-5]\d:[0-5]\d(\.\d{1,2})?$/.test(text),
      student_response: atMost(255),
      result: (text) => oneOf("correct", "wrong", "unanticipated", "neutral")(text),
      weighting: (text) => /^-?\d+(\.\d+)?$/.test(text),
      latency: (text) => clock12.test(text),
    },
    exit: "cmi.core.exit",
    mode: "cmi.core.lesson_mode",
    status: "cmi.core.lesson_status",
  },
  scorm2004: {
    api: "API_1484_11",
    prefix: "",
    finish: "Terminate",
    notRunning: "132",
    elements: {
      "cmi.mode": { reads: true },
      "cmi.entry": { reads: true },
      "cmi.completion_status": { reads: true, takes: oneOf("completed", "incomplete", "not attempted", "unknown") },
      "cmi.success_status": { reads: true, takes: oneOf("passed", "failed", "unknown") },
      "cmi.score.scaled": { reads: true, takes: (text) => Math.abs(Number(text)) <= 1 && /^-?\d/.test(text) },
      "cmi.score.raw": { reads: true, takes: percent },
      "cmi.score.min": { reads: true, takes: percent },
      "cmi.score.max": { reads: true, takes: percent },
      "cmi.progress_measure": { reads: true, takes: (text) => Number(text) >= 0 && Number(text) <= 1 },
      "cmi.exit": { takes: oneOf("time-out", "suspend", "logout", "normal", "") },
      "cmi.session_time": { takes: (text) => /^PT\d+(\.\d{1,2})?S$/.test(text) },
      "cmi.suspend_data": { reads: true, takes: atMost(4000) },
      "cmi.scaled_passing_score": { reads: true },
      "cmi.interactions._count": { reads: true },
    },
    interaction: {
      id: (text) => /^[\w.:-]{1,4000}$/.test(text),
      type: oneOf(
        "true-false",
        "choice",
        "fill-in",
        "long-fill-in",
        "matching",
        "performance",
        "sequencing",
        "likert",
        "numeric",
        "other",
      ),
      timestamp: (text) => /^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d{1,2}(Z|[+-]\d\d(:\d\d)?)?)?$/.test(text),
      learner_response: atMost(250),
      result: oneOf("correct", "incorrect", "unanticipated", "neutral"),
      weighting: (text) => /^-?\d+(\.\d+)?$/.test(text),
      latency: (text) => /^PT\d+(\.\d{1,2})?S$/.test(text),
      description: atMost(250),
    },
    exit: "cmi.exit",
    mode: "cmi.mode",
    status: "cmi.completion_status",
  },
};

export class ScormSystem {
  /**
   * @param {"scorm12" | "scorm2004"} kind
   * @param {{mode?: string, mastery?: string, neverCloses?: boolean}} how; an empty mode is what some
   * systems tell
   */
  constructor(kind, { mode = "normal", mastery = "", neverCloses = false } = {}) {
    this.version = versions[kind];
    this.kind = kind;
    this.neverCloses = neverCloses;
    this.kept = new Map([
      [this.version.mode, mode],
      [this.version.status, "not attempted"],
      [kind === "scorm12" ? "cmi.student_data.mastery_score" : "cmi.scaled_passing_score", mastery],
    ]);
    if (kind === "scorm12") this.kept.set("cmi.core._children", "lesson_mode,lesson_status,score,exit,entry");
    /** @type {Map<string, string>[]} */
    this.interactions = [];
    this.connected = true;
    this.faults = [];
    this.calls = [];
  }

  /** What the page finds in the frame around it, anew each time it is opened. */
  frame() {
    this.state = "not initialized";
    this.error = "0";
    this.fresh = new Map();
    this.freshInteractions = [];
    const { prefix, finish } = this.version;
    const api = {};
    for (const name of [
      "Initialize",
      "GetValue",
      "SetValue",
      "Commit",
      finish,
      "GetLastError",
      "GetErrorString",
      "GetDiagnostic",
    ])
      api[prefix + name] = (...values) => this.answer(name, values);
    if (this.neverCloses) delete api[prefix + finish];
    return { [this.version.api]: api };
  }

  answer(name, values) {
    this.calls.push(name);
    if (name === "GetLastError") return this.error;
    if (name === "GetErrorString" || name === "GetDiagnostic") return "";
    if (values.some((value) => typeof value !== "string")) this.faults.push(`${name} with what is no string`);
    const result = this[name === this.version.finish ? "close" : name](...values);
    return result;
  }

  fail(code, value = "false") {
    this.error = code;
    return value;
  }

  Initialize(empty) {
    if (empty !== "") this.faults.push("Initialize with a value");
    if (this.state === "running") return this.fail(this.kind === "scorm12" ? "101" : "103");
    if (this.state === "closed") return this.fail(this.kind === "scorm12" ? "101" : "104");
    if (!this.connected) return this.fail("101");
    this.state = "running";
    this.error = "0";
    return "true";
  }

  GetValue(element) {
    if (this.state !== "running") return this.fail(this.version.notRunning, "");
    this.error = "0";
    if (element === "cmi.interactions._count")
      return String(Math.max(this.interactions.length, this.freshInteractions.length));
    const known = this.version.elements[element];
    if (!known?.reads) {
      this.faults.push(`reads ${element}`);
      return this.fail("401", "");
    }
    return this.fresh.get(element) ?? this.kept.get(element) ?? "";
  }

  SetValue(element, value) {
    if (this.state !== "running") return this.fail(this.version.notRunning);
    this.error = "0";
    const part = /^cmi\.interactions\.(\d+)\.(\w+)$/.exec(element);
    const takes = part ? this.version.interaction[part[2]] : this.version.elements[element]?.takes;
    if (!takes || !takes(value)) {
      this.faults.push(`writes ${element} = ${value}`);
      return this.fail("405");
    }
    if (!part) {
      this.fresh.set(element, value);
      return "true";
    }
    const count = Math.max(this.interactions.length, this.freshInteractions.length);
    const at = Number(part[1]);
    if (at > count || (at === count && part[2] !== "id")) {
      this.faults.push(`interaction ${at} of ${count}, ${part[2]}`);
      return this.fail("201");
    }
    for (let i = 0; i <= at; ++i) this.freshInteractions[i] ??= new Map(this.interactions[i]);
    this.freshInteractions[at].set(part[2], value);
    return "true";
  }

  Commit(empty) {
    if (empty !== "") this.faults.push("Commit with a value");
    if (this.state !== "running") return this.fail(this.version.notRunning);
    if (!this.connected) return this.fail("101");
    for (const [element, value] of this.fresh) this.kept.set(element, value);
    this.freshInteractions.forEach((one, i) => (this.interactions[i] = new Map(one)));
    this.error = "0";
    return "true";
  }

  close(empty) {
    if (this.state !== "running") return this.fail(this.version.notRunning);
    const done = this.Commit(empty);
    this.state = "closed";
    return done;
  }

  /** Forgets the session, as systems do where a person is away for long. */
  expire() {
    this.state = "not initialized";
    this.fresh.clear();
    this.freshInteractions = [];
  }

  value(element) {
    return this.kept.get(element) ?? "";
  }

  /** Whether the answers that were kept were right, by the names of their questions; the last counts. */
  results() {
    return new Map(this.interactions.map((one) => [one.get("id"), one.get("result") === "correct"]));
  }

  get share() {
    return this.kind === "scorm12"
      ? Number(this.value("cmi.core.score.raw")) / 100
      : Number(this.value("cmi.score.scaled"));
  }
}
