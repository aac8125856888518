// SPDX-License-Identifier: Apache-2.0
// Which panels are open: where there is room the structures stand beside tour or quiz, on a telephone
// one panel is open at a time.

import { icon, make } from "./elements.js";

/** @import { Lesson } from "./lesson.js" */

/** @typedef {"structures" | "tour" | "quiz"} PanelName */

export class Panels {
  /**
   * @param {Lesson} lesson
   * @param {{name: PanelName, inside: HTMLElement, icon: "list" | "book" | "quiz"}[]} panels
   */
  constructor(lesson, panels) {
    this.lesson = lesson;
    this.wide = matchMedia("(min-width: 68rem)");
    /** @type {Set<PanelName>} */
    this.open = new Set();
    this.nav = make("nav", { class: "panel-nav" });
    this.parts = panels.map(({ name, inside, icon: drawing }) => {
      const words = make("span", {});
      const button = make(
        "button",
        { type: "button", "aria-controls": name, class: "panel-button", click: () => this.toggle(name) },
        icon(drawing),
        words,
      );
      const title = make("h2", { class: "unseen" });
      const section = make("section", { id: name, class: `panel ${name}` }, title, inside);
      this.nav.append(button);
      return { name, words, button, title, section };
    });
    this.wide.addEventListener("change", () => this.fit());
    lesson.hear("language", () => this.name());
    this.name();
  }

  name() {
    this.nav.setAttribute("aria-label", this.lesson.say("panels"));
    for (const part of this.parts) {
      part.words.textContent = this.lesson.say(part.name);
      part.title.textContent = this.lesson.say(part.name);
      part.section.setAttribute("aria-label", this.lesson.say(part.name));
    }
  }

  /** @param {PanelName} name */
  has(name) {
    return this.parts.some((part) => part.name === name);
  }

  /** @param {PanelName} name */
  toggle(name) {
    if (this.open.has(name)) this.open.delete(name);
    else this.openPanel(name);
    this.show();
  }

  /** @param {PanelName} name */
  openPanel(name) {
    if (!this.has(name)) return;
    const beside = this.wide.matches && name === "structures" ? ["structures", "tour"] : [name];
    const kept = this.wide.matches && name === "tour" ? ["structures", "tour"] : beside;
    for (const other of [...this.open]) if (!kept.includes(other)) this.open.delete(other);
    this.open.add(name);
    this.show();
  }

  /** What has no room beside another is closed. */
  fit() {
    if (!this.wide.matches && this.open.size > 1) this.open.delete("structures");
    this.show();
  }

  show() {
    for (const { name, button, section } of this.parts) {
      const open = this.open.has(name);
      button.setAttribute("aria-expanded", String(open));
      section.hidden = !open;
      document.body.classList.toggle(`with-${name}`, open);
    }
    this.lesson.tell({ type: "panels", open: this.open });
  }
}
