// SPDX-License-Identifier: Apache-2.0
// Holds what the page's parts share: facts, languages, what is chosen, which view it is; and hands on
// what they tell one another (events.d.ts).

import { make } from "./elements.js";
import { textIn, tongues } from "./texts.js";
import { firstOf, plainLines, wordsIn } from "./words.js";

/** @import { Placed } from "./engine.d.ts" */
/** @import { PageEvent, PageEventOf, PageEventType } from "./events.d.ts" */
/** @import { Facts, NodeFacts, Words } from "./facts.d.ts" */

/** @typedef {"names" | "numbers" | "none"} LabelChoice */

export class Lesson {
  /** @param {Facts} facts */
  constructor(facts) {
    this.facts = facts;
    this.events = new EventTarget();
    /** @type {Map<number, NodeFacts>} */
    this.nodes = new Map(facts.nodes.map((node) => [node.id, node]));
    /** @type {Map<number, NodeFacts[]>} */
    this.children = new Map();
    for (const node of facts.nodes) {
      const siblings = this.children.get(node.parent);
      if (siblings) siblings.push(node);
      else this.children.set(node.parent, [node]);
    }
    const languages = facts.languages.length ? facts.languages : [facts.language];
    /** Of names and texts: at first the one that the teacher chose. */
    this.language = languages.includes(facts.language) ? facts.language : languages[0];
    /** Of the page's own texts: the same where they are in it. */
    this.tongue = firstOf([this.language, ...navigator.languages], tongues) ?? "en";
    this.languages = languages;
    /** @type {number[]} structures and groups */
    this.chosen = [];
    /** The view's number; 0 before the first. */
    this.view = 0;
    /** @type {LabelChoice} */
    this.labels = "names";
    /** @type {Placed[]} where labels stand in the newest picture */
    this.placed = [];
    /** A question is being asked: names are covered. */
    this.asking = false;
    /** No name is anywhere in the page. */
    this.nameless = facts.quiz.mode === "only";
  }

  /** @param {PageEvent} event */
  tell(event) {
    this.events.dispatchEvent(new CustomEvent(event.type, { detail: event }));
  }

  /**
   * @template {PageEventType} Type
   * @param {Type | Type[]} types
   * @param {(event: PageEventOf<Type>) => void} act
   */
  hear(types, act) {
    /** @param {Event} event */
    const heard = (event) => act(/** @type {CustomEvent<PageEventOf<Type>>} */ (event).detail);
    for (const type of [types].flat()) this.events.addEventListener(type, heard);
  }

  /** @param {string} key of the table of texts @param {...(string | number)} parts */
  say(key, ...parts) {
    return textIn(this.tongue, key, parts);
  }

  /** @param {string} language */
  speak(language) {
    this.language = language;
    this.tongue = firstOf([language], tongues) ?? this.tongue;
    this.tell({ type: "language" });
  }

  /** Languages in order of preference. */
  preferred() {
    return [this.language, this.facts.language, "en", "la"];
  }

  /**
   * @template T
   * @param {{[language: string]: T} | undefined} words
   */
  pick(words) {
    return wordsIn(words, this.preferred());
  }

  /** The name of a node, or what stands for it where names are withheld. @param {number} id */
  nameOf(id) {
    const place = 1 + this.facts.nodes.findIndex((node) => node.id === id);
    return this.pick(this.nodes.get(id)?.names)?.words ?? this.say("structureN", place);
  }

  /** Words as an element that says of which language they are. @param {Words | undefined} words */
  wordsElement(words, tag = /** @type {"span" | "h2" | "em" | "strong"} */ ("span")) {
    const found = this.pick(words);
    return make(tag, { lang: found?.language, dir: "auto" }, found?.words);
  }

  /** @param {number} id */
  nameElement(id) {
    const names = this.nodes.get(id)?.names;
    return this.pick(names) ? this.wordsElement(names) : make("span", {}, this.nameOf(id));
  }

  /** The structures that are a node or lie in it. @param {number} id @returns {number[]} */
  structuresIn(id) {
    if (!this.nodes.get(id)?.group) return this.nodes.has(id) ? [id] : [];
    return (this.children.get(id) ?? []).flatMap((node) => this.structuresIn(node.id));
  }

  /** @param {number[]} ids */
  allStructuresIn(ids) {
    return [...new Set(ids.flatMap((id) => this.structuresIn(id)))];
  }

  /** Groups that hold the node, the nearest first. @param {number} id */
  groupsOf(id) {
    const groups = [];
    for (let node = this.nodes.get(id); node && node.parent && groups.length < 100; node = this.nodes.get(node.parent))
      groups.push(node.parent);
    return groups;
  }

  /** @param {number[]} ids */
  choose(ids) {
    const known = ids.filter((id) => this.nodes.has(id));
    if (known.join() === this.chosen.join()) return;
    this.chosen = known;
    this.tell({ type: "chosen" });
  }

  /** Texts of labels as the engine wants them. */
  labelTexts() {
    /** @type {{[id: number]: string[]}} */
    const texts = {};
    for (const label of this.facts.labels) {
      const words = this.pick(label.words)?.words;
      texts[label.id] = words ? plainLines(words) : label.structures.map((id) => this.nameOf(id));
    }
    return texts;
  }

  /** @param {string} words for who listens to the page */
  announce(words) {
    const live = document.getElementById("live");
    if (live) live.textContent = words;
  }
}
