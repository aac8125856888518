// SPDX-License-Identifier: Apache-2.0
// Something is marked; its name is chosen.

import { make } from "./elements.js";
import { Question } from "./question.js";

export class ChoiceQuestion extends Question {
  prompt() {
    return this.lesson.say("askChoose");
  }

  subject() {
    return null;
  }

  marked() {
    return this.facts.structures;
  }

  remake() {
    const { lesson, facts } = this;
    const choices = (facts.choices ?? []).map((words, i) =>
      make(
        "li",
        {},
        make("button", { type: "button", class: "choice", click: () => this.chosen(i) }, lesson.wordsElement(words)),
      ),
    );
    this.element.replaceChildren(make("ul", { class: "choices" }, ...choices));
  }

  /** @param {number} choice */
  chosen(choice) {
    this.done({
      correct: choice === this.facts.right,
      response: this.lesson.pick(this.facts.choices?.[choice])?.words ?? String(choice + 1),
    });
  }

  further() {
    return null;
  }

  /** A click in the picture is no answer. */
  clicked() {}
}
