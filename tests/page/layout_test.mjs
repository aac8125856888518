// SPDX-License-Identifier: Apache-2.0
// The page on screens of every size, on paper, in the dark, from right to left, and as axe-core sees it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { modules, Pages, until } from "./browser.mjs";

let pages;
before(async () => (pages = await Pages.open()));
after(() => pages.close());

const axe = readFileSync(modules.resolve("axe-core/axe.min.js"), "utf8");

/** What axe-core thinks serious of the page as it is. */
async function serious(page) {
  // A script of the browser's tools is not bound by the page's policy.
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => window.axe.run(document));
  return violations
    .filter(({ impact }) => impact === "serious" || impact === "critical")
    .map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 120)).join("; ")}`);
}

const sizes = [
  [320, 568, true],
  [390, 844, true],
  [568, 320, true],
  [844, 390, true],
  [768, 1024, true],
  [1024, 768, false],
  [1440, 900, false],
  [2560, 1440, false],
];

/** Opens a panel if it is not open. */
async function openPanel(page, name) {
  const button = page.locator(".panel-nav").getByRole("button", { name });
  if ((await button.getAttribute("aria-expanded")) === "false") await button.click();
}

test("the drawing keeps its room, nothing runs out of the window, targets are large enough", async () => {
  const address = pages.write();
  const small = sizes[0];
  const cases = [
    ...sizes.flatMap((size) => [
      [size, "ltr", "en"],
      [size, "rtl", "en"],
    ]),
    ...["de", "nl", "nb"].map((language) => [small, "ltr", language]),
  ];
  for (const [[width, height, touch], direction, language] of cases) {
    const page = await pages.visit(`${address}#structure=left-common-iliac-artery&language=${language}`, {
      width,
      height,
      touch,
    });
    await page.evaluate((dir) => (document.documentElement.dir = dir), direction);
    for (const panel of [0, 1, 2]) {
      const button = page.locator(".panel-button").nth(panel);
      if ((await button.getAttribute("aria-expanded")) === "false") await button.click();
      const what = `${width}×${height} ${direction} ${language} ${panel}`;
      const found = await page.evaluate(() => {
        const stage = document.getElementById("stage").getBoundingClientRect();
        const out = [...document.querySelectorAll("#app *")]
          .filter((one) => {
            const box = one.getBoundingClientRect();
            return (
              box.width > 1 &&
              box.height > 1 &&
              !one.closest(".overlay, .unseen, .skip") &&
              getComputedStyle(one).visibility === "visible" &&
              (box.left < -1 || box.right > innerWidth + 1)
            );
          })
          .map((one) => `${one.className} ${one.textContent.slice(0, 30)}`);
        const small = [...document.querySelectorAll("#app button, #app select, #app input")]
          .filter((one) => {
            const box = one.getBoundingClientRect();
            return box.width > 0 && (box.width < 24 || box.height < 24);
          })
          .map((one) => `${one.className} ${one.getBoundingClientRect().width}×${one.getBoundingClientRect().height}`);
        return {
          scrolls: document.documentElement.scrollWidth > innerWidth,
          out,
          small,
          stage: [stage.width, stage.height],
        };
      });
      assert.deepEqual([found.scrolls, found.out, found.small], [false, [], []], what);
      assert.ok(
        found.stage[0] >= Math.min(300, width * 0.5) && found.stage[1] >= Math.min(180, height * 0.3),
        `${what}: ${found.stage}`,
      );
    }
    await page.done();
  }
});

test("long titles are whole: in lines, in a tooltip, and for who listens", async () => {
  const long =
    "Where the left ureter crosses the common iliac artery, seen obliquely from behind, above and from the left";
  const title = `${long}, with all that lies around it in the female pelvis and is of importance to the surgeon, at length`;
  const address = pages.write({ title }, (made) => {
    made.facts.views[0].title = { en: long };
    made.facts.views[1].title = { en: title + title };
    return made;
  });
  const whole = (element) =>
    element.evaluate((one) => ({
      cut: one.scrollHeight > one.clientHeight || one.scrollWidth > one.clientWidth,
      title: one.title,
    }));
  for (const [width, height] of [
    [1440, 900],
    [1024, 768],
    [700, 900],
    [320, 568],
  ]) {
    const page = await pages.visit(`${address}#view=1`, { width, height });
    const wide = await page.locator(".caption").evaluate((one) => one.clientHeight > 2);
    for (const [view, caption] of [
      [1, long],
      [2, title + title],
    ]) {
      if (view === 2) await page.evaluate(() => (location.hash = "#view=2"));
      await until(() => page.locator(".caption").textContent(), caption);
      const head = page.locator(".head h1");
      for (const element of wide ? [page.locator(".caption"), head] : [head]) {
        await page.mouse.move(1, height - 1);
        await element.hover();
        const { cut, title: shown } = await whole(element);
        assert.equal(shown, cut ? await element.textContent() : "", `${width} ${view}`);
        if (view === 2 && wide && element !== head) assert.ok(cut, "so long a title has no room in two lines");
      }
      // Who listens is told of it, whether it is seen or not.
      assert.equal(await page.getByText(caption, { exact: true }).and(page.locator(".caption *")).count(), 1);
      assert.match(await page.locator(".toolbar").ariaSnapshot(), new RegExp(long), `${width} ${view}`);
    }
    if (width === 1440) {
      await page.evaluate(() => (location.hash = "#view=1"));
      await until(() => page.locator(".caption").textContent(), long);
      assert.deepEqual((await whole(page.locator(".caption"))).cut, false, "two lines hold what one does not");
    }
    await page.done();
  }
});

test("axe-core finds nothing serious", async () => {
  const address = pages.write();
  for (const [width, height, colorScheme] of [
    [1440, 900, "light"],
    [1440, 900, "dark"],
    [390, 844, "light"],
    [320, 568, "dark"],
  ]) {
    const page = await pages.visit(`${address}#view=1&structure=urinary-bladder`, { width, height, colorScheme });
    const found = {};
    for (const panel of ["Structures", "Tour"]) {
      await openPanel(page, panel);
      found[panel] = await serious(page);
    }
    await page.getByRole("button", { name: "About this page" }).click();
    found.about = await serious(page);
    await page.keyboard.press("Escape");
    await openPanel(page, "Quiz");
    await page.getByRole("button", { name: "Begin", exact: true }).click();
    for (let i = 0; i < 6; ++i) {
      found[`question ${i}`] = await serious(page);
      await page.getByRole("button", { name: "I do not know" }).click();
      if (i === 0) found.verdict = await serious(page);
      await page.locator("#quiz .on").click();
    }
    found.score = await serious(page);
    assert.deepEqual(Object.values(found).flat(), [], `${width}×${height} ${colorScheme} ${JSON.stringify(found)}`);
    await page.done();
  }
});

test("without motion a view is there at once", async () => {
  const page = await pages.show({}, { reducedMotion: "reduce" });
  await page.calls();
  await page.getByRole("button", { name: "Begin the tour" }).click();
  assert.deepEqual(await page.calls(), ["view 1 0", "view 1 1"]);
  await page.done();
});

test("a window of another size is filled at once", async () => {
  const page = await pages.show();
  await page.setViewportSize({ width: 600, height: 900 });
  await until(
    () =>
      page.evaluate(() => {
        const canvas = document.querySelector(".stage canvas");
        return [
          canvas.width === Math.round(canvas.clientWidth * devicePixelRatio),
          document.querySelectorAll(".panel:not([hidden])").length,
        ];
      }),
    [true, 1],
    "and the panels that have no room are closed",
  );
  await page.setViewportSize({ width: 1400, height: 900 });
  await page.locator(".panel-nav").getByRole("button", { name: "Structures" }).click();
  assert.equal(await page.locator(".panel:visible").count(), 2);
  await page.done();
});
