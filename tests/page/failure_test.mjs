// SPDX-License-Identifier: Apache-2.0
// What the page says where it cannot draw: still pictures, and why.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { after, before, test } from "node:test";
import { Pages } from "./browser.mjs";

let pages;
before(async () => (pages = await Pages.open()));
after(() => pages.close());

/** The notice above the still pictures. */
async function notice(page) {
  await page.locator("#stills .notice[role=alert]").waitFor({ state: "visible" });
  assert.equal(await page.locator("#stills figure:visible").count(), 3);
  assert.equal(await page.locator("#app").isVisible(), false);
  return page.locator("#stills .notice[role=alert]").innerText();
}

test("no script", async () => {
  const page = await pages.show({}, { javaScriptEnabled: false, whole: false });
  assert.equal(await page.locator("#stills figure:visible").count(), 3);
  assert.equal(await page.locator("#stills .notice:visible").count(), 4);
  assert.match(await page.locator("#stills").innerText(), /still pictures/);
  await page.done();
});

test("no WebAssembly, no decompression, no canvas", async () => {
  const address = pages.write();
  for (const [before, query, wanted, locale] of [
    [() => delete window.WebAssembly, "", /cannot turn the scene.*WebAssembly is switched off/, "en"],
    [() => delete window.DecompressionStream, "", /too old to unpack/, "en"],
    [undefined, "?no-drawing", /neither WebGL 2 nor Canvas 2D/, "en"],
  ]) {
    const page = await pages.visit(address + query, { before, locale, whole: false });
    assert.match(await notice(page), wanted);
    await page.done();
  }
});

test("without WebGL it says so", async () => {
  const page = await pages.show({}, { query: "?plain" });
  assert.match(await page.locator(".status").innerText(), /without WebGL/);
  await page.done();
});

test("damaged files", async () => {
  const later = await pages.visit(
    pages.write({}, (parts) => ({ ...parts, facts: { ...parts.facts, schema: 2 } })),
    { whole: false },
  );
  assert.match(await notice(later), /damaged/);
  await later.done();
  const address = pages.write();
  const html = readFileSync(new URL(address), "utf8");
  for (const [from, to] of [
    [/<script type="text\/plain" id="program">[^<]*<\/script>/, ""],
    [/<script type="text\/plain" id="scene">[^<]*<\/script>/, ""],
    [/(id="scene">).{40}/, "$1%%%"],
    [/(id="scene">.{60}).{20}/, "$1AAAAAAAAAAAAAAAAAAAA"],
    [/(id="facts">.)/, "$1,"],
  ]) {
    assert.match(html, from);
    writeFileSync(fileURLToPath(address), html.replace(from, to));
    const page = await pages.visit(address, { whole: false });
    assert.match(await notice(page), /damaged/);
    await page.done();
  }
});

test("a context that cannot be read leaves the scene usable", async () => {
  const page = await pages.visit(pages.write({}, (parts) => ({ ...parts, context: undefined })));
  await page.done();
  const spoiled = await pages.visit(
    pages.write({}, (parts) => ({ ...parts, context: "no scene" })),
    { whole: false },
  );
  await spoiled.locator(".status", { hasText: "surroundings could not be read" }).waitFor();
  await spoiled.clickOn(6);
  assert.equal(await spoiled.locator("#card h2").innerText(), "Urinary bladder");
  await spoiled.done();
});

test("a page of several files: from a server it opens, else it says what it needs", async () => {
  const { createServer } = await import("node:http");
  const { lesson } = await import("./lesson.mjs");
  const address = pages.write();
  const html = readFileSync(new URL(address), "utf8")
    .replace(/id="scene">[^<]*</, 'id="scene" data-src="pelvis.scene"><')
    .replace(/id="program">[^<]*</, 'id="program" data-src="engine.wasm"><')
    .replace("base-uri", "connect-src 'self'; base-uri");
  writeFileSync(fileURLToPath(address), html);
  const page = await pages.browser.newPage();
  await page.goto(address);
  assert.match(await notice(page), /(pelvis\.scene|engine\.wasm).*needs a web server/);
  await page.close();

  const files = { "/": html, "/pelvis.scene": gzipSync(lesson().scene), "/engine.wasm": "program" };
  const server = createServer((request, answer) => {
    const file = files[request.url];
    answer.writeHead(file ? 200 : 404, {
      "content-type": request.url === "/" ? "text/html" : "application/octet-stream",
    });
    answer.end(file ?? "");
  });
  await new Promise((ready) => server.listen(0, "127.0.0.1", ready));
  const served = await pages.browser.newPage();
  await served.goto(`http://127.0.0.1:${server.address().port}/`);
  await served.waitForSelector("body.complete", { state: "attached" });
  assert.equal(await served.evaluate(() => window.engine.scene.balls.length), 11);
  await served.close();
  server.close();
});

test("a picture that the browser takes away", async () => {
  const page = await pages.show();
  await page.evaluate(() =>
    document.querySelector(".stage canvas").dispatchEvent(new Event("webglcontextlost", { cancelable: true })),
  );
  assert.match(await page.locator(".status").innerText(), /Load the page again\. Load again/);
  await page.done();

  const failed = await pages.show();
  await failed.evaluate(
    () =>
      (window.engine.draw = () => {
        throw new Error("memory");
      }),
  );
  await failed.getByRole("button", { name: "Nearer" }).click();
  await failed.locator(".status", { hasText: "Load the page again" }).waitFor();
  await failed.done();
});
