// SPDX-License-Identifier: Apache-2.0
// What a view of the page shows is what the view is: with the real engine, beside the pictures that
// `sline render --view` draws. run.sh names the page and its scene in PAGE_LESSON and PAGE_LESSON_SCENE.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { apart, Browsers, factsOf, labelsOf, pictureAtRest, pictureIn } from "./made.mjs";

const file = process.env.PAGE_LESSON ?? "";
const scene = process.env.PAGE_LESSON_SCENE ?? "";
const sline = join(process.env.PAGE_PROGRAMS ?? "", "sline");
const skip = !file && "no page was made";
let browsers;
let folder = "";
/** The scene's views: their names, and the labels that each lists. @type {{name: string, labels: number[]}[]} */
let views = [];
before(async () => {
  if (skip) return;
  browsers = await Browsers.open("webgl", "canvas");
  folder = mkdtempSync(join(tmpdir(), "sline-views-"));
  views = JSON.parse(String(execFileSync(sline, ["view", scene, "--list", "--json"]))).views;
});
after(async () => {
  await browsers?.close();
  if (folder) rmSync(folder, { recursive: true });
});

/** The view's picture in that size as the program draws it. */
async function rendered(page, view, { width, height }) {
  const target = join(folder, `${view} ${width}.png`);
  execFileSync(sline, ["render", scene, "--view", views[view - 1].name, "--size", `${width}x${height}`, "-o", target]);
  return pictureIn(page, target);
}

/** Goes on to the next view by a key, as the tour does, and waits until it is there. */
async function goOn(page) {
  await page.locator("#stage").focus();
  await page.keyboard.press("PageDown");
  await page.waitForTimeout(1700);
  return pictureAtRest(page);
}

for (const means of ["webgl", "canvas"])
  test(`each view is the picture that the program draws of it, with ${means}`, { skip }, async () => {
    // A picture so wide has room for labels beside what its views show: their cameras are taken as they are.
    const page = await browsers.visit(file, { means, width: 960, height: 520 });
    for (const open of await page.locator(".panel-button[aria-expanded='true']").all()) await open.click();
    const shown = [];
    for (let view = 1; view <= views.length; ++view) shown.push(await goOn(page));
    assert.ok(shown[0].width > 1.85 * shown[0].height, `${shown[0].width} × ${shown[0].height}`);
    const wanted = [];
    for (let view = 1; view <= views.length; ++view) wanted.push(await rendered(page, view, shown[0]));
    const table = shown.map((one) => wanted.map((other) => apart(one, other)));
    console.log(table.map((row) => row.map((value) => value.toFixed(2).padStart(6)).join(" ")).join("\n"));
    // As far as the drawings of two views are apart, so far are their pictures in the page; and one
    // view's are the same.
    for (const [i, row] of table.entries())
      for (const [j, value] of row.entries())
        if (i !== j) {
          const drawn = apart(wanted[i], wanted[j]);
          assert.ok(row[i] < 0.3 * drawn, `view ${i + 1} is ${row[i]} off, view ${j + 1} is ${drawn} away`);
          assert.ok(value > 0.7 * drawn, `view ${i + 1} looks like view ${j + 1}: ${value}, ${drawn}`);
        }
    await page.done();
  });

test("a view is the same wherever one comes from, and whatever was changed by hand before", { skip }, async () => {
  const page = await browsers.visit(file, { reducedMotion: "reduce" });
  const show = async (view) => {
    await page
      .locator(".contents button")
      .nth(view - 1)
      .click();
    return pictureAtRest(page);
  };
  const first = await show(1);
  const last = await show(views.length);
  assert.ok(apart(first, last) > 1);
  assert.ok((await show(1)).data.equals(first.data), "back again");
  await page.locator("li.group > .row .eye").first().click();
  await page.locator("li.structure .gamma").first().fill("5");
  assert.ok(!(await pictureAtRest(page)).data.equals(first.data), "something was changed");
  assert.ok((await show(views.length)).data.equals(last.data));
  assert.ok((await show(1)).data.equals(first.data));
  await page.evaluate((view) => (location.hash = `#view=${view}`), views.length);
  assert.ok((await pictureAtRest(page)).data.equals(last.data), "by its link");
  await page.done();
  const linked = await browsers.visit(file, { hash: `#view=${views.length}` });
  assert.ok((await pictureAtRest(linked)).data.equals(last.data), "by a link to the page");
  await linked.done();
});

test("each view has its labels, in the tree its looks, in the section its cut", { skip }, async () => {
  const facts = factsOf(file);
  const page = await browsers.visit(file, { width: 1440, height: 900 });
  const looks = [];
  for (const [i, { name, labels }] of views.entries()) {
    await goOn(page);
    assert.match(page.url(), new RegExp(`#view=${i + 1}$`));
    assert.deepEqual(
      await labelsOf(page),
      [...labels].sort((a, b) => a - b),
      name,
    );
    for (const id of labels) {
      const words = facts.labels
        .find((label) => label.id === id)
        .words.en[0].map((run) => run.text)
        .join("");
      const shown = await page.locator(`.overlay .label[data-id='${id}'] .label-text`).allTextContents();
      assert.equal(shown.join(" "), words);
    }
    looks.push(await page.locator("li.structure .gamma").evaluateAll((all) => all.map((one) => one.value).join()));
  }
  assert.ok(new Set(looks).size > 1, "the tree says what is shown");
  await page.done();
});

test("a hand on the scene ends the flight, and what the view shows is there", { skip }, async () => {
  const page = await browsers.visit(file, { hash: "#view=1" });
  const before = await page.locator("li.structure .gamma").evaluateAll((all) => all.map((one) => one.value).join());
  const box = await page.locator("#stage").boundingBox();
  await page
    .locator(".contents button")
    .nth(views.length - 1)
    .click();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 20, box.y + box.height / 2, { steps: 3 });
  await page.mouse.up();
  const held = await pictureAtRest(page);
  await page.waitForTimeout(1700);
  assert.ok((await pictureAtRest(page)).data.equals(held.data), "it stays where it was taken hold of");
  assert.notEqual(
    await page.locator("li.structure .gamma").evaluateAll((all) => all.map((one) => one.value).join()),
    before,
  );
  assert.deepEqual(await labelsOf(page), views.at(-1).labels);
  await page.done();
});
