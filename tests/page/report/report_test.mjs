// SPDX-License-Identifier: Apache-2.0
// Reporters against learning systems: attempts by chance, with whatever goes wrong there.
import assert from "node:assert/strict";
import test from "node:test";

import { Chance, frameAround, PageWindow, settled } from "./frames.mjs";
import { RecordStore } from "./record_store.mjs";
import { ScormSystem } from "./scorm_runtime.mjs";

const kinds = ["find", "name", "choose", "order", "drag"];

/** Questions with answers, by chance. */
function lesson(chance) {
  return Array.from({ length: 1 + chance.below(30) }, (_, i) => ({
    id: `${kinds[chance.below(kinds.length)]}-${i + 1}`,
    kind: kinds[chance.below(kinds.length)],
    words: ["ureter", "<img src=x onerror=alert(1)>", "Übergang „rechts“", "肝臓"][chance.below(4)],
    response: ["ureter", "\u0000\ud800 x\n".repeat(200), "“;[,]{}", ""][chance.below(4)],
    correct: chance.happens(0.6),
    seconds: 100 * chance.next(),
  }));
}

const rightOf = (answered) => [...answered.values()].filter(Boolean).length;

/**
 * Takes the lesson to its end, whatever happens on the way: `open` gives a page of the system,
 * `connect` makes its network fail and come back.
 */
async function attend(chance, questions, { open, connect, connected, expire }) {
  const answered = new Map();
  /** What has arrived for sure, so that no page may have forgotten it. */
  let arrived = new Map();
  for (let openings = 0; openings < 30; ++openings) {
    const calm = openings > 20;
    const { page, reporter } = open();
    const begun = reporter.begin(questions.length);
    await settled();
    const before = (await begun).answered;
    for (const id of arrived.keys()) assert.ok(id in before, `${id} is lost`);
    // A student sees what is answered, and answers the rest again.
    for (const id of [...answered.keys()]) if (!(id in before)) answered.delete(id);
    for (const [id, right] of Object.entries(before)) assert.equal(answered.get(id) ?? right, right, id);
    for (const [id, right] of Object.entries(before)) answered.set(id, right);
    let closed = false;
    for (const question of questions) {
      if (answered.has(question.id)) continue;
      if (!calm && chance.happens(0.08)) connect(false);
      if (chance.happens(0.3)) connect(true);
      if (!calm && expire && chance.happens(0.03)) expire();
      reporter.answer(question);
      answered.set(question.id, question.correct);
      if (chance.happens(0.5)) await settled();
      if (chance.happens(0.5)) {
        page.runTimers();
        await settled();
        if (connected()) arrived = new Map(answered);
      }
      if (calm || !chance.happens(0.06)) continue;
      closed = true;
      // It is closed properly, or the machine is switched off.
      if (chance.happens(0.6)) page.tell("pagehide");
      await settled();
      break;
    }
    if (closed) {
      connect(true);
      continue;
    }
    reporter.end(rightOf(answered), questions.length);
    connect(true);
    page.tell("online");
    await settled();
    page.runTimers();
    await settled();
    page.tell("pagehide");
    await settled();
    return answered;
  }
  throw new Error("never ended");
}

for (const kind of ["scorm12", "scorm2004"])
  test(`${kind}: a hundred attempts, a hundred right scores`, async () => {
    let right = 0;
    for (let seed = 1; seed <= 100; ++seed) {
      const chance = new Chance(seed);
      const mastery = kind === "scorm12" ? "50" : "0.5";
      const system = new ScormSystem(kind, {
        mode: ["normal", ""][chance.below(2)],
        mastery: chance.happens(0.5) ? mastery : "",
        neverCloses: chance.happens(0.2),
      });
      const questions = lesson(chance);
      const place = chance.below(3);
      const answered = await attend(chance, questions, {
        open() {
          const holder = frameAround(system.frame());
          const page =
            place === 0
              ? new PageWindow({ parent: holder })
              : place === 1
                ? new PageWindow({ parent: frameAround({}, frameAround({}, holder)) })
                : new PageWindow({ opener: frameAround({}, holder) });
          return { page, reporter: page.reporter(kind) };
        },
        connect: (on) => (system.connected = on),
        connected: () => system.connected,
        expire: () => system.expire(),
      });
      assert.deepEqual(system.faults, [], `attempt ${seed}`);
      const results = system.results();
      for (const question of questions)
        assert.equal(results.get(question.id.replace(/\W/g, "_")), question.correct, `attempt ${seed}, ${question.id}`);
      const share = rightOf(answered) / questions.length;
      assert.ok(Math.abs(system.share - share) < 1e-4, `attempt ${seed}: ${system.share}, not ${share}`);
      const status = system.value(kind === "scorm12" ? "cmi.core.lesson_status" : "cmi.completion_status");
      const passed = share >= 0.5 ? "passed" : "failed";
      if (kind === "scorm12")
        assert.equal(status, system.value("cmi.student_data.mastery_score") ? passed : "completed");
      else {
        assert.equal(status, "completed");
        assert.equal(system.value("cmi.success_status"), system.value("cmi.scaled_passing_score") ? passed : "");
      }
      ++right;
    }
    assert.equal(right, 100);
  });

test("cmi5: a hundred attempts, a hundred right scores", async () => {
  for (let seed = 1; seed <= 100; ++seed) {
    const chance = new Chance(1000 + seed);
    const store = new RecordStore({ masteryScore: chance.happens(0.5) ? 0.5 : undefined });
    const questions = lesson(chance);
    const answered = await attend(chance, questions, {
      open() {
        const page = new PageWindow({ search: store.launch(), fetch: store.fetch });
        return { page, reporter: page.reporter("cmi5") };
      },
      connect(on) {
        store.connected = on;
        store.mute = on && chance.happens(0.1);
        if (store.mute) setImmediate(() => (store.mute = false));
      },
      connected: () => store.connected,
    });
    assert.deepEqual(store.faults, [], `attempt ${seed}`);
    const results = store.results();
    for (const question of questions)
      assert.equal(results.get(question.id), question.correct, `attempt ${seed}, ${question.id}`);
    const [scored] = [...store.of("passed"), ...store.of("failed"), ...store.of("scored")];
    const share = rightOf(answered) / questions.length;
    assert.ok(Math.abs(scored.result.score.scaled - share) < 1e-4, `attempt ${seed}`);
    assert.equal(scored.result.score.raw, rightOf(answered));
    assert.equal(store.of("completed").length, 1);
    assert.equal(store.of("terminated").length >= 1, true);
  }
});

const oneAnswer = { id: "find-1", kind: "find", words: "ureter", response: "ureter", correct: true, seconds: 1 };

/** A page of a system or a store, and what has arrived there. */
function opened(kind) {
  if (kind === "cmi5") {
    const store = new RecordStore();
    const page = new PageWindow({ search: store.launch(), fetch: store.fetch });
    return { system: store, page, arrived: () => store.of("answered").length };
  }
  const system = new ScormSystem(kind);
  const page = new PageWindow({ parent: frameAround(system.frame()) });
  return { system, page, arrived: () => system.interactions.length };
}

test("what could not be told is told as soon as the connection is back", async () => {
  for (const kind of ["scorm12", "scorm2004", "cmi5"])
    for (const again of [
      (page) => page.runTimers(),
      (page) => page.tell("online"),
      (page) => {
        page.document.visibilityState = "hidden";
        page.tell("visibilitychange");
      },
    ]) {
      const { system, page, arrived } = opened(kind);
      const reporter = page.reporter(kind);
      const begun = reporter.begin(2);
      await settled();
      await begun;
      system.connected = false;
      reporter.answer(oneAnswer);
      await settled();
      again(page);
      await settled();
      assert.equal(arrived(), 0);
      system.connected = true;
      again(page);
      await settled();
      assert.equal(arrived(), 1, kind);
      assert.deepEqual(system.faults, []);
    }
});

test("a page that is closed at once has told all", async () => {
  for (const kind of ["scorm12", "scorm2004", "cmi5"]) {
    const { system, page, arrived } = opened(kind);
    const reporter = page.reporter(kind);
    const begun = reporter.begin(2);
    await settled();
    await begun;
    reporter.answer(oneAnswer);
    reporter.suspend();
    page.tell("pagehide");
    system.pageGone = true;
    await settled();
    assert.equal(arrived(), 1, kind);
    if (kind === "cmi5") assert.equal(system.of("terminated").length, 1);
    assert.deepEqual(system.faults, []);
  }
});

test("an attempt that has ended is not ended again", async () => {
  const store = new RecordStore({ masteryScore: 0.5 });
  for (let i = 0; i < 2; ++i) {
    const page = new PageWindow({ search: store.launch(), fetch: store.fetch });
    const reporter = page.reporter("cmi5");
    const begun = reporter.begin(1);
    await settled();
    await begun;
    reporter.answer(oneAnswer);
    reporter.end(1, 1);
    page.tell("pagehide");
    await settled();
  }
  assert.deepEqual(store.faults, []);
  assert.equal(store.of("answered").length, 1);
  assert.equal(store.of("passed").length, 1);
});

test("what is reviewed or browsed is not told", async () => {
  for (const [kind, mode] of [
    ["scorm12", "review"],
    ["scorm12", "browse"],
    ["scorm2004", "review"],
  ]) {
    const system = new ScormSystem(kind, { mode });
    const page = new PageWindow({ parent: frameAround(system.frame()) });
    const reporter = page.reporter(kind);
    await reporter.begin(1);
    reporter.answer({ id: "find-1", kind: "find", words: "", response: "", correct: true, seconds: 1 });
    reporter.end(1, 1);
    page.tell("pagehide");
    assert.equal(system.interactions.length, 0);
    assert.equal(system.share, 0);
    assert.equal(system.state, "closed");
  }
  const store = new RecordStore({ mode: "Review" });
  const page = new PageWindow({ search: store.launch(), fetch: store.fetch });
  const reporter = page.reporter("cmi5");
  await reporter.begin(1);
  reporter.answer({ id: "find-1", kind: "find", words: "", response: "", correct: true, seconds: 1 });
  reporter.end(1, 1);
  page.tell("pagehide");
  await settled();
  assert.deepEqual(store.faults, []);
  assert.equal(store.statements.length, 2);
});

test("without a learning system a page works by itself", async () => {
  const stranger = new Proxy(
    {},
    {
      get() {
        throw new Error("of another origin");
      },
    },
  );
  for (const kind of ["scorm12", "scorm2004", "cmi5", undefined])
    for (const parent of [undefined, stranger]) {
      const page = new PageWindow(parent ? { opener: stranger } : {});
      const reporter = page.reporter(kind);
      assert.deepEqual(JSON.parse(JSON.stringify(await reporter.begin(3))), { answered: {} });
      reporter.answer({ id: "a", kind: "find", words: "", response: "", correct: true, seconds: 1 });
      reporter.end(1, 3);
      reporter.suspend();
      page.tell("pagehide");
    }
});

test("the results stay until the page is left", async () => {
  const system = new ScormSystem("scorm12");
  const page = new PageWindow({ parent: frameAround(system.frame()) });
  const reporter = page.reporter("scorm12");
  await reporter.begin(1);
  reporter.end(1, 1);
  assert.equal(system.value("cmi.core.lesson_status"), "completed");
  assert.ok(!system.calls.includes("Finish"));
  page.tell("pagehide");
  assert.ok(system.calls.includes("Finish"));
  page.tell("pageshow", { persisted: true });
  assert.equal(page.reloads, 1);
});

test("what is suspended is read again, and nothing else", () => {
  const { scripts } = new PageWindow();
  const answered = new Map([
    ["find-1", true],
    ["name+2 %", false],
    ["肝臓", true],
  ]);
  const read = scripts.answeredIn(scripts.suspendedText(answered, 4096));
  assert.equal(JSON.stringify([...read]), JSON.stringify([...answered]));
  assert.equal(
    scripts.suspendedText(
      new Map([
        ["a", true],
        ["b", false],
      ]),
      8,
    ),
    "sline1+a",
  );
  for (const foreign of ["", "sline1+%", "sline2+a", "<img>", "sline1++a"])
    assert.equal(scripts.answeredIn(foreign).size, 0, foreign);
  assert.equal(scripts.clockTime(3723.5), "0001:02:03.50");
  assert.equal(scripts.clockTime(-1), "0000:00:00.00");
  assert.equal(scripts.isoTime(63.456), "PT63.46S");
});
