// SPDX-License-Identifier: Apache-2.0
// Pages that the program has made, with the real engine: with WebGL by software, and with none. run.sh
// names them in PAGE_MADE, separated by colons.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { modules } from "./browser.mjs";
import { hashed } from "./lesson.mjs";
import { Browsers, drivers, factsOf } from "./made.mjs";

const axe = readFileSync(modules.resolve("axe-core/axe.min.js"), "utf8");
const made = (process.env.PAGE_MADE ?? "").split(":").filter((file) => file);
const skip = made.length === 0 && "no page was made";

let browsers;
before(async () => {
  if (!skip) browsers = await Browsers.open(...Object.keys(drivers));
});
after(() => browsers?.close());
const open = (file, how) => browsers.visit(file, how);

/** A picture as few numbers: how much ink there is in each of 16 × 16 fields. */
const fields = (page) =>
  page.evaluate(async () => {
    // The picture at rest.
    await new Promise((passed) => setTimeout(passed, 1200));
    const canvas = document.querySelector(".stage canvas");
    const small = document.createElement("canvas");
    small.width = small.height = 16;
    const pen = small.getContext("2d");
    pen.imageSmoothingQuality = "high";
    pen.drawImage(canvas, 0, 0, 16, 16);
    return [...pen.getImageData(0, 0, 16, 16).data].filter((_, i) => i % 4 !== 3);
  });

/** The picture at rest, as the bytes of its pixels. */
const pixels = async (page) =>
  Buffer.from(
    await page.evaluate(async () => {
      await new Promise((passed) => setTimeout(passed, 2500));
      const canvas = document.querySelector(".stage canvas");
      const copy = document.createElement("canvas");
      copy.width = canvas.width;
      copy.height = canvas.height;
      const pen = copy.getContext("2d");
      pen.fillStyle = "white";
      pen.fillRect(0, 0, copy.width, copy.height);
      pen.drawImage(canvas, 0, 0);
      return [...pen.getImageData(0, 0, copy.width, copy.height).data];
    }),
  );

const differ = (a, b) => a.filter((value, i) => Math.abs(value - b[i]) > 4).length;

/** Clicks here and there until something is chosen; returns its name. */
async function chosenByClick(page) {
  const box = await page.locator("#stage").boundingBox();
  for (const [x, y] of [
    [0.5, 0.5],
    [0.5, 0.6],
    [0.45, 0.55],
    [0.55, 0.45],
    [0.4, 0.4],
    [0.6, 0.6],
    [0.5, 0.35],
  ]) {
    await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
    if (await page.locator("#card").isVisible()) return page.locator("#card h2").innerText();
    await page.waitForTimeout(400);
  }
  return undefined;
}

for (const means of Object.keys(drivers))
  test(`made pages with ${means}: turned, chosen, dressed, labelled`, { skip }, async () => {
    for (const file of made) {
      const page = await open(file, { means });
      if (page.still) {
        assert.ok((await page.locator("#stills figure img").count()) > 0);
        await page.done();
        continue;
      }
      const first = await fields(page);
      assert.ok(
        differ(
          first,
          first.map(() => first[0]),
        ) > 20,
        "there is a picture",
      );
      const box = await page.locator("#stage").boundingBox();
      await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
      await page.mouse.down();
      await page.mouse.move(box.x + box.width / 2 + 120, box.y + box.height / 2, { steps: 6 });
      await page.mouse.up();
      assert.ok(differ(first, await fields(page)) > 20, "it turns");
      await page.getByRole("button", { name: "Seen from the front" }).click();
      await page.getByRole("button", { name: "Show all" }).click();
      const front = await fields(page);
      const letters = await page
        .locator(".edge-letter")
        .evaluateAll((all) => all.map((one) => [one.textContent, Number(one.getAttribute("x"))]));
      assert.equal(letters.length, 4, "all sides are marked, beside the labels");
      for (const [letter, x] of letters)
        assert.ok(
          letter === "R" ? x < box.width / 3 : letter === "L" ? x > box.width / 1.5 : "SI".includes(letter),
          letter,
        );
      const name = await chosenByClick(page);
      assert.ok(name, "something can be chosen");
      await page.getByRole("button", { name: "Only this" }).click();
      assert.ok(differ(front, await fields(page)) > 10, "one alone");
      await page.locator("#card").getByRole("button", { name: "As at first" }).click();
      await page.locator("#card .gamma").fill("0");
      await page.locator("#card .gamma").fill("5");
      await page.keyboard.press("Escape");
      if (factsOf(file).labels.length) {
        assert.ok((await page.locator(".overlay .label").count()) > 0, "labels stand in the picture");
        await page.locator(".label-select").selectOption("numbers");
        await page.locator(".overlay .badge").first().waitFor({ state: "attached" });
      }
      await page.done();
    }
  });

test("made pages: a driver for a card draws what the engine's own drawing does", { skip }, async () => {
  const found = [];
  for (const card of [false, true]) {
    const page = await open(made[0], { card, hash: "#view=1" });
    assert.equal(await page.evaluate(() => Boolean(window.askedForCard)), card);
    found.push(await pixels(page));
    await page.done();
  }
  const [own, driver] = found;
  assert.equal(own.length, driver.length);
  assert.ok(new Set(own).size > 50, "there is a picture");
  let off = 0;
  for (let i = 0; i < own.length; i += 4)
    off += [0, 1, 2].some((channel) => Math.abs(own[i + channel] - driver[i + channel]) > 8);
  assert.ok(off <= (0.01 * own.length) / 4, `${off} of ${own.length / 4} pixels differ`);
});

test("made pages: search in every language, deep links, tour", { skip }, async () => {
  for (const file of made) {
    const facts = factsOf(file);
    const node = facts.nodes.find((one) => !one.group && one.visible);
    const page = await open(file);
    for (const name of Object.values(node.names)) {
      await page.locator(".filter").fill(name);
      assert.equal(await page.locator(`li[data-id='${node.id}']`).isVisible(), true, name);
    }
    await page.keyboard.press("Escape");
    await page.locator("#stage").focus();
    for (const [i] of facts.views.entries()) {
      await page.keyboard.press("PageDown");
      assert.match(page.url(), new RegExp(`#view=${i + 1}`));
    }
    await page.done();
    const name = (node.names.en ?? Object.values(node.names)[0]).toLowerCase().replace(/[^\p{L}\p{N}]+/gu, "-");
    const linked = await open(file, { hash: `#structure=${encodeURIComponent(name)}` });
    assert.equal(await linked.locator("#card").isVisible(), true, name);
    await linked.done();
  }
});

test("made pages: typed names are known, in every language", { skip }, async () => {
  for (const file of made) {
    const { quiz } = factsOf(file);
    for (const { kind, words, answers } of quiz.questions)
      if (kind === "name")
        for (const name of Object.values(words)) assert.ok(answers.includes(hashed(quiz.salt, name)), name);
    const question = quiz.questions.find(({ kind }) => kind === "name");
    const page = await open(file);
    await page.locator(".panel-nav").getByRole("button", { name: "Quiz" }).click();
    const round = page.locator(".round select");
    if (await round.count()) await round.selectOption({ index: (await round.locator("option").count()) - 1 });
    await page.getByRole("button", { name: "Begin", exact: true }).click();
    while (!(await page.locator(".typed").isVisible())) {
      await page.getByRole("button", { name: "I do not know" }).click();
      await page.locator("#quiz .on").click();
    }
    await page.locator(".typed").fill(Object.values(question.words)[0]);
    await page.keyboard.press("Enter");
    assert.equal(await page.locator(".verdict-word").innerText(), "Right.");
    await page.done();
  }
});

test("made pages: axe-core finds nothing serious, on a desk and on telephones", { skip }, async () => {
  for (const file of made)
    for (const [width, height, touch] of [
      [1440, 900, false],
      [390, 844, true],
      [320, 568, true],
    ]) {
      const page = await open(file, { width, height, touch, hash: "#view=1" });
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => window.axe.run(document));
      assert.deepEqual(
        violations.filter(({ impact }) => ["serious", "critical"].includes(impact)).map(({ id }) => id),
        [],
      );
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth > innerWidth), false);
      await page.done();
    }
});
