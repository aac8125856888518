// SPDX-License-Identifier: Apache-2.0
// The tour's texts, links in them and into the page, languages, and texts that would be programs:
// nothing of it is in the picture. What views show: views_test.mjs.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { basename } from "node:path";
import { after, before, test } from "node:test";
import { textTable } from "../../resources/page/texts.js";
import { pageModules } from "./assemble.mjs";
import { Pages, until } from "./browser.mjs";
import { hostile } from "./lesson.mjs";

let pages;
before(async () => (pages = await Pages.open()));
after(() => pages.close());

const title = (page) => page.locator(".view-text h2").innerText();

test("button, contents and keys lead through the views", async () => {
  const page = await pages.show();
  await page.getByRole("button", { name: "Begin the tour" }).click();
  assert.equal(await title(page), "The bladder from in front");
  await page.locator(".steps").getByRole("button", { name: "Next" }).click();
  assert.equal(await title(page), "Where ureter and artery cross");
  assert.equal(
    await page.evaluate(() => document.activeElement.getAttribute("aria-label")),
    "Next",
    "focus stays on the button",
  );
  await page.keyboard.press("ArrowRight");
  assert.equal(await title(page), "Into the true pelvis");
  assert.match(await page.locator("#live").innerText(), /^3 of 3 Into the true pelvis$/);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("PageUp");
  assert.equal(await title(page), "Where ureter and artery cross");
  await page.locator(".contents button").nth(2).click();
  assert.equal(await title(page), "Into the true pelvis");
  assert.match(page.url(), /#view=3$/);
  assert.match(await page.locator("#scene-words").textContent(), /^Into the true pelvis: the bladder/);
  await page.done();
});

test("on the drawing arrows turn, and Page Down goes on", async () => {
  const page = await pages.show();
  // Who listens hears what is seen: it opens with the first view, and once moved it is that no more.
  const heard = () => page.locator("#scene-words").textContent();
  const first = await heard();
  await page.locator("#stage").focus();
  await page.keyboard.press("ArrowRight");
  assert.equal(await page.locator(".view-text").count(), 0);
  assert.equal(await heard(), `Before it was moved: ${first}`);
  await page.keyboard.press("PageDown");
  assert.equal(await title(page), "The bladder from in front");
  assert.equal(await heard(), first);
  await page.done();
});

test("names in texts light structures up, views' names go there", async () => {
  const page = await pages.show({}, { hash: "#view=1" });
  await page.getByRole("link", { name: "urinary bladder" }).click();
  await until(page.selected, [6]);
  assert.match(page.url(), /#view=1&structure=urinary-bladder$/);
  await page.getByRole("link", { name: "view from behind" }).click();
  assert.equal(await title(page), "Where ureter and artery cross");
  assert.equal(await page.locator(".view-text li").count(), 2);
  assert.equal(await page.locator(".view-text li strong").innerText(), "At hysterectomy it is in danger.");
  await page.getByRole("link", { name: "left ureter" }).click();
  await until(page.selected, [7]);
  await page.done();
});

test("deep links", async () => {
  const address = pages.write();
  for (const [hash, view, chosen] of [
    ["#view=3", 3, []],
    ["#structure=left-ureter", 0, [7]],
    ["#structure=Linker%20Harnleiter", 0, [7]],
    ["#structure=7,8", 0, [7, 8]],
    ["#view=1&structure=vesica-urinaria", 1, [6]],
    ["#structure=vessels", 0, [11, 12, 13]],
    ["#view=99&structure=nobody", 0, []],
    ["#view=-1", 0, []],
    ["#%E0%A4%A", 0, []],
    ["#view=1e0", 1, []],
  ]) {
    const page = await pages.visit(address + hash);
    assert.equal(await page.evaluate(() => window.engine.view), view, hash);
    await until(page.selected, chosen, hash);
    await page.done();
  }
  const page = await pages.visit(address);
  await page.evaluate(() => (location.hash = "#view=2&structure=rectum&language=de"));
  await until(page.selected, [15]);
  assert.equal(await title(page), "Kreuzung von Harnleiter und Arterie");
  await page.done();
});

test("languages: names and the page's own texts", async () => {
  const page = await pages.show({}, { hash: "#structure=rectum" });
  for (const [language, structures, rectum] of [
    ["de", "Strukturen", "Mastdarm"],
    ["nl", "Structuren", "Endeldarm"],
    ["nb", "Strukturer", "Endetarm"],
    ["la", "Strukturer", "Rectum"],
    ["en", "Structures", "Rectum"],
  ]) {
    await page.locator(".language").selectOption(language);
    assert.equal(await page.locator(".panel-button span").first().innerText(), structures);
    assert.equal(await page.locator("#card h2").innerText(), rectum);
    assert.equal(await page.locator("#card h2").getAttribute("lang"), language);
  }
  await page.done();
});

test("the teacher's language comes first; the page's own texts are in it or in the browser's", async () => {
  for (const [language, locale, words, name] of [
    ["de", "en", "Strukturen", "Mastdarm"],
    ["nb", "de", "Strukturer", "Endetarm"],
    ["la", "nl", "Structuren", "Rectum"],
    ["la", "nn-NO", "Strukturer", "Rectum"],
    ["la", "fr", "Structures", "Rectum"],
    ["en", "de", "Structures", "Rectum"],
  ]) {
    const page = await pages.visit(
      pages.write({}, (parts) => {
        parts.facts.language = language;
        return parts;
      }),
      { locale },
    );
    assert.equal(await page.locator(".panel-button span").first().innerText(), words, `${language} ${locale}`);
    assert.equal(await page.locator("li[data-id='15'] .row-name").innerText(), name);
    await page.done();
  }
  const page = await pages.show({ languages: ["en"] });
  assert.equal(await page.locator(".language").count(), 0);
  await page.done();
});

test("all texts are in four languages and name the same places", async () => {
  // Reporters say other things.
  const used = pageModules()
    .filter((file) => !basename(file).startsWith("report_"))
    .map((file) => readFileSync(file, "utf8"))
    .join("\n");
  for (const [key, row] of Object.entries(textTable)) {
    assert.equal(row.length, 4, key);
    const marks = (words) => [...words.matchAll(/\{\d\}|\|/g)].map(String).sort().join();
    for (const words of row) {
      assert.ok(words.trim(), key);
      assert.equal(marks(words), marks(row[0]), key);
    }
    assert.ok(used.includes(`"${key.replace(/(stage|label)(\d|Names|Numbers|None)$/, "$1")}"`), `${key} is used`);
  }
  for (const [, key] of used.matchAll(/\bsay\(\s*"(\w+)"[,)]/g)) assert.ok(textTable[key], `${key} is in the table`);
});

test("texts stay text", async () => {
  const address = pages.write({ title: hostile }, (parts) => {
    parts.facts.nodes[1].names = { en: hostile };
    parts.facts.views[0].title = { en: hostile };
    parts.facts.views[0].words = {
      en: [
        [
          { text: hostile, bold: true },
          { text: "javascript:window.hacked=1", view: 2 },
        ],
      ],
    };
    parts.facts.views[0].alt = { en: hostile };
    parts.facts.labels[0].words = { en: [[{ text: hostile }]] };
    parts.facts.credits = [hostile];
    parts.facts.nodes[1].colour = "red; background: url(https://example.org)";
    return parts;
  });
  const page = await pages.visit(`${address}#view=1&structure=2`);
  await page.getByRole("button", { name: "About this page" }).click();
  assert.equal(await page.locator(".about h2").innerText(), hostile);
  assert.equal(await page.locator("#card h2").innerText(), hostile);
  assert.equal(await title(page), hostile);
  await page.locator(".about").getByRole("button", { name: "Close" }).click();
  await page.locator("li[data-id='15'] .row-name").click();
  assert.equal(await page.locator("#card .note").innerText(), hostile);
  assert.equal(await page.evaluate(() => window.hacked), undefined);
  assert.equal(await page.locator("#app img").count(), 0);
  await page.done();
});
