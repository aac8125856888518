// SPDX-License-Identifier: Apache-2.0
// What is printed: the picture as it is, its title and text, the key, and whose work it is.

import { make } from "./elements.js";
import { linesElement } from "./lines.js";

/** @import { Lesson } from "./lesson.js" */
/** @import { Links } from "./links.js" */
/** @import { Stage } from "./stage.js" */

export class PrintedPage {
  /** @param {Lesson} lesson @param {Stage} stage @param {Links} links */
  constructor(lesson, stage, links) {
    this.lesson = lesson;
    this.stage = stage;
    this.links = links;
    this.element = make("section", { id: "printed", "aria-hidden": "true" });
    window.addEventListener("beforeprint", () => this.fill());
    window.addEventListener("afterprint", () => this.element.replaceChildren());
  }

  fill() {
    const { lesson } = this;
    const view = lesson.asking ? undefined : lesson.facts.views[lesson.view - 1];
    const words = lesson.pick(view?.words);
    this.element.replaceChildren(
      make("h1", { dir: "auto" }, lesson.facts.title),
      this.picture(),
      view ? lesson.wordsElement(view.title, "h2") : "",
      this.key() ?? "",
      words ? linesElement(words.words, words.language, this.links) : "",
      ...lesson.facts.credits.map((credit) => make("p", { class: "small", dir: "auto" }, credit)),
    );
  }

  /** A copy, as a browser forgets what WebGL drew once it has shown it. */
  picture() {
    const { stage } = this;
    const copy = make("canvas");
    const picture = make("div", { class: "printed-picture" }, copy);
    stage.drawFine(() => {
      copy.width = stage.canvas.width;
      copy.height = stage.canvas.height;
      copy.getContext("2d")?.drawImage(stage.canvas, 0, 0);
      picture.append(stage.overlay.cloneNode(true));
    });
    return picture;
  }

  key() {
    const { lesson } = this;
    if (lesson.labels !== "numbers" || lesson.asking || lesson.nameless) return null;
    const texts = lesson.labelTexts();
    const rows = new Map(lesson.placed.map((placed) => [placed.number, texts[placed.id]?.join(" ") ?? ""]));
    const sorted = [...rows].sort(([a], [b]) => a - b);
    return make(
      "ol",
      { class: "printed-key", "aria-label": lesson.say("key") },
      ...sorted.map(([number, words]) => make("li", { value: number, dir: "auto" }, words)),
    );
  }
}
