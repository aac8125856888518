// SPDX-License-Identifier: Apache-2.0
// Something is marked; its name is typed.

import { judged } from "./answers.js";
import { make } from "./elements.js";
import { Question } from "./question.js";

/** @import { QuestionFacts } from "./facts.d.ts" */
/** @import { Lesson } from "./lesson.js" */
/** @import { Outcome } from "./question.js" */
/** @import { Stage } from "./stage.js" */

export class NameQuestion extends Question {
  /**
   * @param {Lesson} lesson
   * @param {Stage} stage
   * @param {QuestionFacts} facts
   * @param {(outcome: Outcome) => void} done
   */
  constructor(lesson, stage, facts, done) {
    super(lesson, stage, facts, done);
    this.field = make("input", {
      type: "text",
      class: "typed",
      autocomplete: "off",
      autocapitalize: "off",
      spellcheck: "false",
      enterkeyhint: "done",
      maxlength: 200,
    });
  }

  prompt() {
    return this.lesson.say("askName");
  }

  subject() {
    return null;
  }

  marked() {
    return this.facts.structures;
  }

  remake() {
    const { lesson } = this;
    this.field.setAttribute("aria-label", lesson.say("yourAnswer"));
    this.field.placeholder = lesson.say("yourAnswer");
    this.element.replaceChildren(
      make(
        "form",
        { class: "typing", submit: (event) => this.submitted(event) },
        this.field,
        make("button", { type: "submit", class: "plain-button" }, lesson.say("answer")),
      ),
    );
  }

  /** @param {Event} event */
  submitted(event) {
    event.preventDefault();
    const typed = this.field.value.trim();
    if (!typed) return;
    const { quiz } = this.lesson.facts;
    const own = new Set(this.facts.answers);
    const others = quiz.questions.flatMap((question) => question.answers.filter((hash) => !own.has(hash)));
    const verdict = judged(typed, { answers: this.facts.answers, others, salt: quiz.salt });
    this.done({
      correct: verdict !== "wrong",
      response: typed,
      said: verdict === "nearly" ? this.lesson.say("nearlyRight") : undefined,
    });
  }

  further() {
    return null;
  }

  /** A click in the picture is no answer. */
  clicked() {}
}
