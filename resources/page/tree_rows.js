// SPDX-License-Identifier: Apache-2.0
// One row of the tree: a structure or a group with eye, name and Γ.

import { gammaSlider, showGamma } from "./card.js";
import { icon, make, unseen } from "./elements.js";

/** @import { NodeFacts } from "./facts.d.ts" */
/** @import { Lesson } from "./lesson.js" */
/** @import { Stage } from "./stage.js" */

export class TreeRow {
  /**
   * @param {Lesson} lesson
   * @param {Stage} stage
   * @param {NodeFacts} node
   */
  constructor(lesson, stage, node) {
    this.lesson = lesson;
    this.stage = stage;
    this.node = node;
    this.open = true;
    this.share = -1;
    this.level = 1 + lesson.groupsOf(node.id).length;
    const name = lesson.nameOf(node.id);
    this.name = make("span", { class: "row-name" }, lesson.nameElement(node.id));
    this.state = unseen("");
    this.number = make("span", { class: "row-number" });
    // Keys do on the row what these do, so that there is one stop of Tab for the tree.
    this.fold = node.group
      ? make(
          "button",
          { type: "button", class: "fold", tabindex: "-1", "aria-label": lesson.say("unfold", name) },
          icon("open"),
        )
      : make("span", { class: "fold" });
    this.eye = make("button", {
      type: "button",
      class: "eye",
      tabindex: "-1",
      "aria-label": lesson.say("show", name),
      click: () => this.toggle(),
    });
    this.slider = gammaSlider(
      lesson,
      lesson.say("gammaOf", name),
      (gamma, moving) => stage.setGamma([node.id], gamma, moving),
      { tabindex: "-1" },
    );
    const swatch = make("span", { class: "swatch", "aria-hidden": "true" });
    swatch.style.setProperty("background-color", node.colour);
    this.line = make(
      "div",
      { class: "row" },
      this.fold,
      this.eye,
      make("span", { class: "row-label", id: `row-${node.id}` }, swatch, this.name, this.number, this.state),
      this.slider,
    );
    this.line.style.setProperty("--level", String(this.level - 1));
    this.inside = node.group ? make("ul", { role: "group" }) : undefined;
    this.element = make(
      "li",
      {
        role: "treeitem",
        tabindex: "-1",
        "aria-level": this.level,
        "aria-labelledby": `row-${node.id}`,
        "data-id": node.id,
        class: node.group ? "group" : "structure",
      },
      this.line,
      this.inside,
    );
    if (node.group) this.setOpen(true);
  }

  /** @param {boolean} open */
  setOpen(open) {
    this.open = open;
    this.element.setAttribute("aria-expanded", String(open));
    if (this.inside) this.inside.hidden = !open;
  }

  toggle() {
    this.stage.setVisible([this.node.id], this.stage.shownShare(this.node.id) === 0);
  }

  /** @param {number} step */
  addGamma(step) {
    this.stage.setGamma([this.node.id], this.stage.gammaOf(this.node.id) + step);
  }

  /** @param {boolean} chosen */
  showChosen(chosen) {
    this.element.setAttribute("aria-selected", String(chosen));
  }

  showLook() {
    const share = this.stage.shownShare(this.node.id);
    const state = share === 1 ? "" : this.lesson.say(share === 0 ? "hidden" : "partly");
    if (share !== this.share) {
      this.share = share;
      this.line.classList.toggle("not-shown", share === 0);
      this.line.classList.toggle("partly-shown", share > 0 && share < 1);
      this.eye.setAttribute("aria-pressed", share === 1 ? "true" : share === 0 ? "false" : "mixed");
      this.eye.replaceChildren(icon(share === 0 ? "closed" : "eye"));
      this.state.textContent = state && `, ${state}`;
    }
    if (!this.slider.matches(":active")) showGamma(this.lesson, this.slider, this.stage.gammaOf(this.node.id));
  }

  /** @param {number} number of its label; 0 for none */
  showNumber(number) {
    const words = number ? String(number) : "";
    if (this.number.textContent !== words) this.number.textContent = words;
  }
}
