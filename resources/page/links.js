// SPDX-License-Identifier: Apache-2.0
// Links into the page: #view=3, #structure=left-ureter, #structure=12, #language=de, joined by &.

import { linkName, normalised, wordsIn } from "./words.js";

/** @import { Lesson } from "./lesson.js" */

export class Links {
  /** @param {Lesson} lesson @param {(view: number, atOnce: boolean) => void} goTo */
  constructor(lesson, goTo) {
    this.lesson = lesson;
    this.goTo = goTo;
    window.addEventListener("hashchange", () => this.follow(location.hash, false));
    lesson.hear(["view", "chosen"], () => this.keep());
  }

  /** @param {number} id @returns {string | undefined} */
  toStructure(id) {
    const node = this.lesson.nodes.get(id);
    if (!node) return undefined;
    const name = linkName(wordsIn(node.names, ["en", this.lesson.facts.language])?.words ?? "");
    const known = name && this.structureOf(name) === id;
    return `#structure=${known && !this.lesson.nameless ? encodeURIComponent(name) : id}`;
  }

  /** @param {number} view @returns {string | undefined} */
  toView(view) {
    return this.lesson.facts.views[view - 1] ? `#view=${view}` : undefined;
  }

  /** The structure of that name in any language, or of that id. @param {string} words @returns {number | undefined} */
  structureOf(words) {
    const { lesson } = this;
    if (/^\d+$/.test(words) && lesson.nodes.has(Number(words))) return Number(words);
    const wanted = normalised(words);
    if (!wanted) return undefined;
    return lesson.facts.nodes.find((node) => Object.values(node.names).some((name) => normalised(name) === wanted))?.id;
  }

  /** @param {string} hash @returns {boolean} whether it led anywhere */
  follow(hash, atOnce = true) {
    const wanted = new URLSearchParams(hash.replace(/^#/, ""));
    const language = wanted.get("language");
    if (language && this.lesson.languages.includes(language) && language !== this.lesson.language)
      this.lesson.speak(language);
    if (this.lesson.asking) return false;
    const view = Number(wanted.get("view"));
    const goes = Number.isInteger(view) && view > 0 && view <= this.lesson.facts.views.length;
    if (goes && view !== this.lesson.view) this.goTo(view, atOnce);
    const structures = (wanted.get("structure") ?? "")
      .split(",")
      .map((words) => this.structureOf(words))
      .filter((id) => id !== undefined);
    if (structures.length) this.lesson.choose(structures);
    return goes || structures.length > 0;
  }

  /** A click on a link in a text. @param {Event} event @param {string} link */
  followed(event, link) {
    event.preventDefault();
    // Once more to the same view is a wish to see it as it was.
    const view = /^#view=(\d+)$/.exec(link);
    if (view) this.goTo(Number(view[1]), false);
    else this.follow(link, false);
  }

  /** Keeps the address at what is shown, so that it can be sent to others. */
  keep() {
    const { lesson } = this;
    if (lesson.asking) return;
    const parts = [];
    if (lesson.view) parts.push(`view=${lesson.view}`);
    const structures = lesson.chosen.flatMap((id) => this.toStructure(id)?.slice("#structure=".length) ?? []);
    if (structures.length && !lesson.nameless) parts.push(`structure=${structures.join(",")}`);
    try {
      history.replaceState(null, "", parts.length ? `#${parts.join("&")}` : location.pathname + location.search);
    } catch {
      // A page within another one may not change its address; nothing else depends on it.
    }
  }
}
