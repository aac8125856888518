// SPDX-License-Identifier: Apache-2.0
// The tour: one view after the other with its text.

import { icon, iconButton, make } from "./elements.js";
import { linesElement } from "./lines.js";

/** @import { ViewFacts } from "./facts.d.ts" */
/** @import { Flight } from "./flight.js" */
/** @import { Lesson } from "./lesson.js" */
/** @import { Links } from "./links.js" */

export class Tour {
  /** @param {Lesson} lesson @param {Flight} flight @param {Links} links */
  constructor(lesson, flight, links) {
    this.lesson = lesson;
    this.flight = flight;
    this.links = links;
    this.element = make("div", { class: "tour-box" });
    this.remake();
    lesson.hear(["language", "view"], () => this.remake());
  }

  get count() {
    return this.lesson.facts.views.length;
  }

  /** @param {number} step */
  go(step) {
    const view = this.lesson.view + step;
    if (view < 1 || view > this.count || this.lesson.asking) return false;
    this.flight.goTo(view);
    const title = this.lesson.pick(this.lesson.facts.views[view - 1].title)?.words ?? "";
    this.lesson.announce(`${this.lesson.say("viewOf", view, this.count)} ${title}`);
    return true;
  }

  remake() {
    const { lesson } = this;
    const held = this.element.contains(document.activeElement)
      ? document.activeElement?.getAttribute("data-step")
      : undefined;
    const view = lesson.facts.views[lesson.view - 1];
    this.element.replaceChildren(...(view ? [this.steps(), this.text(view)] : [this.opening()]), this.contents());
    this.element.scrollTop = 0;
    if (held) {
      const step = [...this.element.querySelectorAll("button")].find(
        (one) => one.getAttribute("data-step") === held && !one.disabled,
      );
      (step ?? this.element.querySelector("button"))?.focus();
    }
  }

  opening() {
    return make(
      "div",
      { class: "opening" },
      make(
        "button",
        { type: "button", class: "plain-button", click: () => this.go(1), "data-step": "1" },
        this.lesson.say("beginTour"),
        icon("on"),
      ),
    );
  }

  steps() {
    const { lesson } = this;
    const back = iconButton("back", lesson.say("previous"), () => this.go(-1), { "data-step": "-1" });
    const on = iconButton("on", lesson.say("next"), () => this.go(1), { "data-step": "1" });
    back.disabled = lesson.view <= 1;
    on.disabled = lesson.view >= this.count;
    return make(
      "div",
      { class: "steps" },
      back,
      make("span", { class: "count" }, lesson.say("viewOf", lesson.view, this.count)),
      on,
    );
  }

  /** @param {ViewFacts} view */
  text(view) {
    const { lesson } = this;
    const words = lesson.pick(view.words);
    const title = lesson.wordsElement(view.title, "h2");
    if (!title.textContent) title.textContent = lesson.say("view", lesson.view);
    return make(
      "article",
      { class: "view-text" },
      title,
      words ? linesElement(words.words, words.language, this.links) : null,
    );
  }

  contents() {
    const { lesson } = this;
    const items = lesson.facts.views.map((view, i) => {
      const title = lesson.pick(view.title)
        ? lesson.wordsElement(view.title)
        : make("span", {}, lesson.say("view", i + 1));
      return make(
        "li",
        {},
        make(
          "button",
          {
            type: "button",
            class: "content",
            "data-step": `to ${i + 1}`,
            "aria-current": lesson.view === i + 1 ? "step" : undefined,
            click: () => this.flight.goTo(i + 1),
          },
          make("span", { class: "content-number" }, String(i + 1)),
          title,
        ),
      );
    });
    return make("nav", { class: "contents", "aria-label": lesson.say("contents") }, make("ol", {}, ...items));
  }
}
