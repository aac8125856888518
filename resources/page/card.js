// SPDX-License-Identifier: Apache-2.0
// The card of what is chosen: name, note and how much of it is drawn.

import { icon, iconButton, inTwoLines, make } from "./elements.js";
import { linesElement } from "./lines.js";

/** @import { Lesson } from "./lesson.js" */
/** @import { Links } from "./links.js" */
/** @import { Stage } from "./stage.js" */

/**
 * A slider for Γ, from 0 (silhouette) to 5 (surface).
 * @param {Lesson} lesson
 * @param {string} label
 * @param {(gamma: number, moving: boolean) => void} act
 * @param {{[name: string]: string}} [traits]
 */
export function gammaSlider(lesson, label, act, traits = {}) {
  const slider = make("input", {
    type: "range",
    min: 0,
    max: 5,
    step: 0.05,
    class: "gamma",
    "aria-label": label,
    ...traits,
  });
  slider.addEventListener("input", () => {
    showGamma(lesson, slider, Number(slider.value));
    act(Number(slider.value), true);
  });
  slider.addEventListener("change", () => act(Number(slider.value), false));
  return slider;
}

/** @param {Lesson} lesson @param {HTMLInputElement} slider @param {number} gamma */
export function showGamma(lesson, slider, gamma) {
  slider.value = String(gamma);
  slider.style.setProperty("--share", `${(gamma / 5) * 100}%`);
  const words = `${gamma.toFixed(1)}, ${lesson.say("stage" + Math.round(gamma))}`;
  slider.setAttribute("aria-valuetext", words);
  slider.title = words;
}

export class Card {
  /** @param {Lesson} lesson @param {Stage} stage @param {Links} links */
  constructor(lesson, stage, links) {
    this.lesson = lesson;
    this.stage = stage;
    this.links = links;
    this.element = make("section", { class: "card", id: "card", hidden: true });
    lesson.hear(["chosen", "language", "quiz"], () => this.remake());
    lesson.hear("look", () => this.showLook());
  }

  remake() {
    const { lesson, stage } = this;
    const ids = lesson.chosen;
    this.slider = undefined;
    this.element.hidden = ids.length === 0 || lesson.asking || lesson.nameless;
    if (this.element.hidden) {
      this.element.replaceChildren();
      return;
    }
    this.element.setAttribute("aria-label", lesson.say("chosen"));
    this.eye = iconButton("eye", lesson.say("hide"), () => stage.setVisible(ids, !this.anyShown()));
    this.slider = gammaSlider(lesson, lesson.say("gamma"), (gamma, moving) => stage.setGamma(ids, gamma, moving));
    this.stageName = make("output", { class: "stage-name" });
    this.element.replaceChildren(
      make(
        "header",
        { class: "card-head" },
        this.names(),
        make(
          "div",
          { class: "card-tools" },
          this.eye,
          iconButton("alone", lesson.say("alone"), () => stage.isolate(ids)),
          iconButton("fit", lesson.say("zoomTo"), () => stage.fit(ids)),
          iconButton("reset", lesson.say("resetLook"), () => stage.dress((engine) => engine.resetLook())),
          iconButton("close", lesson.say("close"), () => lesson.choose([])),
        ),
      ),
      make(
        "div",
        { class: "gamma-row" },
        make("span", { class: "gamma-sign", "aria-hidden": "true" }, "Γ"),
        this.slider,
        this.stageName,
      ),
      this.note() ?? "",
    );
    this.showLook();
  }

  names() {
    const { lesson } = this;
    if (lesson.chosen.length !== 1) return make("h2", {}, lesson.say("several", lesson.chosen.length));
    const names = lesson.nodes.get(lesson.chosen[0])?.names;
    const shown = lesson.pick(names);
    const latin =
      names?.la && names.la !== shown?.words ? make("p", { class: "latin", lang: "la", dir: "ltr" }, names.la) : null;
    const title = lesson.wordsElement(names, "h2");
    if (!shown) title.textContent = lesson.nameOf(lesson.chosen[0]);
    return make("div", { class: "card-names" }, inTwoLines(title), latin);
  }

  note() {
    const { lesson } = this;
    const id = lesson.chosen[0];
    const said = lesson.facts.labels
      .filter((label) => label.kind !== "label" && label.structures.includes(id))
      .map((label) => lesson.pick(label.words));
    const notes = lesson.chosen.length === 1 ? [lesson.pick(lesson.nodes.get(id)?.note), ...said] : [];
    const there = notes.flatMap((note) =>
      note && note.words.length ? [linesElement(note.words, note.language, this.links)] : [],
    );
    return there.length ? make("div", { class: "note" }, ...there) : null;
  }

  anyShown() {
    return this.lesson.chosen.some((id) => this.stage.shownShare(id) > 0);
  }

  showLook() {
    if (!this.slider) return;
    const { lesson, stage } = this;
    const gammas = lesson.chosen.map((id) => stage.gammaOf(id));
    const mean = gammas.reduce((sum, gamma) => sum + gamma, 0) / gammas.length;
    // A slider that is being dragged knows better than a mean.
    if (!this.slider.matches(":active")) showGamma(lesson, this.slider, mean);
    if (this.stageName) this.stageName.textContent = lesson.say("stage" + Math.round(mean));
    this.eye?.setAttribute("aria-pressed", String(this.anyShown()));
    this.eye?.replaceChildren(icon(this.anyShown() ? "eye" : "closed"));
  }
}
