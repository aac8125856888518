// SPDX-License-Identifier: Apache-2.0
// Structures are put in order along a path: names from a list, or structures in the picture.

import { iconButton, make } from "./elements.js";
import { Question, shuffled } from "./question.js";

/** @import { QuestionFacts } from "./facts.d.ts" */
/** @import { Lesson } from "./lesson.js" */
/** @import { Outcome } from "./question.js" */
/** @import { Stage } from "./stage.js" */

export class OrderQuestion extends Question {
  /**
   * @param {Lesson} lesson
   * @param {Stage} stage
   * @param {QuestionFacts} facts
   * @param {(outcome: Outcome) => void} done
   */
  constructor(lesson, stage, facts, done) {
    super(lesson, stage, facts, done);
    /** @type {number[]} places in `structures` */
    this.pool = shuffled(facts.structures.map((_, place) => place));
    /** @type {number[]} structures in the reader's order */
    this.path = [];
    this.shown = lesson.nameless;
    this.list = make("ol", { class: "path" });
    this.chips = make("div", { class: "chips" });
    this.check = make("button", { type: "button", class: "plain-button", click: () => this.finish() });
  }

  prompt() {
    return this.lesson.say(this.shown ? "askOrderShown" : "askOrder");
  }

  marked() {
    return this.path;
  }

  remake() {
    this.check.textContent = this.lesson.say("answer");
    this.element.replaceChildren(this.list, this.chips, this.numbers, this.check);
    this.show();
  }

  further() {
    return this.shown ? this.numberSwitch() : null;
  }

  /** @param {number} structure */
  nameElement(structure) {
    const words = this.facts.choices?.[this.facts.structures.indexOf(structure)];
    return this.lesson.pick(words) ? this.lesson.wordsElement(words) : this.lesson.nameElement(structure);
  }

  show() {
    const { lesson, path } = this;
    this.check.disabled = path.length !== this.facts.structures.length;
    this.list.replaceChildren(...path.map((structure, place) => this.step(structure, place)));
    this.chips.replaceChildren(
      ...(this.shown ? [] : this.pool)
        .map((place) => this.facts.structures[place])
        .filter((structure) => !path.includes(structure))
        .map((structure) =>
          make(
            "button",
            { type: "button", class: "chip", click: () => this.add(structure) },
            this.nameElement(structure),
          ),
        ),
    );
    this.stage.engine?.select(lesson.allStructuresIn(path));
    this.stage.redraw();
  }

  /** @param {number} structure @param {number} place */
  step(structure, place) {
    const { lesson } = this;
    const name = this.nameElement(structure);
    const words = name.textContent ?? "";
    const earlier = iconButton("up", lesson.say("earlier", words), () => this.swap(place, place - 1), {
      "data-move": `up ${structure}`,
    });
    const later = iconButton("down", lesson.say("later", words), () => this.swap(place, place + 1), {
      "data-move": `down ${structure}`,
    });
    earlier.disabled = place === 0;
    later.disabled = place === this.path.length - 1;
    return make(
      "li",
      {},
      make("span", { class: "step-name" }, name),
      earlier,
      later,
      iconButton("close", `${lesson.say("clear")}: ${words}`, () => this.remove(structure)),
    );
  }

  /** @param {number} structure */
  add(structure) {
    if (this.path.includes(structure) || this.path.length === this.facts.structures.length) return;
    this.path.push(structure);
    this.show();
    // The chip is gone that was pressed.
    const next = this.chips.querySelector("button") ?? this.check;
    if (!this.shown) next.focus();
  }

  /** @param {number} structure */
  remove(structure) {
    this.path = this.path.filter((one) => one !== structure);
    this.show();
    this.chips.querySelector("button")?.focus();
  }

  /** @param {number} a @param {number} b */
  swap(a, b) {
    const structure = this.path[a];
    [this.path[a], this.path[b]] = [this.path[b], this.path[a]];
    this.show();
    const way = b < a ? "up" : "down";
    const moved = [...this.list.querySelectorAll("button")].filter(
      (button) => button.getAttribute("data-move")?.endsWith(` ${structure}`) && !button.disabled,
    );
    (moved.find((button) => button.getAttribute("data-move")?.startsWith(way)) ?? moved[0])?.focus();
  }

  /** @param {number} structure */
  clicked(structure) {
    if (this.shown || this.facts.structures.includes(structure)) this.add(structure);
  }

  finish() {
    const { lesson } = this;
    const correct = this.path.every((structure, place) => structure === this.facts.structures[place]);
    const names = this.facts.structures.map((structure) => this.nameElement(structure).textContent);
    this.done({
      correct,
      response: this.path.map((structure) => this.nameElement(structure).textContent).join(", "),
      said: correct || lesson.nameless ? undefined : lesson.say("itIs", names.join(", ")),
    });
  }
}
