// SPDX-License-Identifier: Apache-2.0
// What questions of all kinds have in common, and the kind that asks where something is.

import { make } from "./elements.js";

/** @import { LabelMode } from "./engine.d.ts" */
/** @import { QuestionFacts } from "./facts.d.ts" */
/** @import { Lesson } from "./lesson.js" */
/** @import { Stage } from "./stage.js" */

/**
 * How a question was answered: `response` is told to the learning system, `said` to the reader.
 * @typedef {{correct: boolean, response: string, said?: string}} Outcome
 */

/** Returns the list in another order, by chance. @template T @param {readonly T[]} list @returns {T[]} */
export function shuffled(list) {
  const out = [...list];
  for (let i = out.length - 1; i > 0; --i) {
    const j = Math.floor(Math.random() * (i + 1));
    [out[i], out[j]] = [out[j], out[i]];
  }
  return out;
}

export class Question {
  /**
   * @param {Lesson} lesson
   * @param {Stage} stage
   * @param {QuestionFacts} facts
   * @param {(outcome: Outcome) => void} done
   */
  constructor(lesson, stage, facts, done) {
    this.lesson = lesson;
    this.stage = stage;
    this.facts = facts;
    this.done = done;
    this.numbers = make("div", { class: "numbers", role: "group" });
    /** Whether labels are shown as numbers that may be answered with. */
    this.numbered = false;
    this.fewLabels = false;
    this.element = make("div", { class: "question-body" });
  }

  /** What the reader is asked. */
  prompt() {
    return this.lesson.say("askFind");
  }

  /** What is asked for, in large letters. @returns {HTMLElement | null} */
  subject() {
    return this.lesson.pick(this.facts.words) ? this.lesson.wordsElement(this.facts.words, "strong") : null;
  }

  /** Structures that are marked while it is asked. @returns {number[]} */
  marked() {
    return [];
  }

  /** Labels that are shown while it is asked. @returns {LabelMode} */
  labelMode() {
    return this.numbered
      ? {
          show: true,
          numbers: true,
          texts: this.lesson.labelTexts(),
          ...(this.fewLabels ? { only: this.facts.labels } : { seen: this.lesson.facts.labelsFound }),
        }
      : { show: false, texts: {} };
  }

  /** Makes the controls. */
  remake() {
    this.element.replaceChildren(this.numbers);
  }

  /** What stands below, beside giving up. @returns {HTMLElement | null} */
  further() {
    return this.numberSwitch();
  }

  /** The structure in the picture was clicked, or the number of its label. @param {number} structure */
  clicked(structure) {
    const correct = this.names(structure);
    const response = this.lesson.nameOf(structure);
    this.done({
      correct,
      response,
      said: correct || this.lesson.nameless ? undefined : this.lesson.say("thatWas", response),
    });
  }

  /** Whether the structure is asked for or lies in what is. @param {number} structure */
  names(structure) {
    return this.lesson.allStructuresIn(this.facts.structures).includes(structure);
  }

  /** For who cannot point: labels become numbers. */
  numberSwitch() {
    return make(
      "button",
      {
        type: "button",
        class: "quiet-button",
        "aria-pressed": String(this.numbered),
        click: (event) => this.switchNumbers(event.currentTarget),
      },
      this.lesson.say("byNumber"),
    );
  }

  /** @param {HTMLElement} button */
  switchNumbers(button) {
    this.numbered = !this.numbered;
    this.fewLabels = false;
    button.setAttribute("aria-pressed", String(this.numbered));
    this.showNumbers();
    if (!this.numbered) return;
    // A view may not show the label that would be the answer.
    const { placed, facts } = this.lesson;
    const shown = facts.labels.filter((label) => placed.some((one) => one.id === label.id));
    this.fewLabels = !shown.some((label) => label.structures.some((id) => this.names(id)));
    if (this.fewLabels) this.showNumbers();
  }

  showNumbers() {
    this.stage.askedLabels = this.labelMode();
    this.stage.showLabels();
    this.stage.drawNow();
    this.numbers.setAttribute("aria-label", this.lesson.say("byNumber"));
    this.numbers.replaceChildren();
    if (!this.numbered) return;
    const seen = new Set();
    for (const placed of [...this.lesson.placed].sort((a, b) => a.number - b.number)) {
      const label = this.lesson.facts.labels.find((one) => one.id === placed.id);
      if (!label?.structures.length || seen.has(placed.number)) continue;
      seen.add(placed.number);
      this.numbers.append(
        make(
          "button",
          {
            type: "button",
            class: "number",
            "aria-label": this.lesson.say("number", placed.number),
            click: () => this.clicked(label.structures[0]),
          },
          String(placed.number),
        ),
      );
    }
  }
}
