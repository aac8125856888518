// SPDX-License-Identifier: Apache-2.0
// Names are brought to what they name: dragged there, or chosen and then pointed or numbered.

import { icon, make, unseen } from "./elements.js";
import { clickReach } from "./gestures.js";
import { Question, shuffled } from "./question.js";

/** @import { QuestionFacts } from "./facts.d.ts" */
/** @import { Lesson } from "./lesson.js" */
/** @import { Outcome } from "./question.js" */
/** @import { Stage } from "./stage.js" */

/** @typedef {{place: number, at: number}} DraggedName `at` is the structure it was put on, 0 for none */

export class DragQuestion extends Question {
  /**
   * @param {Lesson} lesson
   * @param {Stage} stage
   * @param {QuestionFacts} facts
   * @param {(outcome: Outcome) => void} done
   */
  constructor(lesson, stage, facts, done) {
    super(lesson, stage, facts, done);
    /** @type {DraggedName[]} */
    this.dragged = shuffled(facts.structures.map((_, place) => ({ place, at: 0 })));
    /** @type {DraggedName | undefined} the one that is chosen */
    this.held = undefined;
    this.chips = make("div", { class: "chips", role: "group" });
    this.ghost = make("div", { class: "ghost", hidden: true, "aria-hidden": "true" });
    this.check = make("button", { type: "button", class: "plain-button", click: () => this.finish() });
  }

  prompt() {
    return this.lesson.say("askDrag");
  }

  subject() {
    return null;
  }

  remake() {
    this.check.textContent = this.lesson.say("answer");
    this.chips.setAttribute("aria-label", this.lesson.say("labelNames"));
    this.element.replaceChildren(this.chips, this.numbers, this.check, this.ghost);
    this.show();
  }

  /** @param {DraggedName} name */
  wordsOf(name) {
    const { lesson, facts } = this;
    const structure = facts.structures[name.place];
    const label = facts.labels[name.place];
    return (
      lesson.pick(facts.choices?.[name.place])?.words ??
      lesson.pick(lesson.nodes.get(structure)?.names)?.words ??
      lesson.labelTexts()[label]?.join(" ") ??
      lesson.nameOf(structure)
    );
  }

  /** Structures on which the name would be right. @param {DraggedName} name */
  homes(name) {
    const label = this.lesson.facts.labels.find((one) => one.id === this.facts.labels[name.place]);
    return this.lesson.allStructuresIn([this.facts.structures[name.place], ...(label?.structures ?? [])]);
  }

  show() {
    const { lesson } = this;
    this.check.disabled = this.dragged.some((name) => !name.at);
    this.chips.replaceChildren(...this.dragged.map((name) => this.chip(name)));
    const labels = lesson.facts.labels;
    /** @type {{[id: number]: string[]}} */
    const texts = {};
    for (const name of this.dragged) {
      const label = labels.find((one) => name.at !== 0 && one.structures.includes(name.at));
      if (label) texts[label.id] = [...(texts[label.id] ?? []), this.wordsOf(name)];
    }
    if (!this.numbered) {
      this.stage.askedLabels = { show: true, only: Object.keys(texts).map(Number), texts };
      this.stage.showLabels();
    }
    this.stage.engine?.select(this.held?.at ? [this.held.at] : []);
    this.stage.redraw();
  }

  labelMode() {
    const { lesson, facts } = this;
    if (this.numbered) return { show: true, numbers: true, texts: lesson.labelTexts(), only: facts.labels };
    return this.stage.askedLabels ?? { show: false, texts: {} };
  }

  showNumbers() {
    super.showNumbers();
    if (!this.numbered) this.show();
  }

  /** @param {DraggedName} name */
  chip(name) {
    const chip = make(
      "button",
      {
        type: "button",
        class: "chip",
        dir: "auto",
        "aria-pressed": String(this.held === name),
        click: () => this.hold(name),
      },
      this.wordsOf(name),
      name.at ? icon("right") : null,
      name.at ? unseen(this.lesson.say("placed")) : null,
    );
    chip.classList.toggle("put", name.at !== 0);
    chip.addEventListener("pointerdown", (event) => this.grab(event, chip, name));
    return chip;
  }

  /** @param {DraggedName} name */
  hold(name) {
    this.held = this.held === name ? undefined : name;
    const place = this.dragged.indexOf(name);
    this.show();
    this.chips.querySelectorAll("button")[place]?.focus();
  }

  /** @param {PointerEvent} event @param {HTMLElement} chip @param {DraggedName} name */
  grab(event, chip, name) {
    const start = { x: event.clientX, y: event.clientY };
    chip.setPointerCapture(event.pointerId);
    /** @param {PointerEvent} to */
    const moved = (to) => {
      if (this.ghost.hidden && Math.hypot(to.clientX - start.x, to.clientY - start.y) <= clickReach) return;
      this.ghost.hidden = false;
      this.ghost.textContent = this.wordsOf(name);
      this.ghost.style.setProperty("left", `${to.clientX}px`);
      this.ghost.style.setProperty("top", `${to.clientY}px`);
    };
    /** @param {PointerEvent} to */
    const ended = (to) => {
      chip.removeEventListener("pointermove", moved);
      if (this.ghost.hidden) return;
      this.ghost.hidden = true;
      // What follows is no click on the chip.
      chip.addEventListener("click", (click) => click.stopImmediatePropagation(), { capture: true, once: true });
      const box = this.stage.element.getBoundingClientRect();
      const inside = to.clientX > box.left && to.clientX < box.right && to.clientY > box.top && to.clientY < box.bottom;
      const structure = to.type === "pointerup" && inside ? this.stage.structureAt(to.clientX, to.clientY) : 0;
      window.setTimeout(() => structure && this.put(name, structure));
    };
    chip.addEventListener("pointermove", moved);
    chip.addEventListener("pointerup", ended, { once: true });
    chip.addEventListener("pointercancel", ended, { once: true });
  }

  /** @param {DraggedName} name @param {number} structure */
  put(name, structure) {
    name.at = structure;
    const open = this.dragged.findIndex((one) => !one.at);
    this.held = this.held ? this.dragged[open] : undefined;
    this.show();
    this.lesson.announce(`${this.wordsOf(name)}: ${this.lesson.say("placed")}`);
    (open < 0 ? this.check : this.chips.querySelectorAll("button")[open])?.focus({ preventScroll: true });
  }

  /** @param {number} structure */
  clicked(structure) {
    if (this.held && structure) this.put(this.held, structure);
  }

  finish() {
    const right = this.dragged.filter((name) => this.homes(name).includes(name.at)).length;
    const correct = right === this.dragged.length;
    this.done({
      correct,
      response: this.dragged.map((name) => `${this.wordsOf(name)}: ${this.lesson.nameOf(name.at)}`).join("; "),
      said: correct ? undefined : this.lesson.say("score", right, this.dragged.length),
    });
  }
}
