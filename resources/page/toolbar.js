// SPDX-License-Identifier: Apache-2.0
// The row under the picture: sides, zoom, the view's title, labels.

import { iconButton, inTwoLines, make } from "./elements.js";
import { directions } from "./stage.js";

/** @import { Direction } from "./engine.d.ts" */
/** @import { LabelChoice, Lesson } from "./lesson.js" */
/** @import { Stage } from "./stage.js" */

export class Toolbar {
  /** @param {Lesson} lesson @param {Stage} stage */
  constructor(lesson, stage) {
    this.lesson = lesson;
    this.stage = stage;
    /** What is shown as the side that faces the reader, and by which control. */
    this.facing = "";
    /** @type {HTMLElement | undefined} */
    this.shown = undefined;
    this.element = make("div", { class: "toolbar", role: "group" });
    this.remake();
    lesson.hear("language", () => this.remake());
    lesson.hear("drawn", () => this.showFacing());
    lesson.hear(["view", "quiz"], () => this.showTitle());
    lesson.hear("quiz", () => this.showHeld());
  }

  remake() {
    const { lesson, stage } = this;
    this.element.setAttribute("aria-label", lesson.say("viewTools"));
    this.title = inTwoLines(make("p", { class: "caption" }));
    this.sides = directions.map(([side, letter]) =>
      make(
        "button",
        {
          type: "button",
          class: "from",
          title: `${lesson.say("from")} ${lesson.say(side)}`,
          "aria-label": `${lesson.say("from")} ${lesson.say(side)}`,
          click: () => stage.move((engine) => engine.direction(side), false),
        },
        letter,
      ),
    );
    this.turned = make("option", { value: "", disabled: true }, lesson.say("turned"));
    this.side = make(
      "select",
      { class: "side-select", "aria-label": lesson.say("from"), change: () => this.sideChosen() },
      this.turned,
      ...directions.map(([side, letter]) => make("option", { value: side }, `${letter}\u2003${lesson.say(side)}`)),
    );
    this.tools = [
      iconButton("fit", lesson.say("fit"), () => stage.fit([])),
      iconButton("minus", lesson.say("farther"), () => stage.zoomMiddle(1 / 1.3)),
      iconButton("plus", lesson.say("nearer"), () => stage.zoomMiddle(1.3)),
    ];
    this.labels = make(
      "select",
      { class: "label-select", "aria-label": lesson.say("labels"), change: () => this.labelsChosen() },
      ...["names", "numbers", "none"].map((value) =>
        make(
          "option",
          { value, selected: value === lesson.labels },
          lesson.say("label" + value[0].toUpperCase() + value.slice(1)),
        ),
      ),
    );
    this.element.replaceChildren(
      make("div", { class: "sides" }, ...this.sides),
      this.side,
      make("div", { class: "zooms" }, ...this.tools),
      this.title,
      this.labels,
    );
    this.showFacing();
    this.showTitle();
    this.showHeld();
  }

  sideChosen() {
    const side = /** @type {Direction} */ (this.side?.value);
    this.stage.move((engine) => engine.direction(side), false);
  }

  labelsChosen() {
    this.lesson.labels = /** @type {LabelChoice} */ (this.labels?.value);
    this.lesson.tell({ type: "labels" });
  }

  showFacing() {
    const facing = this.stage.engine?.facing() ?? "";
    if (facing === this.facing && this.shown === this.side) return;
    this.facing = facing;
    this.shown = this.side;
    directions.forEach(([, letter], i) => this.sides?.[i].setAttribute("aria-pressed", String(letter === facing)));
    if (this.side) this.side.value = directions.find(([, letter]) => letter === facing)?.[0] ?? "";
  }

  showTitle() {
    const { lesson } = this;
    const view = lesson.facts.views[lesson.view - 1];
    this.title?.replaceChildren(view && !lesson.asking ? lesson.wordsElement(view.title) : "");
  }

  /** What a question holds cannot be used. */
  showHeld() {
    const held = this.stage.cameraHeld;
    for (const tool of [...(this.sides ?? []), ...(this.tools ?? []), this.side]) if (tool) tool.disabled = held;
    if (this.labels) this.labels.hidden = this.lesson.asking || this.lesson.nameless;
  }
}
