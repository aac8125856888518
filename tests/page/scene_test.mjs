// SPDX-License-Identifier: Apache-2.0
// What mouse, fingers and keys ask of the engine, and the tree's own work: an engine that notes what
// is asked of it is enough. What is then seen: student_test.mjs.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Pages, until } from "./browser.mjs";

let pages;
before(async () => (pages = await Pages.open()));
after(() => pages.close());

test("the focus is drawn first, then the context", async () => {
  const page = await pages.show();
  assert.deepEqual(await page.calls(), ["context"]);
  assert.equal(await page.evaluate(() => window.engine.scene.balls.length), 11);
  assert.equal(await page.locator("#stills").isVisible(), false);
  assert.equal(await page.locator(".first-picture").count(), 0);
  assert.ok(
    await page.evaluate(
      () => window.crossOriginIsolated === false && document.getElementById("scene").textContent === "",
    ),
  );
  await page.done();
});

test("the mouse turns, moves and zooms", async () => {
  const page = await pages.show();
  await page.calls();
  await page.mouse.move(640, 400);
  await page.mouse.down();
  await page.mouse.move(700, 420, { steps: 4 });
  await page.mouse.up();
  let calls = await page.calls();
  assert.ok(calls.length >= 3 && calls.every((call) => call === "orbit"), calls.join());
  assert.deepEqual(await page.selected(), [], "a drag chooses nothing");
  await page.keyboard.down("Shift");
  await page.mouse.down();
  await page.mouse.move(600, 380, { steps: 3 });
  await page.mouse.up();
  await page.keyboard.up("Shift");
  calls = await page.calls();
  assert.ok(calls.length >= 2 && calls.every((call) => call === "pan"), calls.join());
  const spot = { x: 600, y: 350 };
  const before = await page.evaluate(() => window.engine.eye.scale);
  await page.mouse.move(spot.x, spot.y);
  await page.mouse.wheel(0, -200);
  await until(() => page.evaluate((old) => window.engine.eye.scale > old, before), true);
  await page.done();
});

test("twice brings into the picture, a resting mouse is told the name", async () => {
  const page = await pages.show();
  const { x, y } = await page.spot(15);
  await page.mouse.move(x, y - 75);
  await page.locator(".hint").waitFor({ state: "visible" });
  assert.equal(await page.locator(".hint").innerText(), "Rectum");
  await page.mouse.dblclick(x, y - 75);
  await until(async () => (await page.calls()).includes("fit 15"), true);
  await page.done();
});

test("what is chosen is in sight in the list", async () => {
  const page = await pages.show({}, { hash: "#structure=rectum", height: 520 });
  await until(
    () =>
      page.evaluate(() => {
        const row = document.querySelector("li[data-id='15'] > .row").getBoundingClientRect();
        const list = document.getElementById("structures").getBoundingClientRect();
        return row.top >= list.top - 1 && row.bottom <= list.bottom + 1;
      }),
    true,
  );
  await page.done();
});

test("the filter finds names of every language", async () => {
  const page = await pages.show();
  const shown = () => page.locator("li.structure:visible .row-name").allInnerTexts();
  for (const [typed, wanted] of [
    ["harnblase", ["Urinary bladder"]],
    ["URETER", ["Left ureter", "Right ureter"]],
    ["hüft", ["Right hip bone", "Left hip bone"]],
    ["huft", ["Right hip bone", "Left hip bone"]],
    ["vasa", ["Abdominal aorta", "Left common iliac artery", "Left external iliac artery"]],
    ["qqq", []],
  ]) {
    await page.locator(".filter").fill(typed);
    assert.deepEqual(await shown(), wanted, typed);
  }
  assert.equal(await page.locator(".none-found").isVisible(), true);
  assert.equal(await page.locator("#live").innerText(), "Nothing of that name");
  await page.locator(".filter").fill("mastdarm");
  await page.keyboard.press("Enter");
  await until(page.selected, [15]);
  await page.done();
});

test("groups fold, by mouse and keys", async () => {
  const page = await pages.show();
  await page.locator("li[data-id='5'] > .row .fold").click();
  assert.equal(await page.locator("li[data-id='6']").isVisible(), false);
  assert.equal(await page.locator("li[data-id='5']").getAttribute("aria-expanded"), "false");
  await page.keyboard.press("ArrowRight");
  assert.equal(await page.locator("li[data-id='6']").isVisible(), true);
  await page.keyboard.press("ArrowLeft");
  assert.equal(await page.locator("li[data-id='6']").isVisible(), false);
  await page.clickOn(6);
  await until(() => page.locator("li[data-id='6']").isVisible(), true, "what is chosen is shown in the tree");
  await page.done();
});

test("by keys alone", async () => {
  const page = await pages.show();
  const focused = () =>
    page.evaluate(() => document.activeElement?.getAttribute("data-id") ?? document.activeElement?.id ?? "");
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  assert.equal(await focused(), "stage", "the first stop leads to the drawing");
  await page.calls();
  for (const key of ["ArrowLeft", "Shift+ArrowUp", "+", "-", ",", "p", "Home"]) await page.keyboard.press(key);
  assert.deepEqual(await page.calls(), ["orbit", "pan", "zoom", "zoom", "roll", "posterior", "fit "]);
  await page.keyboard.press("/");
  await page.keyboard.press("ArrowDown");
  assert.equal(await focused(), "1");
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Enter");
  await until(page.selected, [2]);
  await page.keyboard.press("Space");
  assert.equal(await page.visible(2), false);
  await page.keyboard.press("Space");
  await page.keyboard.press("+");
  assert.equal(await page.gamma(2), 1.25);
  await page.keyboard.type("rec");
  assert.equal(await focused(), "15");
  await page.keyboard.press("Home");
  await page.keyboard.press("ArrowUp");
  assert.equal(await page.evaluate(() => document.activeElement.className), "filter");
  await page.locator("#stage").focus();
  await page.keyboard.press("]");
  assert.equal(await page.gamma(2), 1.5);
  await page.keyboard.press("Escape");
  await until(page.selected, []);
  await page.done();
});

test("every control can be reached by Tab, and says what it is", async () => {
  const page = await pages.show({}, { hash: "#structure=rectum" });
  const stops = new Set();
  for (let i = 0; i < 60; ++i) {
    await page.keyboard.press("Tab");
    stops.add(
      await page.evaluate(() => {
        const at = document.activeElement;
        return at === document.body
          ? ""
          : at.getAttribute("aria-label") || at.innerText || at.getAttribute("aria-labelledby") || `?${at.outerHTML}`;
      }),
    );
  }
  for (const wanted of [
    "Language",
    "About this page",
    "Structures",
    "Tour",
    "Quiz",
    "The female pelvis",
    "Seen from the front",
    "Show all",
    "Nearer",
    "Labels",
    "Find a structure",
    "Rectum",
    "Only this",
    "Detail Γ",
    "Begin the tour",
  ])
    assert.ok(stops.has(wanted), `${wanted} in ${[...stops].join(" | ")}`);
  assert.ok(![...stops].some((stop) => stop.startsWith("?")), [...stops].join());
  await page.done();
});

/** Touches by fingers as the browser gets them from a screen, 40 ms apart however long it takes to answer them. */
async function touches(page, steps) {
  const session = await page.context().newCDPSession(page);
  const start = Date.now() / 1000;
  let before = 0;
  for (const [step, points] of steps.entries()) {
    const type =
      points.length > before ? "touchStart" : points.length === before && before > 0 ? "touchMove" : "touchEnd";
    const touchPoints = points.map(([x, y], id) => ({ x, y, id }));
    await session.send("Input.dispatchTouchEvent", { type, touchPoints, timestamp: start + 0.04 * step });
    before = points.length;
  }
}

test("one finger turns, two zoom and move, a tap chooses", async () => {
  const page = await pages.show({}, { width: 390, height: 844, touch: true });
  await page.calls();
  await touches(page, [[[200, 200]], [[220, 205]], [[250, 210]], []]);
  let calls = await page.calls();
  assert.ok(calls.length > 0 && calls.every((call) => call === "orbit"), calls.join());
  await touches(page, [
    [[150, 200]],
    [
      [150, 200],
      [250, 200],
    ],
    [
      [120, 200],
      [280, 200],
    ],
    [
      [100, 200],
      [300, 200],
    ],
    [],
  ]);
  calls = await page.calls();
  assert.ok(calls.includes("zoom") && calls.includes("pan") && !calls.includes("orbit"), calls.join());
  assert.ok(await page.evaluate(() => window.engine.eye.scale > 1.5));
  await page.getByRole("button", { name: "Show all" }).tap();
  await page.locator(".side-select").selectOption("anterior");
  const spot = await page.spot(6);
  await page.touchscreen.tap(spot.x, spot.y);
  await until(page.selected, [6]);
  await page.waitForTimeout(400);
  await page.locator("#card").getByRole("button", { name: "Close" }).tap();
  await until(() => page.spot(6), spot, "the picture has its room again");
  await page.calls();
  await touches(page, [[[spot.x, spot.y]], [], [[spot.x, spot.y]], []]);
  await until(async () => (await page.calls()).at(-1), "fit 6", "the card's room does not change what is meant");
  assert.equal(await page.evaluate(() => window.scrollY), 0);
  await page.done();
});
