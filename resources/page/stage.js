// SPDX-License-Identifier: Apache-2.0
// The picture: canvas and labels over it, drawn when something has changed, and what is done to it.

import { make } from "./elements.js";

/** @import { Direction, Engine, LabelMode } from "./engine.d.ts" */
/** @import { Lesson } from "./lesson.js" */

/** The names of the anatomical views, with their keys. @type {[Direction, string][]} */
export const directions = [
  ["anterior", "A"],
  ["posterior", "P"],
  ["left", "L"],
  ["right", "R"],
  ["superior", "S"],
  ["inferior", "I"],
];

/** Milliseconds without a move after which everything is drawn. */
const restAfter = 140;

export class Stage {
  /** @param {Lesson} lesson */
  constructor(lesson) {
    this.lesson = lesson;
    /** @type {Engine | undefined} */
    this.engine = undefined;
    this.canvas = make("canvas", { "aria-hidden": "true" });
    this.overlay = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    this.overlay.setAttribute("class", "overlay");
    this.overlay.setAttribute("aria-hidden", "true");
    this.words = make("p", { id: "scene-words", class: "unseen" });
    this.hint = make("div", { class: "hint", hidden: true });
    this.element = make(
      "div",
      { class: "stage", id: "stage", tabindex: "0", role: "application", "aria-describedby": "scene-words" },
      this.canvas,
      this.overlay,
      this.words,
      this.hint,
    );
    /** A quiz may hold the camera or the look. */
    this.cameraHeld = false;
    this.lookHeld = false;
    /** @type {LabelMode | undefined} what a question shows in place of what the reader chose */
    this.askedLabels = undefined;
    /** The size that the engine was given. */
    this.size = { width: 0, height: 0, ratio: 0 };
    this.frame = 0;
    this.rest = 0;
    this.moving = false;
    this.left = false;
    this.canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      lesson.tell({ type: "lost" });
    });
    lesson.hear(["chosen", "quiz"], () => this.showChosen());
    lesson.hear(["labels", "language", "quiz"], () => this.showLabels());
    lesson.hear("grab", () => this.leave(true));
    lesson.hear("view", () => this.leave(false));
    lesson.hear(["language", "chosen"], () => this.describe());
    this.describe();
  }

  /** @param {Engine} engine that has a scene */
  begin(engine) {
    this.engine = engine;
    this.canvas = engine.canvas;
    this.showLabels();
    this.showChosen();
    this.fill();
    new ResizeObserver(() => this.fill()).observe(this.element);
  }

  /** Gives the picture the size of its place. */
  fill() {
    const { clientWidth: width, clientHeight: height } = this.element;
    const ratio = Math.min(window.devicePixelRatio || 1, 3);
    const same = width === this.size.width && height === this.size.height && ratio === this.size.ratio;
    if (!this.engine || width < 2 || height < 2 || same) return;
    this.size = { width, height, ratio };
    this.overlay.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.engine.size(width, height, ratio);
    // At once, as a canvas of another size is empty until then.
    this.drawNow();
  }

  /** Draws as many pixels as paper shows, lets `take` have them, and goes back. @param {() => void} take */
  drawFine(take) {
    // What is printed may have no room on the screen any more.
    const { width, height, ratio } = this.size;
    this.engine?.size(width, height, Math.max(ratio, Math.min(3, 4096 / Math.max(width, height))));
    this.drawNow();
    take();
    this.engine?.size(width, height, ratio);
    this.drawNow();
  }

  /** The view that is described is the one seen, or no longer quite. @param {boolean} left */
  leave(left) {
    this.left = left;
    this.describe();
  }

  describe() {
    const { lesson } = this;
    // The page opens with what the first view shows.
    const view = lesson.facts.views[Math.max(lesson.view, 1) - 1];
    const alt = lesson.pick(view?.alt) ?? lesson.pick(lesson.facts.alt);
    const words = lesson.asking || lesson.nameless ? "" : (alt?.words ?? "");
    this.words.textContent = words && this.left ? lesson.say("moved", words) : words;
    this.words.lang = alt?.language ?? "";
    this.element.setAttribute("aria-label", lesson.facts.title || lesson.say("drawing"));
    this.element.setAttribute("aria-roledescription", lesson.say("drawing"));
  }

  /** Asks for a picture before the browser next shows the page. */
  redraw(moving = false) {
    this.moving = moving;
    window.clearTimeout(this.rest);
    if (moving) this.rest = window.setTimeout(() => this.redraw(), restAfter);
    if (!this.frame) this.frame = requestAnimationFrame(() => this.drawNow());
  }

  drawNow() {
    if (this.frame) cancelAnimationFrame(this.frame);
    this.frame = 0;
    if (!this.engine) return;
    try {
      const drawn = this.engine.draw(this.moving);
      this.lesson.placed = drawn.labels;
      if (!drawn.complete && !this.moving) this.redraw();
      this.lesson.tell({ type: "drawn" });
    } catch {
      // Out of memory, most likely; what follows would fail as well.
      this.engine = undefined;
      this.lesson.tell({ type: "lost" });
    }
  }

  /** Does something to the camera unless it is held. @param {(engine: Engine) => void} act */
  move(act, moving = true) {
    if (!this.engine || this.cameraHeld) return;
    this.lesson.tell({ type: "grab" });
    act(this.engine);
    this.redraw(moving);
  }

  /** Does something to the look unless it is held. @param {(engine: Engine) => void} act */
  dress(act, moving = false) {
    if (!this.engine || this.lookHeld) return;
    this.lesson.tell({ type: "grab" });
    act(this.engine);
    this.lesson.tell({ type: "look" });
    this.redraw(moving);
  }

  showChosen() {
    this.engine?.select(this.lesson.allStructuresIn(this.lesson.chosen));
    this.redraw();
  }

  showLabels() {
    const { labels, asking, nameless } = this.lesson;
    const texts = asking ? {} : this.lesson.labelTexts();
    const { labelsFound, sideless } = this.lesson.facts;
    const chosen = this.askedLabels ?? {
      show: !asking && !nameless && labels !== "none",
      numbers: labels === "numbers",
      texts,
      seen: labelsFound,
    };
    this.engine?.labels({ ...chosen, sides: !sideless });
    this.redraw();
  }

  /** @param {number[]} ids @param {number} gamma */
  setGamma(ids, gamma, moving = false) {
    const structures = this.lesson.allStructuresIn(ids);
    this.dress((engine) => engine.setGamma(structures, Math.min(5, Math.max(0, gamma))), moving);
  }

  /** The mean Γ of what a node holds. @param {number} id */
  gammaOf(id) {
    const structures = this.lesson.structuresIn(id);
    if (!structures.length) return 0;
    const each = structures.map((structure) =>
      this.engine ? this.engine.gamma(structure) : (this.lesson.nodes.get(structure)?.gamma ?? 0),
    );
    return each.reduce((sum, gamma) => sum + gamma, 0) / structures.length;
  }

  /** @param {number[]} ids @param {boolean} visible */
  setVisible(ids, visible) {
    const structures = this.lesson.allStructuresIn(ids);
    this.dress((engine) => engine.setVisible(structures, visible));
  }

  /** How much of what a node holds is shown: 0 nothing, 1 all. @param {number} id */
  shownShare(id) {
    const structures = this.lesson.structuresIn(id);
    const shown = structures.filter((structure) =>
      this.engine ? this.engine.visible(structure) : this.lesson.nodes.get(structure)?.visible,
    );
    return structures.length ? shown.length / structures.length : 0;
  }

  /** Hides all but these. @param {number[]} ids */
  isolate(ids) {
    const wanted = new Set(this.lesson.allStructuresIn(ids));
    const others = this.lesson.facts.nodes.filter((node) => !node.group && !wanted.has(node.id));
    this.dress((engine) => {
      engine.setVisible(
        others.map((node) => node.id),
        false,
      );
      engine.setVisible([...wanted], true);
    });
  }

  /** @param {number[]} ids all when empty */
  fit(ids) {
    const structures = this.lesson.allStructuresIn(ids);
    this.move((engine) => engine.fit(structures), false);
  }

  /** @param {number} factor */
  zoomMiddle(factor) {
    this.move((engine) => engine.zoom(factor, this.element.clientWidth / 2, this.element.clientHeight / 2));
  }

  /** What is at a point of the page: a label stands for its first structure. @param {number} x @param {number} y */
  structureAt(x, y) {
    const box = this.element.getBoundingClientRect();
    const hit = this.engine?.pick(x - box.left, y - box.top) ?? { structure: 0, label: 0 };
    const label = this.lesson.facts.labels.find((one) => hit.label !== 0 && one.id === hit.label);
    return label?.structures[0] ?? hit.structure;
  }
}
