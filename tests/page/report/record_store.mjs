// SPDX-License-Identifier: Apache-2.0
// A learning system that launches pages by cmi5, with a store of statements and states behind the
// `fetch` that a page is given. It checks what it is sent by the rules of cmi5 (sections 7 to 10) and
// xAPI.

const verbs = "http://adlnet.gov/expapi/verbs/";
const categories = "https://w3id.org/xapi/cmi5/context/categories/";
const uuid = /^[0-9a-f]{8}-[0-9a-f]{4}-4[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}$/;

export class RecordStore {
  constructor({ mode = "Normal", masteryScore = undefined } = {}) {
    this.mode = mode;
    this.masteryScore = masteryScore;
    this.registration = "11111111-1111-4111-8111-111111111111";
    this.activity = "https://example.org/pages/pelvis";
    this.actor = { objectType: "Agent", account: { homePage: "https://example.org", name: "7" } };
    this.connected = true;
    /** Statements arrive, but the page does not hear so. */
    this.mute = false;
    /** The page is closed: what it has asked for by then is answered, and no more. */
    this.pageGone = false;
    this.statements = [];
    this.faults = [];
    this.state = undefined;
    this.sessions = 0;
  }

  /** A launch: what the page finds in its address. */
  launch() {
    ++this.sessions;
    this.tokenGiven = false;
    this.session = `session-${this.sessions}`;
    return (
      "?" +
      new URLSearchParams({
        endpoint: "https://store.example/xapi",
        fetch: "https://store.example/token",
        registration: this.registration,
        activityId: this.activity,
        actor: JSON.stringify(this.actor),
      })
    );
  }

  fetch = async (place, how = {}) => {
    if (this.pageGone) throw new TypeError("nobody asks");
    await Promise.resolve();
    if (!this.connected) throw new TypeError("Failed to fetch");
    const url = new URL(place);
    const reply = (status, body) => ({ ok: status < 300, status, json: async () => body });
    if (url.pathname === "/token") {
      if (how.method !== "POST" || this.tokenGiven) return reply(200, { "error-code": "1", "error-text": "used" });
      this.tokenGiven = true;
      return reply(200, { "auth-token": this.session });
    }
    if (how.headers?.Authorization !== `Basic ${this.session}`) return reply(401);
    if (!how.headers["X-Experience-API-Version"]?.startsWith("1.0")) return reply(400);
    if (url.pathname === "/xapi/agents/profile") return reply(404);
    if (url.pathname === "/xapi/activities/state") return this.answerState(url.searchParams, how, reply);
    if (url.pathname !== "/xapi/statements" || how.method !== "POST") return reply(404);
    const status = this.take(JSON.parse(how.body));
    if (this.mute) throw new TypeError("Failed to fetch");
    return reply(status, []);
  };

  answerState(query, how, reply) {
    if (
      query.get("activityId") !== this.activity ||
      query.get("registration") !== this.registration ||
      query.get("agent") !== JSON.stringify(this.actor)
    )
      return reply(400);
    if (query.get("stateId") === "LMS.LaunchData") {
      if (how.method) return reply(403);
      return reply(200, {
        launchMode: this.mode,
        moveOn: "CompletedOrPassed",
        masteryScore: this.masteryScore,
        contextTemplate: {
          extensions: {
            "https://w3id.org/xapi/cmi5/context/extensions/sessionid": this.session,
          },
        },
      });
    }
    if (how.method === "PUT") {
      this.state = JSON.parse(how.body);
      return reply(204);
    }
    return this.state ? reply(200, this.state) : reply(404);
  }

  take(sent) {
    for (const statement of sent) {
      const known = this.statements.find((each) => each.id === statement.id);
      if (known && JSON.stringify(known) !== JSON.stringify(statement)) return 409;
      if (known) continue;
      this.check(statement);
      this.statements.push(statement);
    }
    return 200;
  }

  check(statement) {
    const { id, verb, object, context, timestamp, actor, result } = statement;
    const fault = (what) => this.faults.push(`${verb?.id}: ${what}`);
    const session = context?.extensions?.["https://w3id.org/xapi/cmi5/context/extensions/sessionid"];
    const before = this.statements.filter((each) => sessionOf(each) === session);
    const has = (list, name) => list.some((each) => each.verb.id === verbs + name);
    const known = new Set(["id", "actor", "verb", "object", "result", "context", "timestamp"]);
    if (Object.keys(statement).some((key) => !known.has(key))) fault("has what xAPI does not know");
    if (!uuid.test(id)) fault("no identifier");
    if (JSON.stringify(actor) !== JSON.stringify(this.actor)) fault("of someone else");
    if (Number.isNaN(Date.parse(timestamp))) fault("no time");
    if (context?.registration !== this.registration || session !== this.session) fault("not of the launch");
    const name = verb.id.replace(verbs, "");
    const defined = ["initialized", "completed", "passed", "failed", "terminated"].includes(name);
    const groups = (context.contextActivities?.category ?? []).map((each) => each.id.replace(categories, ""));
    if (defined !== groups.includes("cmi5")) fault("category");
    if (["completed", "passed", "failed"].includes(name) !== groups.includes("moveon")) fault("category of moving on");
    if ((name === "initialized") !== (before.length === 0)) fault("not the first, or not initialized");
    if (has(before, "terminated")) fault("after the end");
    if (["completed", "passed"].includes(name) && has(this.statements, name)) fault("twice in a registration");
    if (defined && object.id !== this.activity) fault("of another activity");
    if (name === "answered" && object.definition?.type !== "http://adlnet.gov/expapi/activities/cmi.interaction")
      fault("no interaction");
    if (
      ["completed", "passed", "failed", "terminated"].includes(name) &&
      !/^PT\d+(\.\d+)?S$/.test(result?.duration ?? "")
    )
      fault("no duration");
    if (name === "completed" && (result.completion !== true || result.score)) fault("completion");
    if (["passed", "failed"].includes(name) && result.success !== (name === "passed")) fault("success");
    if (
      this.masteryScore !== undefined &&
      ["passed", "failed"].includes(name) &&
      result.score.scaled >= this.masteryScore !== (name === "passed")
    )
      fault("against the mastery score");
    if (this.mode !== "Normal" && !["initialized", "terminated"].includes(name)) fault(`in ${this.mode}`);
  }

  of(name) {
    return this.statements.filter((each) => each.verb.id === verbs + name);
  }

  results() {
    return new Map(
      this.of("answered").map((each) => [decodeURIComponent(each.object.id.split("#")[1]), each.result.success]),
    );
  }
}

function sessionOf(statement) {
  return statement.context?.extensions?.["https://w3id.org/xapi/cmi5/context/extensions/sessionid"];
}
