// SPDX-License-Identifier: Apache-2.0
// What a learning system is told of the quiz, its three modes and its rules: an engine that draws balls
// is enough. Whether questions can be answered by what is seen: student_test.mjs.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Pages, until } from "./browser.mjs";
import { hashed } from "./lesson.mjs";

let pages;
before(async () => (pages = await Pages.open()));
after(() => pages.close());

const told = (page) => page.evaluate(() => window.reported);
const verdict = (page) => page.locator(".verdict-word").innerText();
const next = (page) => page.locator("#quiz .on").click();
const giveUp = (page) => page.getByRole("button", { name: "I do not know" }).click();

/** Opens the quiz and begins; gives up as many questions as are to be passed over. */
async function begun(page, passed = 0) {
  if (await page.locator("#quiz").isHidden())
    await page.locator(".panel-nav").getByRole("button", { name: "Quiz" }).click();
  await page.getByRole("button", { name: "Begin", exact: true }).click();
  for (let i = 0; i < passed; ++i) {
    await giveUp(page);
    await next(page);
  }
}

/** Drags a name onto a structure. */
async function drag(page, name, id) {
  const chip = await page.locator(".chip", { hasText: name }).boundingBox();
  const { x, y } = await page.spot(id);
  await page.mouse.move(chip.x + 10, chip.y + 10);
  await page.mouse.down();
  await page.mouse.move(x - 20, y - 10, { steps: 3 });
  await page.mouse.move(x, y);
  await page.mouse.up();
  await until(() => page.locator(".chip.put", { hasText: name }).count(), 1, name);
}

test("all kinds of questions answered right", async () => {
  const page = await pages.show({ report: "scorm12" });
  await begun(page);
  assert.equal(await page.locator("#structures").isVisible(), false, "names are out of sight");
  assert.equal(await page.locator(".overlay .label").count(), 0);
  assert.equal(await page.locator(".subject").innerText(), "Urinary bladder");
  await page.clickOn(6);
  assert.equal(await verdict(page), "Right.");
  assert.match(await page.locator("#live").innerText(), /^Right\./);
  await next(page);

  assert.deepEqual(await page.selected(), [7], "what is asked for is marked");
  assert.doesNotMatch(await page.locator("#app").innerText(), /ureter/i);
  await page.keyboard.type("left urether");
  await page.keyboard.press("Enter");
  assert.match(await page.locator(".verdict").innerText(), /Right\.[\s\S]*spelling[\s\S]*Left ureter/);
  await page.keyboard.press("Enter");
  await page.keyboard.type("Harnröhre");
  await page.keyboard.press("Enter");
  assert.equal(await verdict(page), "Right.");
  await next(page);

  assert.equal(await page.locator(".choice").count(), 4);
  await page.getByRole("button", { name: "Left common iliac artery" }).click();
  assert.equal(await verdict(page), "Right.");
  await next(page);

  for (const name of ["Left external iliac artery", "Abdominal aorta", "Left common iliac artery"])
    await page.locator(".chip", { hasText: name }).click();
  await page.locator("#quiz").getByRole("button", { name: "Later: Left external iliac artery" }).click();
  await page.keyboard.press("Enter");
  await page.getByRole("button", { name: "Answer", exact: true }).click();
  assert.equal(await verdict(page), "Right.");
  await next(page);

  await drag(page, "Left ureter", 7);
  await drag(page, "Urinary bladder", 6);
  await until(() => page.locator(".overlay .label[data-id='1']").textContent(), "Urinary bladder");
  await page.locator(".chip", { hasText: "Rectum" }).click();
  await page.mouse.click(
    ...Object.values(
      await page.evaluate(() => {
        const seen = window.engine.seen(window.engine.ball(15));
        const box = document.getElementById("stage").getBoundingClientRect();
        return { x: box.left + seen.x, y: box.top + seen.y - seen.ry * 0.8 };
      }),
    ),
  );
  await page.getByRole("button", { name: "Answer", exact: true }).click();
  assert.equal(await verdict(page), "Right.");
  await page.getByRole("button", { name: "Finish" }).click();
  assert.equal(await page.locator(".score").innerText(), "6 of 6 right");
  assert.equal(await page.getByRole("button", { name: "Once more" }).count(), 0, "the first answers count");

  const [begin, ...rest] = await told(page);
  assert.deepEqual(begin, { begin: 6, kind: "scorm12" });
  assert.deepEqual(rest.pop(), { end: { right: 6, total: 6 } });
  assert.deepEqual(
    rest.map(({ answer }) => [answer.id, answer.kind, answer.correct]),
    [
      ["find-1", "find", true],
      ["name-1", "name", true],
      ["name-2", "name", true],
      ["choose-3", "choose", true],
      ["order-4", "order", true],
      ["drag-5", "drag", true],
    ],
  );
  assert.deepEqual(
    rest.slice(0, 3).map(({ answer }) => answer.response),
    ["Urinary bladder", "left urether", "Harnröhre"],
  );
  assert.ok(rest.every(({ answer }) => answer.seconds > 0 && answer.seconds < 60));
  await page.done();
});

test("wrong answers are told, once", async () => {
  const page = await pages.show({ report: "cmi5" });
  await begun(page);
  await page.clickOn(3);
  assert.match(
    await page.locator(".verdict").innerText(),
    /Not right\.[\s\S]*That was: Left hip bone[\s\S]*marked now/,
  );
  await until(page.selected, [6], "the right one is shown");
  await page.clickOn(6);
  assert.equal(await verdict(page), "Not right.");
  await next(page);
  await page.locator(".typed").fill("left urethra");
  await page.keyboard.press("Enter");
  assert.match(await page.locator(".verdict").innerText(), /Not right\.[\s\S]*It is: Left ureter/);
  await next(page);
  await giveUp(page);
  await next(page);
  await page.getByRole("button", { name: "Right ureter" }).click();
  await next(page);
  for (const name of ["Left external iliac artery", "Abdominal aorta", "Left common iliac artery"])
    await page.locator(".chip", { hasText: name }).click();
  await page.getByRole("button", { name: "Answer", exact: true }).click();
  assert.match(
    await page.locator(".verdict").innerText(),
    /It is: Abdominal aorta, Left common iliac artery, Left external/,
  );
  await next(page);
  await drag(page, "Left ureter", 6);
  await drag(page, "Urinary bladder", 7);
  await drag(page, "Rectum", 6);
  await page.getByRole("button", { name: "Answer", exact: true }).click();
  assert.match(await page.locator(".verdict").innerText(), /0 of 3 right/);
  await page.getByRole("button", { name: "Finish" }).click();
  const answers = (await told(page)).filter((one) => one.answer);
  assert.equal(answers.length, 6);
  assert.ok(answers.every(({ answer }) => !answer.correct));
  assert.equal(await page.locator(".results .wrong").count(), 6);
  await page.done();
});

test("without pointing: numbers of labels", async () => {
  const page = await pages.show();
  await begun(page);
  await page.getByRole("button", { name: "Answer by number" }).focus();
  await page.keyboard.press("Enter");
  assert.equal(await page.locator(".number").count(), 9);
  assert.equal(await page.locator(".overlay").textContent(), "135792468", "numbers, no names");
  await page.getByRole("button", { name: "Number 1", exact: true }).focus();
  await page.keyboard.press("Enter");
  assert.equal(await verdict(page), "Right.");
  for (let i = 0; i < 5; ++i) {
    await next(page);
    if (i < 4) await giveUp(page);
  }
  await page.getByRole("button", { name: "Answer by number" }).click();
  await page.getByRole("button", { name: "Number 3" }).waitFor();
  for (const [name, number] of [
    ["Urinary bladder", 1],
    ["Rectum", 3],
    ["Left ureter", 2],
  ]) {
    await page.locator(".chip", { hasText: name }).focus();
    if ((await page.locator(".chip", { hasText: name }).getAttribute("aria-pressed")) === "false")
      await page.keyboard.press("Enter");
    await page.getByRole("button", { name: `Number ${number}`, exact: true }).click();
  }
  await page.getByRole("button", { name: "Answer", exact: true }).click();
  assert.equal(await verdict(page), "Right.");
  await page.done();
});

test("camera and look are held, and free again", async () => {
  const page = await pages.show({ lock: true });
  await begun(page);
  await page.calls();
  const drags = async () => {
    const box = await page.locator("#stage").boundingBox();
    await page.mouse.move(box.x + 60, box.y + 60);
    await page.mouse.down();
    await page.mouse.move(box.x + 90, box.y + 90, { steps: 3 });
    await page.mouse.up();
    return (await page.calls()).length;
  };
  assert.equal(await drags(), 0);
  assert.equal(await page.locator(".surroundings").count(), 0);
  assert.equal(await page.getByRole("button", { name: "Nearer" }).isDisabled(), true);
  await page.locator(".panel-nav").getByRole("button", { name: "Structures" }).click();
  assert.ok((await drags()) > 0, "who leaves the quiz may turn");
  await page.locator(".panel-nav").getByRole("button", { name: "Quiz" }).click();
  await page.calls();
  assert.equal(await drags(), 0);
  assert.equal(await page.locator("#quiz .count").innerText(), "Question 1 of 6");
  await page.done();

  const free = await pages.show();
  await begun(free, 1);
  await free.locator(".surroundings .gamma").fill("0");
  assert.deepEqual([await free.gamma(6), await free.gamma(7)], [0, 4.4]);
  await free.done();
});

test("an attempt that was suspended goes on", async () => {
  const page = await pages.show(
    { report: "scorm2004" },
    { before: () => (window.answeredBefore = { "find-1": true, "name-1": false }) },
  );
  await page.locator(".panel-nav").getByRole("button", { name: "Quiz" }).click();
  assert.match(await page.locator("#quiz").innerText(), /2 of them are answered already/);
  await begun(page);
  assert.equal(await page.locator("#quiz .count").innerText(), "Question 3 of 6");
  for (let i = 0; i < 4; ++i) {
    await giveUp(page);
    await next(page);
  }
  assert.equal(await page.locator(".score").innerText(), "1 of 6 right");
  assert.deepEqual((await told(page)).pop(), { end: { right: 1, total: 6 } });
  await page.done();

  const left = await pages.show({ report: "scorm2004" });
  await begun(left);
  await left.evaluate(() => window.dispatchEvent(new Event("pagehide")));
  assert.equal((await told(left)).pop(), "suspend");
  await left.done();
});

test("practice may be repeated and is told to nobody", async () => {
  const page = await pages.show({ counts: false, report: "scorm12" });
  await begun(page, 6);
  assert.equal((await told(page))[0].kind, undefined);
  await page.getByRole("button", { name: "Once more" }).click();
  assert.equal(await page.locator("#quiz .count").innerText(), "Question 1 of 6");
  await page.done();
});

test("of many questions who practises takes some", async () => {
  const many = (options) =>
    pages.write(options, (parts) => {
      const [one] = parts.facts.quiz.questions;
      parts.facts.quiz.questions = Array.from({ length: 25 }, (_, i) => ({ ...one, id: `find-${i}` }));
      return parts;
    });
  const page = await pages.visit(many({ counts: false }));
  await page.locator(".panel-nav").getByRole("button", { name: "Quiz" }).click();
  assert.deepEqual(await page.locator(".round option").allInnerTexts(), ["10", "20", "all 25"]);
  await begun(page, 10);
  assert.equal(await page.locator(".score").innerText(), "0 of 10 right");
  await page.getByRole("button", { name: "Once more" }).click();
  await page.locator(".round select").selectOption("20");
  await begun(page);
  assert.equal(await page.locator("#quiz .count").innerText(), "Question 1 of 20");
  await page.done();
  const counted = await pages.visit(many({ report: "scorm12" }));
  await counted.locator(".panel-nav").getByRole("button", { name: "Quiz" }).click();
  assert.equal(await counted.locator(".round").count(), 0);
  await counted.done();
});

test("quiz only: no name in file or page, and typed names are known all the same", async () => {
  const address = pages.write({ mode: "only", report: "scorm12" });
  const { readFileSync } = await import("node:fs");
  const html = readFileSync(new URL(address), "utf8");
  const names =
    /bladder|ureter\b.*sinister|left ureter|harnleiter|harnblase|urethra"|rectum|sacrum|iliac artery|hip bone/i;
  const data = html
    .slice(html.indexOf("<main"), html.indexOf("<script>"))
    .replace(/<script type="text\/plain"[^]*?<\/script>/g, "");
  assert.doesNotMatch(data, names);
  const page = await pages.visit(address);
  assert.equal(await page.locator("#structures").count(), 0);
  assert.equal(await page.locator("#tour").count(), 0);
  const { x, y } = await page.spot(6);
  await page.mouse.move(x, y);
  await page.waitForTimeout(300);
  assert.equal(await page.locator(".hint").isVisible(), false);
  await page.clickOn(6);
  assert.deepEqual(await page.selected(), []);
  assert.equal(await page.locator(".overlay .label").count(), 0);
  await begun(page);
  assert.equal(await page.locator("#quiz .count").innerText(), "Question 1 of 2");
  await page.locator(".typed").fill("Linker Harnleiter");
  await page.keyboard.press("Enter");
  assert.equal(await verdict(page), "Right.");
  await next(page);
  await page.locator(".typed").fill("urethar");
  await page.keyboard.press("Enter");
  assert.equal(await verdict(page), "Right.");
  const seen = await page.evaluate(() => document.getElementById("app").outerHTML + document.title);
  assert.doesNotMatch(seen, /bladder|left ureter|rectum|sacrum|harn|hip bone/i);
  await page.getByRole("button", { name: "Finish" }).click();
  assert.equal(await page.locator(".score").innerText(), "2 of 2 right");
  assert.equal((await told(page)).filter((one) => one.answer)[1].answer.words, "What is the marked structure called?");
  assert.doesNotMatch(page.url(), /structure/, "the address tells no name");
  await page.done();
});

test("quiz only: an order is pointed at, what cannot be asked is left out", async () => {
  const address = pages.write({ mode: "only" }, (parts) => {
    const blank = { labels: [], answers: [] };
    parts.facts.quiz.questions = [
      { id: "o", kind: "order", structures: [11, 12, 6], ...blank },
      { id: "f", kind: "find", structures: [6], ...blank },
      { id: "c", kind: "choose", structures: [6], ...blank },
      { id: "d", kind: "drag", structures: [6], ...blank },
      { id: "n", kind: "name", structures: [15], labels: [], answers: [hashed("b3", "Mastdarm")] },
    ];
    return parts;
  });
  const page = await pages.visit(address);
  await begun(page);
  assert.equal(await page.locator("#quiz .count").innerText(), "Question 1 of 2");
  for (const id of [11, 12, 6]) await page.clickOn(id);
  await page.getByRole("button", { name: "Answer", exact: true }).click();
  assert.equal(await verdict(page), "Right.");
  await page.done();
});

test("no quiz", async () => {
  const page = await pages.show({ mode: "off" });
  assert.equal(await page.locator("#quiz").count(), 0);
  assert.deepEqual(await page.locator(".panel-button").allInnerTexts(), ["Structures", "Tour"]);
  await page.done();
});
