// SPDX-License-Identifier: Apache-2.0
// Asks the questions one after the other, says what was right, and tells it to the learning system.

import { gammaSlider, showGamma } from "./card.js";
import { ChoiceQuestion } from "./choice_question.js";
import { DragQuestion } from "./drag_question.js";
import { icon, make, unseen } from "./elements.js";
import { NameQuestion } from "./name_question.js";
import { OrderQuestion } from "./order_question.js";
import { Question, shuffled } from "./question.js";

/** @import { QuestionFacts } from "./facts.d.ts" */
/** @import { Flight } from "./flight.js" */
/** @import { Lesson } from "./lesson.js" */
/** @import { Outcome } from "./question.js" */
/** @import { CreateReporter } from "./reporter.d.ts" */
/** @import { Stage } from "./stage.js" */

const questionKinds = {
  find: Question,
  name: NameQuestion,
  choose: ChoiceQuestion,
  order: OrderQuestion,
  drag: DragQuestion,
};

export class Quiz {
  /** @param {Lesson} lesson @param {Stage} stage @param {Flight} flight @param {CreateReporter} createReporter */
  constructor(lesson, stage, flight, createReporter) {
    this.lesson = lesson;
    this.stage = stage;
    this.flight = flight;
    const { quiz, report } = lesson.facts;
    this.questions = quiz.mode === "off" ? [] : quiz.questions.filter((question) => this.canBeAsked(question));
    /** Those of the round that is going on. */
    this.asked = this.questions;
    /** @type {Map<string, boolean>} whether what was answered was right */
    this.answered = new Map();
    /** @type {"ready" | "asking" | "told" | "over"} */
    this.state = "ready";
    this.at = 0;
    this.began = 0;
    this.ended = false;
    /** @type {Question | undefined} */
    this.question = undefined;
    /** @type {Outcome | undefined} */
    this.outcome = undefined;
    this.element = make("div", { class: "quiz-box" });
    this.reporter = createReporter(quiz.counts && this.questions.length ? report : undefined);
    /** What was answered before the page was closed is known. */
    this.known = this.questions.length ? this.resume() : Promise.resolve();
    lesson.hear("language", () => this.remake());
    window.addEventListener("pagehide", () => {
      if (!this.ended) this.reporter.suspend();
    });
    this.remake();
  }

  /** Names to choose from, or to look for, are not in a page without names. @param {QuestionFacts} question */
  canBeAsked(question) {
    const { lesson } = this;
    if (!(question.kind in questionKinds)) return false;
    if (question.kind === "find") return lesson.pick(question.words) !== undefined;
    if (question.kind === "choose") return question.choices !== undefined && question.right !== undefined;
    if (question.kind === "drag") return !lesson.nameless;
    return question.structures.length > 0;
  }

  async resume() {
    const { answered } = await this.reporter.begin(this.questions.length);
    for (const question of this.questions)
      if (question.id in answered) this.answered.set(question.id, answered[question.id]);
    this.remake();
  }

  get right() {
    return this.asked.filter((question) => this.answered.get(question.id)).length;
  }

  /** Whether the reader may begin anew: where it counts only the first answers do. */
  get repeats() {
    return !this.lesson.facts.quiz.counts || this.lesson.facts.report === undefined;
  }

  remake() {
    const { state } = this;
    const page = state === "ready" ? this.readyPage() : state === "over" ? this.overPage() : this.questionPage();
    this.element.replaceChildren(...page);
    if (state === "asking") this.question?.remake();
  }

  readyPage() {
    const { lesson, questions, answered } = this;
    const count = questions.length;
    const said = [
      count === 1 ? lesson.say("oneQuestion") : lesson.say("questions", count),
      lesson.say(lesson.facts.quiz.counts ? "countsText" : "practice"),
    ];
    if (answered.size) said.push(lesson.say("resumed", answered.size));
    return [
      make(
        "div",
        { class: "opening" },
        ...said.map((words) => make("p", {}, words)),
        this.rounds(),
        make(
          "button",
          { type: "button", class: "plain-button", click: () => this.begin() },
          lesson.say("start"),
          icon("on"),
        ),
      ),
    ];
  }

  /** Who practises may take some of many questions. */
  rounds() {
    const count = this.questions.length;
    const sizes = [10, 20, 50].filter((size) => size < count);
    this.size = make(
      "select",
      {},
      ...sizes.map((size) => make("option", { value: size }, String(size))),
      make("option", { value: count }, this.lesson.say("all", count)),
    );
    return this.repeats && sizes.length
      ? make("label", { class: "round" }, this.lesson.say("howMany"), " ", this.size)
      : null;
  }

  async begin() {
    await this.known;
    const size = this.repeats ? Number(this.size?.value ?? this.questions.length) : this.questions.length;
    const some = new Set(shuffled(this.questions).slice(0, size));
    this.asked = this.questions.filter((question) => some.has(question));
    this.at = -1;
    this.next();
  }

  /** Asks the next question that is not answered. */
  next() {
    do ++this.at;
    while (this.at < this.asked.length && this.answered.has(this.asked[this.at].id));
    if (this.at === this.asked.length) {
      this.finish();
      return;
    }
    const facts = this.asked[this.at];
    this.state = "asking";
    this.outcome = undefined;
    this.question = new questionKinds[facts.kind](this.lesson, this.stage, facts, (outcome) => this.take(outcome));
    this.ask();
    this.began = performance.now();
    // A telephone's keyboard would cover what is asked for.
    const typing = matchMedia("(pointer: coarse)").matches ? ".prompt" : ".typed";
    this.focus(typing, ".choice", ".chip", ".prompt");
  }

  /** Brings the picture to the question. */
  ask() {
    const { lesson, stage, question } = this;
    if (!question) return;
    const { quiz } = lesson.facts;
    lesson.asking = true;
    stage.askedLabels = question.labelMode();
    if (question.facts.view) this.flight.goTo(question.facts.view, true);
    // What is marked must be there to be seen; a view shows what is asked for.
    else stage.engine?.setVisible(lesson.allStructuresIn(question.facts.structures), true);
    stage.cameraHeld = quiz.lockCamera;
    stage.lookHeld = quiz.lockLook;
    lesson.choose(question.marked());
    lesson.tell({ type: "look" });
    lesson.tell({ type: "quiz" });
    this.remake();
  }

  questionPage() {
    const { lesson, question, outcome } = this;
    if (!question) return [];
    const subject = question.subject();
    const count = lesson.say("questionOf", this.at + 1, this.asked.length);
    const prompt = make(
      "div",
      { class: "prompt", tabindex: "-1" },
      make("p", { class: "count" }, count),
      make("h2", {}, question.prompt()),
      subject ? make("p", { class: "subject" }, subject) : null,
    );
    if (outcome) return [prompt, this.verdict(outcome)];
    const foot = make(
      "div",
      { class: "question-foot" },
      make(
        "button",
        { type: "button", class: "quiet-button", click: () => this.take({ correct: false, response: "" }) },
        lesson.say("unknown"),
      ),
      question.further(),
      this.surroundings(question),
    );
    return [prompt, question.element, foot];
  }

  /** Makes what lies around the marked structure fainter or fuller. @param {Question} question */
  surroundings(question) {
    const { lesson, stage } = this;
    if (lesson.facts.quiz.lockLook) return null;
    const marked = new Set(lesson.allStructuresIn(question.marked()));
    const others = lesson.facts.nodes.filter((node) => !node.group && !marked.has(node.id)).map((node) => node.id);
    const words = lesson.say("surroundings");
    const slider = gammaSlider(lesson, words, (gamma, moving) => stage.setGamma(others, gamma, moving));
    const mean = others.reduce((sum, id) => sum + stage.gammaOf(id), 0) / Math.max(1, others.length);
    showGamma(lesson, slider, mean);
    return make("label", { class: "surroundings" }, make("span", {}, words), slider);
  }

  /** @param {Outcome} outcome */
  verdict(outcome) {
    const { lesson, question } = this;
    const facts = question?.facts;
    const said = outcome.said ? [outcome.said] : [];
    const names =
      facts && !lesson.nameless && facts.kind !== "order" && facts.kind !== "drag" && facts.kind !== "find"
        ? lesson.pick(facts.words)?.words
        : undefined;
    if (names) said.push(lesson.say("itIs", names));
    if (facts?.kind === "find" && !outcome.correct) said.push(lesson.say("markedNow"));
    const last = this.asked.every((one) => this.answered.has(one.id));
    return make(
      "div",
      { class: outcome.correct ? "verdict right" : "verdict wrong" },
      make(
        "p",
        { class: "verdict-word" },
        icon(outcome.correct ? "right" : "wrong"),
        lesson.say(outcome.correct ? "rightAnswer" : "wrongAnswer"),
      ),
      ...said.map((words) => make("p", {}, words)),
      make(
        "button",
        { type: "button", class: "plain-button on", click: () => this.next() },
        lesson.say(last ? "finish" : "next"),
        icon("on"),
      ),
    );
  }

  /** Takes the answer; it is the only one. @param {Outcome} outcome */
  take(outcome) {
    const { lesson, stage, question } = this;
    if (this.state !== "asking" || !question) return;
    const { facts } = question;
    this.state = "told";
    this.outcome = outcome;
    this.answered.set(facts.id, outcome.correct);
    this.reporter.answer({
      id: facts.id,
      kind: facts.kind,
      response: outcome.response,
      correct: outcome.correct,
      words: lesson.nameless ? question.prompt() : (lesson.pick(facts.words)?.words ?? question.prompt()),
      seconds: (performance.now() - this.began) / 1000,
    });
    stage.askedLabels = lesson.nameless
      ? { show: false, texts: {} }
      : { show: true, only: facts.labels, texts: lesson.labelTexts() };
    lesson.choose(facts.structures);
    lesson.tell({ type: "quiz" });
    stage.showChosen();
    this.remake();
    lesson.announce([...this.element.querySelectorAll(".verdict p")].map((p) => p.textContent).join(" "));
    this.focus(".on");
  }

  /** @param {number} structure in the picture; 0 for none */
  clicked(structure) {
    if (this.state === "asking" && structure) this.question?.clicked(structure);
  }

  finish() {
    this.state = "over";
    this.release();
    if (!this.ended) this.reporter.end(this.right, this.asked.length);
    this.ended = true;
    this.remake();
    this.lesson.announce(this.lesson.say("score", this.right, this.asked.length));
    this.focus(".score");
  }

  overPage() {
    const { lesson, asked } = this;
    const items = asked.map((question) => {
      const right = this.answered.get(question.id) === true;
      const words = question.kind === "drag" ? undefined : lesson.pick(question.words);
      return make(
        "li",
        { class: right ? "right" : "wrong" },
        icon(right ? "right" : "wrong"),
        unseen(lesson.say(right ? "rightAnswer" : "wrongAnswer")),
        make("span", { lang: words?.language, dir: "auto" }, words?.words ?? this.briefPrompt(question)),
      );
    });
    const again = this.repeats
      ? make("button", { type: "button", class: "plain-button", click: () => this.again() }, lesson.say("again"))
      : "";
    return [
      make("p", { class: "score", tabindex: "-1" }, lesson.say("score", this.right, asked.length)),
      make("ol", { class: "results" }, ...items),
      again,
    ];
  }

  /** @param {QuestionFacts} question */
  briefPrompt(question) {
    return new questionKinds[question.kind](this.lesson, this.stage, question, () => {}).prompt();
  }

  again() {
    this.answered.clear();
    this.question = undefined;
    this.state = "ready";
    this.remake();
    if (this.questions.length === this.asked.length) this.begin();
    else this.focus("select");
  }

  /** Gives the scene back to the reader. */
  release() {
    const { lesson, stage } = this;
    lesson.asking = false;
    stage.askedLabels = undefined;
    stage.cameraHeld = false;
    stage.lookHeld = false;
    lesson.choose([]);
    lesson.tell({ type: "quiz" });
  }

  /** The reader leaves the quiz for the scene. */
  pause() {
    if (this.lesson.asking) this.release();
  }

  /** And comes back to it. */
  proceed() {
    if (this.lesson.asking || !this.question) return;
    if (this.state === "asking") this.ask();
    else if (this.state === "told") {
      this.lesson.asking = true;
      this.lesson.choose(this.question.facts.structures);
      this.lesson.tell({ type: "quiz" });
    }
  }

  /** Focuses the first that is there. @param {...string} selectors */
  focus(...selectors) {
    const targets = selectors.map((selector) => this.element.querySelector(selector));
    const target = targets.find((one) => one instanceof HTMLElement);
    if (target instanceof HTMLElement) target.focus();
  }
}
