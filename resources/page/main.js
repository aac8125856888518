// SPDX-License-Identifier: Apache-2.0
// Puts the page together and starts it. The entry (start.js) says with which engine and reporters.

import { About } from "./about.js";
import { Card } from "./card.js";
import { iconButton, inTwoLines, make } from "./elements.js";
import { Flight } from "./flight.js";
import { Gestures } from "./gestures.js";
import { Lesson } from "./lesson.js";
import { Links } from "./links.js";
import { Panels } from "./panels.js";
import { PrintedPage } from "./print.js";
import { Quiz } from "./quiz.js";
import { Stage } from "./stage.js";
import { textIn, tongues } from "./texts.js";
import { Toolbar } from "./toolbar.js";
import { Tour } from "./tour.js";
import { StructureTree, directed } from "./tree.js";
import { PageError, readFacts, unpacked } from "./unpacking.js";
import { directionOf, firstOf, languageName } from "./words.js";

/** @import { Engine, StartEngine } from "./engine.d.ts" */
/** @import { Facts } from "./facts.d.ts" */
/** @import { PanelName } from "./panels.js" */
/** @import { CreateReporter } from "./reporter.d.ts" */

/** @typedef {{startEngine: StartEngine, createReporter: CreateReporter}} PageParts what a page is given from outside */

class Page {
  /** @param {Facts} facts @param {PageParts} parts */
  constructor(facts, { startEngine, createReporter }) {
    this.startEngine = startEngine;
    const lesson = new Lesson(facts);
    this.lesson = lesson;
    this.stage = new Stage(lesson);
    this.flight = new Flight(this.stage);
    this.links = new Links(lesson, (view, atOnce) => this.flight.goTo(view, atOnce));
    this.about = new About(lesson);
    this.tree = new StructureTree(lesson, this.stage);
    this.tour = new Tour(lesson, this.flight, this.links);
    this.quiz = new Quiz(lesson, this.stage, this.flight, createReporter);
    this.panels = new Panels(lesson, this.panelList());
    this.card = new Card(lesson, this.stage, this.links);
    this.toolbar = new Toolbar(lesson, this.stage);
    this.status = make("p", { class: "status", role: "status" });
    this.head = make("header", { class: "head" });
    this.gestures = new Gestures(this.stage, {
      clicked: (structure) => this.clicked(structure),
      twice: (structure) => this.twice(structure),
    });
    lesson.hear("language", () => this.speak());
    lesson.hear("panels", ({ open }) => this.panelsChanged(open));
    lesson.hear("lost", () => this.tellLost());
    document.addEventListener("keydown", (event) => {
      if (this.key(event)) event.preventDefault();
    });
  }

  /** @returns {{name: PanelName, inside: HTMLElement, icon: "list" | "book" | "quiz"}[]} */
  panelList() {
    const { lesson } = this;
    /** @type {{name: PanelName, inside: HTMLElement, icon: "list" | "book" | "quiz"}[]} */
    const panels = [];
    if (!lesson.nameless) panels.push({ name: "structures", inside: this.tree.element, icon: "list" });
    if (lesson.facts.views.length && !lesson.nameless)
      panels.push({ name: "tour", inside: this.tour.element, icon: "book" });
    if (this.quiz.questions.length) panels.push({ name: "quiz", inside: this.quiz.element, icon: "quiz" });
    return panels;
  }

  /** Shows the page around the picture that is still to come. */
  build() {
    const app = document.getElementById("app");
    const stills = document.getElementById("stills");
    if (!app || !stills) throw new PageError("spoiled");
    const printed = new PrintedPage(this.lesson, this.stage, this.links);
    const structures = this.panels.parts.find((part) => part.name === "structures");
    // The card is of the structures' column where there is one.
    app.replaceChildren(
      make("a", { class: "skip", href: "#stage", click: (event) => this.skip(event) }, this.lesson.say("skip")),
      make("div", { class: "top" }, this.head, this.panels.nav),
      make("main", { class: "plate" }, this.stage.element, this.status, this.toolbar.element),
      make("div", { class: "side" }, structures?.section, this.card.element),
      ...this.panels.parts.filter((part) => part !== structures).map((part) => part.section),
      make("div", { id: "live", class: "unseen", "aria-live": "polite" }),
      this.about.element,
    );
    document.body.append(printed.element);
    const first = stills.querySelector("img");
    if (first) this.stage.element.append(make("img", { class: "first-picture", alt: "", src: first.src }));
    stills.hidden = true;
    app.hidden = false;
    document.body.classList.add("drawn");
    document.body.classList.toggle("nameless", this.lesson.nameless);
    this.speak();
    this.openPanels();
  }

  openPanels() {
    const { panels, lesson } = this;
    if (panels.wide.matches) panels.openPanel("structures");
    if (lesson.nameless) panels.openPanel("quiz");
    else if (panels.has("tour")) panels.openPanel("tour");
    else panels.show();
  }

  /** @param {Event} event */
  skip(event) {
    event.preventDefault();
    this.stage.element.focus();
  }

  speak() {
    const { lesson } = this;
    document.documentElement.lang = lesson.tongue;
    document.documentElement.dir = directionOf(lesson.tongue);
    document.title = lesson.facts.title;
    const language = make(
      "select",
      { class: "language", "aria-label": lesson.say("language"), change: () => lesson.speak(language.value) },
      ...lesson.languages.map((tag) =>
        make("option", { value: tag, lang: tag, selected: tag === lesson.language }, languageName(tag)),
      ),
    );
    const held = this.head.querySelector("select") === document.activeElement;
    this.head.replaceChildren(
      inTwoLines(make("h1", { dir: "auto" }, lesson.facts.title)),
      make(
        "div",
        { class: "head-tools" },
        lesson.languages.length > 1 ? language : null,
        iconButton("about", lesson.say("about"), () => this.about.open()),
      ),
    );
    if (held) language.focus();
  }

  /** @param {ReadonlySet<PanelName>} open */
  panelsChanged(open) {
    if (open.has("quiz")) this.quiz.proceed();
    else this.quiz.pause();
    this.lesson.announce("");
  }

  /** @param {number} structure 0 for none */
  clicked(structure) {
    const { lesson } = this;
    if (lesson.asking) this.quiz.clicked(structure);
    else if (!lesson.nameless) lesson.choose(structure ? [structure] : []);
    if (structure && !lesson.asking && !lesson.nameless) lesson.announce(lesson.nameOf(structure));
  }

  /** @param {number} structure 0 for none */
  twice(structure) {
    if (!this.lesson.asking) this.stage.fit(structure ? [structure] : []);
  }

  /** @param {KeyboardEvent} event @returns {boolean} whether the key meant something */
  key(event) {
    const { target, key } = event;
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey || this.about.element.open)
      return false;
    const { lesson, stage } = this;
    if (target instanceof Element && target.matches("input:not([type=range]), select, textarea")) return false;
    if (key === "PageDown" || key === "PageUp") return this.tour.go(key === "PageDown" ? 1 : -1);
    if (key === "/" && this.panels.has("structures") && !lesson.asking) {
      this.panels.openPanel("structures");
      this.tree.filter.focus();
    } else if ((key === "[" || key === "]") && lesson.chosen.length) {
      const gamma = stage.gammaOf(lesson.chosen[0]);
      stage.setGamma(lesson.chosen, gamma + (key === "[" ? -0.25 : 0.25));
    } else if (key === "Escape" && !lesson.asking) lesson.choose([]);
    else return this.tourKey(target, directed(key));
    return true;
  }

  /** Arrows lead through the tour from everywhere but the picture, lists and sliders. @param {EventTarget | null} target @param {string} key */
  tourKey(target, key) {
    if (key !== "ArrowLeft" && key !== "ArrowRight") return false;
    const taken = target instanceof Element && target.closest(".stage, .tree, input, #quiz");
    if (taken || !this.panels.open.has("tour")) return false;
    return this.tour.go(key === "ArrowRight" ? 1 : -1);
  }

  /** Unpacks and draws: first what is in focus, then what surrounds it. */
  async open() {
    const { lesson, stage } = this;
    this.status.textContent = lesson.say("opening");
    if (typeof WebAssembly === "undefined") throw new PageError("noProgram");
    // The page is shown before the browser is busy with unpacking.
    await new Promise((shown) => requestAnimationFrame(() => window.setTimeout(shown)));
    const [program, scene] = await Promise.all([unpacked("program"), unpacked("scene")]);
    if (!program || !scene) throw new PageError("spoiled");
    const engine = await this.startEngine({ program, canvas: stage.canvas, overlay: stage.overlay });
    engine.load(scene);
    stage.begin(engine);
    stage.element.querySelector(".first-picture")?.remove();
    lesson.tell({ type: "look" });
    this.links.follow(location.hash);
    await this.addContext(engine);
    this.status.textContent = engine.means === "canvas" ? lesson.say("plain") : "";
    if (this.status.textContent) window.setTimeout(() => (this.status.textContent = ""), 4000);
    document.body.classList.add("complete");
  }

  /** @param {Engine} engine */
  async addContext(engine) {
    if (!document.getElementById("scene-context")) {
      this.status.textContent = "";
      return;
    }
    this.status.textContent = this.lesson.say("context");
    try {
      const context = await unpacked("scene-context");
      if (context) engine.addContext(context);
      this.stage.redraw();
      this.lesson.tell({ type: "look" });
    } catch (error) {
      const reason = error instanceof PageError ? this.lesson.say(error.key, ...error.parts) : String(error);
      throw new Error(this.lesson.say("contextFailed", reason));
    }
  }

  tellLost() {
    const { lesson } = this;
    this.status.replaceChildren(
      lesson.say("lost"),
      " ",
      make("button", { type: "button", class: "quiet-button", click: () => location.reload() }, lesson.say("reload")),
    );
  }

  /** Shows still pictures and why. @param {unknown} error */
  showStills(error) {
    const { lesson } = this;
    const reason =
      error instanceof PageError
        ? lesson.say(error.key, ...error.parts)
        : error instanceof Error
          ? error.message
          : String(error);
    if (document.getElementById("app")?.querySelector(".first-picture") === null && this.stage.engine) {
      this.status.textContent = reason;
      return;
    }
    showStills(lesson.say("cannotDraw"), reason);
  }
}

/** @param {string} what @param {string} why */
function showStills(what, why) {
  const app = document.getElementById("app");
  const stills = document.getElementById("stills");
  document.body.classList.remove("drawn");
  if (app) app.hidden = true;
  if (!stills) return;
  stills.hidden = false;
  stills
    .querySelector("h1")
    ?.after(make("p", { class: "notice", role: "alert" }, what, make("span", { class: "reason" }, ` ${why}`)));
}

/** Starts the page; what it cannot do it says. @param {PageParts} parts */
export async function startPage(parts) {
  /** @type {Page | undefined} */
  let page;
  try {
    page = new Page(readFacts(), parts);
    page.build();
    await page.open();
  } catch (error) {
    if (page) page.showStills(error);
    else {
      const tongue = firstOf(navigator.languages, tongues) ?? "en";
      const known = error instanceof PageError ? error : new PageError("spoiled");
      showStills(textIn(tongue, "cannotDraw", []), textIn(tongue, known.key, known.parts));
    }
  }
}
