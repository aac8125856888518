// SPDX-License-Identifier: Apache-2.0
// What a student does and sees on a page that the program has made, with the real engine: chooses,
// dresses, reads, answers. run.sh names the page in PAGE_LESSON.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { until } from "./browser.mjs";
import { hashed } from "./lesson.mjs";
import { apart, Browsers, factsOf, labelsOf, outlined, pictureAtRest, spotsOf } from "./made.mjs";

const file = process.env.PAGE_LESSON ?? "";
const skip = !file && "no page was made";
let browsers;
let facts;
before(async () => {
  if (skip) return;
  browsers = await Browsers.open("webgl");
  facts = factsOf(file);
});
after(() => browsers?.close());

const nodeNamed = (name) => facts.nodes.find((node) => node.names.en === name);
const labelOf = (id) => facts.labels.find((label) => label.structures.includes(id));
const verdict = (page) => page.locator(".verdict-word").innerText();

/** The place of a structure that has a label in the picture. */
const spotOf = async (page, name) => (await spotsOf(page))[labelOf(nodeNamed(name).id).id];

test("a click chooses, outlines and tells; the card's controls change what is seen", { skip }, async () => {
  const page = await browsers.visit(file, { hash: "#view=1" });
  const bare = await pictureAtRest(page);
  assert.equal(outlined(bare), 0);
  const spot = await spotOf(page, "sacrum");
  await page.mouse.click(spot.x, spot.y);
  await page.locator("#card h2").waitFor();
  assert.equal(await page.locator("#card h2").innerText(), "sacrum");
  assert.equal(await page.locator("#card .latin").innerText(), "os sacrum");
  assert.match(page.url(), /structure=sacrum$/);
  assert.equal(await page.locator(`li[data-id='${nodeNamed("sacrum").id}']`).getAttribute("aria-selected"), "true");
  const chosen = await pictureAtRest(page);
  assert.ok(outlined(chosen) > 100, "what is chosen is outlined");
  await page.locator("#card .gamma").fill("5");
  const shaded = await pictureAtRest(page);
  assert.ok(apart(chosen, shaded) > 0.3, `Γ is seen: ${apart(chosen, shaded)}`);
  await page.getByRole("button", { name: "Only this" }).click();
  const alone = await pictureAtRest(page);
  assert.ok(apart(shaded, alone) > 1, "the others are gone");
  assert.deepEqual(await labelsOf(page), [labelOf(nodeNamed("sacrum").id).id], "and their labels with them");
  await page.locator("#card").getByRole("button", { name: "As at first" }).click();
  await page.keyboard.press("Escape");
  const again = await pictureAtRest(page);
  assert.ok(again.data.equals(bare.data), "as at first");
  await page.locator(`li[data-id='${nodeNamed("sacrum").id}'] > .row .eye`).click();
  await pictureAtRest(page);
  assert.ok(!(await labelsOf(page)).includes(labelOf(nodeNamed("sacrum").id).id), "what is hidden has no label");
  await page.mouse.click(spot.x, spot.y);
  await page.waitForTimeout(400);
  assert.ok(
    !(await page.locator("#card").isVisible()) || (await page.locator("#card h2").innerText()) !== "sacrum",
    "nor can it be chosen",
  );
  await page.done();
});

test("groups are dressed together; sides are looked at from", { skip }, async () => {
  const page = await browsers.visit(file, { hash: "#view=1" });
  const group = facts.nodes.find(
    (node) => node.group && facts.nodes.filter((one) => one.parent === node.id && !one.group).length > 2,
  );
  const [one, other] = facts.nodes.filter((node) => node.parent === group.id && !node.group);
  const row = (id) => page.locator(`li[data-id='${id}'] > .row`);
  const bare = await pictureAtRest(page);
  await row(one.id).locator(".eye").click();
  assert.equal(await row(group.id).locator(".eye").getAttribute("aria-pressed"), "mixed");
  await row(group.id).locator(".eye").click();
  const without = await pictureAtRest(page);
  assert.ok(apart(bare, without) > 0.2, "a group is hidden");
  await row(group.id).locator(".eye").click();
  assert.ok((await pictureAtRest(page)).data.equals(bare.data), "and shown");
  await row(group.id).locator(".gamma").fill("5");
  assert.deepEqual(
    [await row(one.id).locator(".gamma").inputValue(), await row(other.id).locator(".gamma").inputValue()],
    ["5", "5"],
  );
  assert.ok(apart(bare, await pictureAtRest(page)) > 0.2, "and shaded");
  for (const [side, letter] of [
    ["left", "L"],
    ["behind", "P"],
    ["front", "A"],
  ]) {
    await page.getByRole("button", { name: side === "behind" ? "Seen from behind" : `Seen from the ${side}` }).click();
    await until(() => page.locator(".from[aria-pressed='true']").allInnerTexts(), [letter]);
  }
  const letters = await page
    .locator(".edge-letter")
    .evaluateAll((all) => all.map((one) => [one.textContent, Number(one.getAttribute("x"))]));
  assert.deepEqual(letters.map(([letter]) => letter).sort(), ["I", "L", "R", "S"]);
  const middle = (await page.locator("#stage").boundingBox()).width / 2;
  for (const [letter, x] of letters)
    assert.ok(letter === "R" ? x < middle : letter === "L" ? x > middle : true, letter);
  await page.done();
});

test("names in texts light structures up; languages and numbers are in the picture", { skip }, async () => {
  const page = await browsers.visit(file, { hash: "#view=4" });
  await pictureAtRest(page);
  await page.locator(".view-text").getByRole("link", { name: "urinary bladder" }).click();
  assert.ok(outlined(await pictureAtRest(page)) > 50);
  assert.match(page.url(), /#view=4&structure=urinary-bladder$/);
  const id = labelOf(nodeNamed("urinary bladder").id).id;
  const shown = () => page.locator(`.overlay .label[data-id='${id}'] .label-text`).allTextContents();
  for (const [language, words] of [
    ["de", "Harnblase"],
    ["la", "vesica urinaria"],
    ["en", "urinary bladder"],
  ]) {
    await page.locator(".language").selectOption(language);
    await until(async () => (await shown()).join(" "), words);
    assert.equal(await page.locator("#card h2").innerText(), words);
  }
  await page.locator(".label-select").selectOption("numbers");
  await until(() => page.locator(".overlay .badge").count(), (await labelsOf(page)).length);
  await page.locator(".label-select").selectOption("none");
  await until(() => labelsOf(page), []);
  await page.done();
});

/** Opens the quiz with all of its questions. */
async function begun(page) {
  await page.locator(".panel-nav").getByRole("button", { name: "Quiz" }).click();
  const round = page.locator(".round select");
  if (await round.count()) await round.selectOption({ index: (await round.locator("option").count()) - 1 });
  await page.getByRole("button", { name: "Begin", exact: true }).click();
}

/** Where the labels of a question point, told by the numbers for who cannot point. */
async function placesOf(page, question) {
  await page.getByRole("button", { name: "Answer by number" }).click();
  await page.locator(".number").first().waitFor();
  const spots = await spotsOf(page);
  await page.getByRole("button", { name: "Answer by number" }).click();
  await until(() => labelsOf(page), []);
  const places = question.labels.map((label) => spots[label]);
  assert.ok(
    places.every((place) => place),
    `${question.id}: what is asked for is in the picture`,
  );
  return places;
}

const answers = {
  async find(page, question) {
    const [place] = await placesOf(page, question);
    await page.mouse.click(place.x, place.y);
  },
  async name(page, question) {
    const name = question.words.la ?? question.words.en;
    await page.locator(".typed").fill(name.replace(/^arteria/i, "A.").replace(/^nervus/i, "N."));
    await page.keyboard.press("Enter");
  },
  async choose(page, question) {
    await page.locator(".choice").nth(question.right).click();
  },
  async drag(page, question) {
    const places = await placesOf(page, question);
    for (const [i, { x, y }] of places.entries()) {
      const chip = page.locator(".chip", { hasText: new RegExp(`^${question.choices[i].en}$`) });
      if ((await chip.getAttribute("aria-pressed")) === "false") await chip.click();
      await page.mouse.click(x, y);
      await until(() => page.locator(".chip.put").count(), i + 1, question.choices[i].en);
    }
    await page.getByRole("button", { name: "Answer", exact: true }).click();
  },
};

test("each question can be answered by what its view shows", { skip }, async () => {
  const { questions } = facts.quiz;
  assert.ok(questions.length >= 8 && questions.every((question) => question.view >= 1), "each belongs to a view");
  assert.ok(["find", "name", "choose", "drag"].every((kind) => questions.some((question) => question.kind === kind)));
  const page = await browsers.visit(file);
  await begun(page);
  for (const question of questions) {
    await until(() => labelsOf(page), [], "no label names anything");
    const marked = outlined(await pictureAtRest(page));
    const marks = question.kind === "name" || question.kind === "choose";
    assert.ok(marks ? marked > 20 : marked === 0, `${question.id}: ${marked} pixels are marked`);
    await answers[question.kind](page, question);
    assert.equal(await verdict(page), "Right.", `${question.id} ${JSON.stringify(question.words)}`);
    await until(
      () => labelsOf(page),
      [...question.labels].sort((a, b) => a - b),
      `${question.id} is named then`,
    );
    await page.locator("#quiz .on").click();
  }
  assert.equal(await page.locator(".score").innerText(), `${questions.length} of ${questions.length} right`);
  await page.done();
});

test("a wrong place is told by its name, and the right one is marked", { skip }, async () => {
  const page = await browsers.visit(file);
  await begun(page);
  const { questions } = facts.quiz;
  const at = questions.findIndex((question) => question.kind === "find");
  for (let i = 0; i < at; ++i) {
    await page.getByRole("button", { name: "I do not know" }).click();
    await page.locator("#quiz .on").click();
  }
  const question = questions[at];
  const other = questions.find((one) => one.kind === "find" && one.view === question.view && one.id !== question.id);
  const [place] = await placesOf(page, other);
  await page.mouse.click(place.x, place.y);
  assert.match(
    await page.locator(".verdict").innerText(),
    new RegExp(`Not right\\.[^]*That was: ${other.words.en}[^]*marked now`),
  );
  assert.ok(outlined(await pictureAtRest(page)) > 20);
  await until(() => labelsOf(page), question.labels);
  await page.done();
});

test(
  "typed names are those of the packages, and abbreviations among them",
  { skip: skip || (!process.env.PAGE_MOODLE && "no quiz was made") },
  async () => {
    const { readFileSync } = await import("node:fs");
    const xml = readFileSync(process.env.PAGE_MOODLE ?? "", "utf8");
    const text = (words) =>
      words
        .replace(/&quot;/g, '"')
        .replace(/&lt;/g, "<")
        .replace(/&gt;/g, ">")
        .replace(/&amp;/g, "&")
        .replace(/\\\*/g, "*");
    const asked = [...xml.matchAll(/<question type="shortanswer">([^]*?)<\/question>/g)].map(([, question]) =>
      [...question.matchAll(/<answer fraction="100"[^>]*>\s*<text>([^<]*)<\/text>/g)].map(([, answer]) => text(answer)),
    );
    const { quiz } = facts;
    const typed = quiz.questions.filter((question) => question.kind === "name");
    assert.ok(asked.length >= typed.length && typed.length > 3);
    for (const question of typed) {
      const own = asked.find(([first]) => hashed(quiz.salt, first) === hashed(quiz.salt, question.words.en));
      assert.ok(own, question.words.en);
      assert.deepEqual(
        [...new Set(own.map((name) => hashed(quiz.salt, name)))]
          .filter((hash) => question.answers.includes(hash))
          .sort(),
        [...question.answers].sort(),
        `${question.words.en}: Moodle takes what the page takes`,
      );
    }
    const artery = typed.find((question) => /artery/.test(question.words.en));
    for (const name of ["A. iliaca externa sinistra", "left external iliac a."])
      assert.ok(artery.answers.includes(hashed(quiz.salt, name)), name);
    assert.ok(!artery.answers.includes(hashed(quiz.salt, "A. iliaca externa")), "a side is never left out");
  },
);

test("what is printed is what is seen", { skip }, async () => {
  const page = await browsers.visit(file, { hash: "#view=3" });
  const seen = await pictureAtRest(page);
  await page.emulateMedia({ media: "print" });
  await page.evaluate(() => window.dispatchEvent(new Event("beforeprint")));
  const printed = await page.evaluate(() => {
    const canvas = document.querySelector("#printed canvas");
    const small = document.createElement("canvas");
    small.width = small.height = 8;
    const pen = small.getContext("2d");
    pen.drawImage(canvas, 0, 0, 8, 8);
    const [first, ...rest] = pen.getImageData(0, 0, 8, 8).data;
    return { width: canvas.width, differs: rest.some((value, i) => (i + 1) % 4 !== 3 && Math.abs(value - first) > 20) };
  });
  assert.ok(printed.differs, "there is a picture");
  assert.ok(printed.width > 1.5 * seen.width, "finer than on the screen");
  const words = await page.locator("#printed").innerText();
  for (const label of (await labelsOf(page)).map((id) => facts.labels.find((one) => one.id === id)))
    assert.ok(words.includes(label.words.en[0][0].text) || (await page.locator("#printed .label-text").count()) > 0);
  await page.evaluate(() => window.dispatchEvent(new Event("afterprint")));
  await page.done();
});
