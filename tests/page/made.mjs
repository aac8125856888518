// SPDX-License-Identifier: Apache-2.0
// Opens pages that the program has made, in a browser that draws with WebGL by software or with none,
// and looks at their pictures.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { here } from "./assemble.mjs";
import { modules } from "./browser.mjs";

const { chromium } = modules("playwright-core");
/** Whether the engine draws without WebGL, too; else still pictures have to do. */
const drawsAnywhere = /means = .*"canvas"/.test(
  readFileSync(join(here, "..", "..", "render", "web", "engine.js"), "utf8"),
);
export const drivers = {
  webgl: ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"],
  canvas: ["--disable-3d-apis"],
};

export const factsOf = (file) => JSON.parse(/id="facts">([^]*?)<\/script>/.exec(readFileSync(file, "utf8"))[1]);

/** The browsers of a file of tests: those that it names, as `drivers` has them. */
export class Browsers {
  static async open(...means) {
    const browsers = new Browsers();
    browsers.all = {};
    for (const each of means)
      browsers.all[each] = await chromium.launch({
        executablePath: "/usr/bin/chromium",
        args: ["--no-sandbox", ...drivers[each]],
      });
    return browsers;
  }

  close() {
    return Promise.all(Object.values(this.all).map((browser) => browser.close()));
  }

  /**
   * Opens a page and waits for the whole scene; errors fail the test at `page.done`. With a `card` the engine is told of
   * a graphics card, and has the driver draw what its own drawing would where the driver is software.
   */
  async visit(
    file,
    { means = "webgl", hash = "", width = 1280, height = 800, touch = false, card = false, ...more } = {},
  ) {
    const context = await this.all[means].newContext({
      viewport: { width, height },
      hasTouch: touch,
      isMobile: touch,
      locale: "en",
      ...more,
    });
    const page = await context.newPage();
    if (card)
      await page.addInitScript(() => {
        const { getParameter } = WebGL2RenderingContext.prototype;
        WebGL2RenderingContext.prototype.getParameter = function (name) {
          window.askedForCard ||= name === 0x9246;
          return name === 0x9246 ? "A card" : getParameter.call(this, name);
        };
      });
    const complaints = [];
    page.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
    page.on("pageerror", (error) => complaints.push(String(error)));
    await page.goto(`file://${file}${hash}`);
    await page.waitForFunction(
      () => document.body.classList.contains("complete") || !document.getElementById("stills").hidden,
      undefined,
      { timeout: 60000 },
    );
    page.still = means === "canvas" && !drawsAnywhere;
    assert.equal(
      await page.locator("#stills .notice[role=alert]").count(),
      page.still ? 1 : 0,
      `${file} with ${means}`,
    );
    page.done = async () => {
      await context.close();
      assert.deepEqual(complaints, []);
    };
    return page;
  }
}

/** A picture: its size, and red, green, blue and opacity of each pixel. @typedef {{width: number, height: number, data: Buffer}} Picture */

/** Draws on white what is drawable, in the page. */
const drawn = (what) => {
  const copy = document.createElement("canvas");
  copy.width = what.width;
  copy.height = what.height;
  const pen = copy.getContext("2d");
  pen.fillStyle = "white";
  pen.fillRect(0, 0, copy.width, copy.height);
  pen.drawImage(what, 0, 0);
  let text = "";
  const { data } = pen.getImageData(0, 0, copy.width, copy.height);
  for (let i = 0; i < data.length; i += 8192) text += String.fromCharCode(...data.subarray(i, i + 8192));
  return { width: copy.width, height: copy.height, data: btoa(text) };
};
const unpacked = ({ width, height, data }) => ({ width, height, data: Buffer.from(data, "base64") });

/** The page's picture as it is now. @returns {Promise<Picture>} */
export const pictureNow = async (page) =>
  unpacked(await page.evaluate(`(${drawn})(document.querySelector(".stage canvas"))`));

/** The page's picture at rest: when it has not changed for half a second. @returns {Promise<Picture>} */
export async function pictureAtRest(page) {
  let before = await pictureNow(page);
  for (let same = 0, i = 0; i < 100 && same < 2; ++i) {
    await page.waitForTimeout(250);
    const now = await pictureNow(page);
    same = now.data.equals(before.data) ? same + 1 : 0;
    before = now;
  }
  return before;
}

/** A picture in a file, read by the browser. @returns {Promise<Picture>} */
export async function pictureIn(page, file) {
  const address = `data:image/png;base64,${readFileSync(file).toString("base64")}`;
  return unpacked(
    await page.evaluate(`(async () => {
    const image = new Image();
    image.src = ${JSON.stringify(address)};
    await image.decode();
    return (${drawn})(image);
  })()`),
  );
}

/** How far two pictures of one size are apart: the mean difference of their colours in fields of 6 × 6 pixels, 0 to 255. */
export function apart(a, b) {
  assert.deepEqual([a.width, a.height], [b.width, b.height]);
  const side = 6;
  let sum = 0;
  let count = 0;
  for (let top = 0; top + side <= a.height; top += side)
    for (let left = 0; left + side <= a.width; left += side, ++count)
      for (const channel of [0, 1, 2]) {
        let difference = 0;
        for (let y = top; y < top + side; ++y)
          for (let x = left; x < left + side; ++x) {
            const at = 4 * (y * a.width + x) + channel;
            difference += a.data[at] - b.data[at];
          }
        sum += Math.abs(difference) / side ** 2 / 3;
      }
  return sum / count;
}

/** How many pixels have the colour in which what is chosen is outlined. */
export function outlined({ data }) {
  let count = 0;
  for (let i = 0; i < data.length; i += 4)
    count += [37, 99, 235].every((value, channel) => Math.abs(data[i + channel] - value) < 30) ? 1 : 0;
  return count;
}

/** Where labels point, in pixels of the window, by their ids; hidden ones apart. */
export const spotsOf = (page) =>
  page.evaluate(() => {
    const box = document.getElementById("stage").getBoundingClientRect();
    const spots = {};
    for (const label of document.querySelectorAll(".overlay .label")) {
      const dot = label.querySelector(".dot:not(.hidden)");
      if (dot)
        spots[label.dataset.id] = {
          x: box.left + Number(dot.getAttribute("cx")),
          y: box.top + Number(dot.getAttribute("cy")),
        };
    }
    return spots;
  });

/** The labels in the picture, by their ids. */
export const labelsOf = (page) =>
  page.locator(".overlay .label").evaluateAll((all) => all.map((one) => Number(one.dataset.id)).sort((a, b) => a - b));
