// SPDX-License-Identifier: Apache-2.0
// What the page can do by keys and fingers, and whose work its scene is.

import { iconButton, make } from "./elements.js";

/** @import { Lesson } from "./lesson.js" */

export class About {
  /** @param {Lesson} lesson */
  constructor(lesson) {
    this.lesson = lesson;
    this.element = make("dialog", { class: "about", id: "about", "aria-labelledby": "about-title" });
    // A click beside the dialog closes it.
    this.element.addEventListener("click", (event) => {
      if (event.target === this.element) this.element.close();
    });
  }

  open() {
    const { lesson } = this;
    const { credits, simplifiedMm } = lesson.facts;
    const millimetres = simplifiedMm?.toLocaleString(lesson.tongue, { maximumSignificantDigits: 2 });
    const section = (/** @type {string} */ key, /** @type {Node[]} */ ...inside) =>
      inside.length ? make("section", {}, make("h3", {}, lesson.say(key)), ...inside) : null;
    this.element.replaceChildren(
      make(
        "header",
        {},
        make("h2", { id: "about-title" }, lesson.facts.title),
        iconButton("close", lesson.say("close"), () => this.element.close()),
      ),
      section(
        "gestures",
        this.rows(["fingerTurn", "fingerZoom", "fingerTap", "fingerTwice", "mouseMove", "mouseWheel"]),
      ) ?? "",
      section(
        "keys",
        this.rows(["keyTurn", "keyRoll", "keyZoom", "keySides", "keyHome", "keyGamma", "keyTour", "keyFilter"]),
      ) ?? "",
      section("credits", ...credits.map((credit) => make("p", { dir: "auto" }, credit))) ?? "",
      ...(millimetres ? [make("p", { class: "small" }, lesson.say("simplified", millimetres))] : []),
      make("p", { class: "small" }, lesson.say("nothingKept")),
    );
    this.element.showModal();
  }

  /** @param {string[]} keys of texts "what|what it does" */
  rows(keys) {
    const rows = keys.flatMap((key) => {
      const [what, does] = this.lesson.say(key).split("|");
      return [make("dt", {}, what), make("dd", {}, does)];
    });
    return make("dl", {}, ...rows);
  }
}
