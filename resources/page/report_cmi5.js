// SPDX-License-Identifier: Apache-2.0
// Tells answers to a learning record store by cmi5, as xAPI statements.

import { DeliveryQueue } from "./report_queue.js";
import { decimal, isoTime, shareOf } from "./report_texts.js";

/** @import { Answer } from "./reporter.d.ts" */

/** @typedef {{[name: string]: any}} Statement */
/** @typedef {{answered: {[question: string]: boolean}, ended: boolean}} Cmi5State */
/** What is sent: a statement, or how things stand. @typedef {{statement?: Statement, state?: Cmi5State}} Cmi5Job */

const cmi5Categories = "https://w3id.org/xapi/cmi5/context/categories/";
const cmi5Verbs = {
  initialized: "http://adlnet.gov/expapi/verbs/initialized",
  answered: "http://adlnet.gov/expapi/verbs/answered",
  scored: "http://adlnet.gov/expapi/verbs/scored",
  completed: "http://adlnet.gov/expapi/verbs/completed",
  passed: "http://adlnet.gov/expapi/verbs/passed",
  failed: "http://adlnet.gov/expapi/verbs/failed",
  terminated: "http://adlnet.gov/expapi/verbs/terminated",
};

/** @typedef {keyof typeof cmi5Verbs} Cmi5Verb */

/** @type {{[kind: string]: string}} */
const cmi5Types = { name: "fill-in", choose: "fill-in" };

/** @returns {string} of random digits, in the form that statements have (RFC 4122, version 4) */
function randomUuid() {
  const bytes = crypto.getRandomValues(new Uint8Array(16));
  bytes[6] = (bytes[6] & 0x0f) | 0x40;
  bytes[8] = (bytes[8] & 0x3f) | 0x80;
  const digits = [...bytes].map((byte) => byte.toString(16).padStart(2, "0")).join("");
  return digits.replace(/^(.{8})(.{4})(.{4})(.{4})(.{12})$/, "$1-$2-$3-$4-$5");
}

export class Cmi5Reporter {
  constructor() {
    const launch = new URLSearchParams(window.location.search);
    const endpoint = launch.get("endpoint") ?? "";
    this.endpoint = endpoint && !endpoint.endsWith("/") ? endpoint + "/" : endpoint;
    this.tokenPlace = launch.get("fetch") ?? "";
    this.registration = launch.get("registration") ?? "";
    this.activity = launch.get("activityId") ?? "";
    /** @type {object | undefined} */
    this.actor = this.actorIn(launch.get("actor") ?? "");
    this.began = Date.now();
    this.token = "";
    /** @type {{[name: string]: any}} */
    this.launchData = {};
    this.ready = false;
    this.silent = false;
    this.total = 0;
    this.left = false;
    /** @type {Map<string, boolean>} */
    this.answered = new Map();
    this.ended = false;
    /** @type {DeliveryQueue<Cmi5Job>} */
    this.queue = new DeliveryQueue((jobs) => this.deliver(jobs));
    window.addEventListener("pagehide", () => this.suspend());
  }

  /** @param {string} text */
  actorIn(text) {
    try {
      const actor = JSON.parse(text);
      return actor && typeof actor === "object" ? actor : undefined;
    } catch {
      return undefined;
    }
  }

  /** Whether the page was started by a learning system at all. */
  get launched() {
    return Boolean(this.endpoint && this.tokenPlace && this.activity && this.actor);
  }

  /** @param {number} total */
  async begin(total) {
    this.total = total;
    if (this.launched) {
      // While the store cannot be reached, answers wait for it.
      await this.prepare().catch(() => {});
      this.say("initialized", { result: undefined });
    }
    return { answered: Object.fromEntries(this.answered) };
  }

  /** Fetches the token, which is given once, and what the system says of the launch. */
  async prepare() {
    if (this.ready) return;
    if (!this.token) {
      const given = await this.fetched(this.tokenPlace, { method: "POST" });
      this.token = String((await given.json())["auth-token"] ?? "");
      if (!this.token) throw new Error("no token");
    }
    this.launchData = (await this.stateOf("LMS.LaunchData")) ?? {};
    // The standard wants it read, whatever the page makes of it.
    await this.readPreferences();
    this.silent = ["Browse", "Review"].includes(this.launchData.launchMode);
    this.take(await this.stateOf("sline"));
    this.ready = true;
  }

  /** @param {any} state of an attempt before */
  take(state) {
    if (!state || typeof state.answered !== "object" || !state.answered) return;
    const now = [...this.answered];
    this.answered.clear();
    for (const [id, right] of Object.entries(state.answered)) this.answered.set(id, right === true);
    for (const [id, right] of now) if (!this.answered.has(id)) this.answered.set(id, right);
    this.ended = this.ended || state.ended === true;
  }

  async readPreferences() {
    const query = new URLSearchParams({ profileId: "cmi5LearnerPreferences", agent: JSON.stringify(this.actor) });
    await this.fetched(`${this.endpoint}agents/profile?${query}`, { headers: this.headers() }).catch(() => {});
  }

  headers() {
    return {
      Authorization: `Basic ${this.token}`,
      "X-Experience-API-Version": "1.0.3",
      "Content-Type": "application/json",
    };
  }

  /**
   * @param {string} place
   * @param {RequestInit} how
   * @returns {Promise<Response>} of requests that succeed
   */
  async fetched(place, how) {
    const response = await fetch(place, { credentials: "omit", ...how });
    if (!response.ok) throw new Error(`${response.status}`);
    return response;
  }

  /** @param {string} id */
  stateUrl(id) {
    const query = new URLSearchParams({
      activityId: this.activity,
      agent: JSON.stringify(this.actor),
      registration: this.registration,
      stateId: id,
    });
    return `${this.endpoint}activities/state?${query}`;
  }

  /** @param {string} id @returns {Promise<any>} undefined where there is none */
  async stateOf(id) {
    const response = await fetch(this.stateUrl(id), { credentials: "omit", headers: this.headers() });
    if (response.status === 404) return undefined;
    if (!response.ok) throw new Error(`${response.status}`);
    return response.json();
  }

  seconds() {
    return (Date.now() - this.began) / 1000;
  }

  /**
   * What the system wants in each statement, with the categories that cmi5 asks for.
   * @param {Cmi5Verb} verb
   */
  context(verb) {
    /** @type {any} */
    const context = structuredClone(this.launchData.contextTemplate ?? {});
    context.registration = this.registration;
    if (["answered", "scored"].includes(verb)) return context;
    const activities = (context.contextActivities ??= {});
    const moves = ["completed", "passed", "failed"].includes(verb);
    activities.category = [
      ...(activities.category ?? []),
      { id: cmi5Categories + "cmi5" },
      ...(moves ? [{ id: cmi5Categories + "moveon" }] : []),
    ];
    return context;
  }

  /** @param {Cmi5Verb} verb @param {{object?: object, result?: object}} more */
  statement(verb, more) {
    return {
      id: randomUuid(),
      timestamp: new Date().toISOString(),
      actor: this.actor,
      verb: { id: cmi5Verbs[verb], display: { en: verb } },
      object: { objectType: "Activity", id: this.activity },
      verbName: verb,
      ...more,
    };
  }

  /** @param {Cmi5Verb} verb @param {{object?: object, result?: object}} more */
  say(verb, more) {
    // In other modes than the normal one a score is not for the system to know.
    if (this.silent && !["initialized", "terminated"].includes(verb)) return;
    this.queue.add({ statement: this.statement(verb, more) });
  }

  /** @param {Answer} answer */
  answer(answer) {
    if (!this.launched || this.answered.has(answer.id)) return;
    this.answered.set(answer.id, answer.correct);
    this.say("answered", {
      object: {
        objectType: "Activity",
        id: `${this.activity}#${encodeURIComponent(answer.id)}`,
        definition: {
          type: "http://adlnet.gov/expapi/activities/cmi.interaction",
          interactionType: cmi5Types[answer.kind] ?? "other",
          name: { und: answer.words },
        },
      },
      result: { success: answer.correct, response: answer.response, duration: isoTime(answer.seconds) },
    });
    this.keepState();
  }

  keepState() {
    if (this.silent) return;
    this.queue.add({ state: { answered: Object.fromEntries(this.answered), ended: this.ended } });
  }

  /** @param {number} right @param {number} total */
  end(right, total) {
    if (!this.launched || this.ended) return;
    this.ended = true;
    const scaled = Number(decimal(shareOf(right, total)));
    const score = { scaled, raw: right, min: 0, max: Math.max(1, total) };
    const duration = isoTime(this.seconds());
    const mastery = this.launchData.masteryScore;
    if (typeof mastery === "number") {
      const passed = scaled >= mastery;
      this.say(passed ? "passed" : "failed", { result: { success: passed, score, duration } });
    } else this.say("scored", { result: { score, duration } });
    this.say("completed", { result: { completion: true, duration } });
    this.keepState();
  }

  /** The page is left. */
  suspend() {
    if (!this.launched || this.left) return;
    this.left = true;
    const busy = this.queue.busy;
    this.say("terminated", { result: { duration: isoTime(this.seconds()) } });
    // There is no later, so what another request may have brought already is sent again.
    if (busy && this.ready) this.deliver(this.queue.jobs).catch(() => {});
  }

  /**
   * Sends the statements that wait, all at once, and the last state. A statement that has arrived
   * before is known by its identifier.
   * @param {readonly Cmi5Job[]} jobs
   * @returns {Promise<number>}
   */
  async deliver(jobs) {
    const count = jobs.length;
    if (!this.ready) await this.prepare();
    const waiting = jobs.slice(0, count);
    const statements = waiting.flatMap((job) =>
      job.statement && this.isWanted(job.statement) ? [this.completed(job.statement)] : [],
    );
    const state = waiting
      .map((job) => job.state)
      .filter(Boolean)
      .pop();
    const sent = [];
    if (statements.length) sent.push(this.sendStatements(statements));
    if (state && !this.silent)
      sent.push(
        this.fetched(this.stateUrl("sline"), {
          method: "PUT",
          keepalive: this.left,
          headers: this.headers(),
          body: JSON.stringify(state),
        }),
      );
    await Promise.all(sent);
    return count;
  }

  /** @param {Statement[]} statements */
  async sendStatements(statements) {
    const response = await fetch(`${this.endpoint}statements`, {
      credentials: "omit",
      method: "POST",
      keepalive: this.left,
      headers: this.headers(),
      body: JSON.stringify(statements),
    });
    // 409: one of them is there already.
    if (response.status === 409 && statements.length > 1)
      for (const statement of statements) await this.sendStatements([statement]);
    else if (!response.ok && response.status !== 409) throw new Error(`${response.status}`);
  }

  /** @param {Statement} statement */
  isWanted(statement) {
    return !this.silent || ["initialized", "terminated"].includes(statement.verbName);
  }

  /** The statement with its context, which is known once the store was reached. @param {Statement} statement */
  completed({ verbName, ...statement }) {
    return { ...statement, context: this.context(verbName) };
  }
}
