// SPDX-License-Identifier: Apache-2.0
// Opens pages in headless Chromium for the tests, and hears what the browser complains of.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { assembled } from "./assemble.mjs";
import { lesson } from "./lesson.mjs";

export const modules = createRequire(join(process.env.PAGE_MODULES ?? "", "x.js"));
const { chromium } = modules("playwright-core");

/** A browser and a folder of pages, for all tests of a file. */
export class Pages {
  static async open() {
    const pages = new Pages();
    pages.browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: ["--no-sandbox"] });
    pages.folder = mkdtempSync(join(tmpdir(), "sline-page-"));
    pages.count = 0;
    return pages;
  }

  async close() {
    await this.browser.close();
    rmSync(this.folder, { recursive: true });
  }

  /** Writes a page of the options of `lesson`, which may be changed by `change`; returns its address. */
  write(options = {}, change = (parts) => parts) {
    const html = assembled(change(lesson(options)));
    const file = join(this.folder, `${++this.count}.html`);
    writeFileSync(file, html);
    return `file://${file}`;
  }

  /** Opens an address and waits for the whole scene. What the browser complains of fails the test at `page.done`. */
  async visit(address, { width = 1280, height = 800, touch = false, before, whole = true, ...more } = {}) {
    const context = await this.browser.newContext({
      viewport: { width, height },
      hasTouch: touch,
      isMobile: touch,
      locale: "en",
      ...more,
    });
    const page = await context.newPage();
    const complaints = [];
    page.on("console", (message) => {
      if (["error", "warning"].includes(message.type())) complaints.push(message.text());
    });
    page.on("pageerror", (error) => complaints.push(String(error)));
    page.on("request", (request) => {
      if (!/^(data|blob|about):/.test(request.url()) && request.url().split("#")[0] !== address.split("#")[0])
        complaints.push(`loads ${request.url()}`);
    });
    if (before) await page.addInitScript(before);
    await page.goto(address);
    if (whole) await page.waitForSelector("body.complete", { state: "attached" });
    page.done = async () => {
      await context.close();
      assert.deepEqual(complaints, []);
    };
    page.calls = () => page.evaluate(() => window.engineCalls.splice(0));
    page.gamma = (id) => page.evaluate((one) => window.engine.gamma(one), id);
    page.visible = (id) => page.evaluate((one) => window.engine.visible(one), id);
    page.selected = () => page.evaluate(() => [...window.engine.selected]);
    /** Where a structure is seen, in pixels of the window. */
    page.spot = (id) =>
      page.evaluate((one) => {
        const box = document.getElementById("stage").getBoundingClientRect();
        const seen = window.engine.seen(window.engine.ball(one));
        return { x: box.left + seen.x, y: box.top + seen.y };
      }, id);
    page.clickOn = async (id) => {
      const { x, y } = await page.spot(id);
      await page.mouse.click(x, y);
    };
    return page;
  }

  /** Writes a page and opens it. */
  async show(options = {}, how = {}) {
    const { hash = "", query = "", ...rest } = how;
    return this.visit(this.write(options) + query + hash, rest);
  }
}

/** Waits until what `probe` returns in the page is as wanted. */
export async function until(probe, wanted, what = "") {
  let found;
  for (let i = 0; i < 100; ++i) {
    found = await probe();
    if (JSON.stringify(found) === JSON.stringify(wanted)) return;
    await new Promise((passed) => setTimeout(passed, 30));
  }
  assert.deepEqual(found, wanted, what);
}
