// SPDX-License-Identifier: Apache-2.0
// The tree of structures with its filter: ARIA's tree, worked by mouse, finger and keys.

import { make } from "./elements.js";
import { TreeRow } from "./tree_rows.js";
import { normalised } from "./words.js";

/** @import { Lesson } from "./lesson.js" */
/** @import { Stage } from "./stage.js" */

export class StructureTree {
  /** @param {Lesson} lesson @param {Stage} stage */
  constructor(lesson, stage) {
    this.lesson = lesson;
    this.stage = stage;
    /** @type {Map<number, TreeRow>} */
    this.rows = new Map();
    /** @type {Set<number>} groups that the reader has folded */
    this.folded = new Set();
    this.typed = "";
    this.typedAt = 0;
    this.filter = make("input", {
      type: "search",
      class: "filter",
      autocomplete: "off",
      spellcheck: "false",
      input: () => this.showFiltered(),
      keydown: (event) => this.filterKey(event),
    });
    this.none = make("p", { class: "none-found", hidden: true });
    this.list = make("ul", {
      role: "tree",
      class: "tree",
      "aria-multiselectable": "true",
      keydown: (event) => this.key(event),
      click: (event) => this.clicked(event),
    });
    this.keys = make("p", { class: "unseen", id: "tree-keys" });
    this.list.setAttribute("aria-describedby", "tree-keys");
    this.element = make("div", { class: "tree-box" }, this.filter, this.none, this.keys, this.list);
    this.remake();
    lesson.hear("language", () => this.remake());
    lesson.hear("chosen", () => this.showChosen());
    lesson.hear("look", () => this.showLook());
    lesson.hear(["drawn", "labels"], () => this.showNumbers());
  }

  remake() {
    const { lesson } = this;
    this.filter.placeholder = lesson.say("filter");
    this.filter.setAttribute("aria-label", lesson.say("filter"));
    this.list.setAttribute("aria-label", lesson.say("tree"));
    this.keys.textContent = lesson.say("treeKeys");
    this.rows = new Map(lesson.facts.nodes.map((node) => [node.id, new TreeRow(lesson, this.stage, node)]));
    this.list.replaceChildren();
    for (const row of this.rows.values()) (this.rows.get(row.node.parent)?.inside ?? this.list).append(row.element);
    this.showFiltered();
    this.showChosen();
    this.showLook();
    this.setStop(this.shown()[0]);
  }

  /** Rows that match the filter, in any language, and the groups they lie in. */
  showFiltered() {
    const wanted = normalised(this.filter.value);
    const { lesson } = this;
    /** @type {Set<number>} */
    const kept = new Set();
    let found = 0;
    for (const node of lesson.facts.nodes) {
      const matches = Object.values(node.names).some((name) => normalised(name).includes(wanted));
      if (!matches) continue;
      if (!node.group) ++found;
      for (const id of [node.id, ...lesson.groupsOf(node.id)]) kept.add(id);
      if (node.group && wanted) for (const id of lesson.structuresIn(node.id)) kept.add(id);
    }
    for (const [id, row] of this.rows) {
      row.element.hidden =
        wanted !== "" &&
        !kept.has(id) &&
        !lesson.groupsOf(id).some((group) => kept.has(group) && normalised(lesson.nameOf(group)).includes(wanted));
      if (row.inside) row.setOpen(wanted !== "" || !this.folded.has(id));
    }
    this.none.hidden = wanted === "" || kept.size > 0;
    this.none.textContent = lesson.say("noneFound");
    if (wanted) lesson.announce(kept.size ? lesson.say("found", found) : lesson.say("noneFound"));
    const shown = this.shown();
    if (!shown.some((row) => row.element.tabIndex === 0)) this.setStop(shown[0]);
  }

  /** Rows that can be seen, from top to bottom. */
  shown() {
    return [...this.rows.values()].filter(
      (row) => !row.element.hidden && this.lesson.groupsOf(row.node.id).every((group) => this.rows.get(group)?.open),
    );
  }

  /** Where Tab enters the tree. @param {TreeRow | undefined} row */
  setStop(row) {
    for (const one of this.rows.values()) one.element.tabIndex = one === row ? 0 : -1;
  }

  /** @param {TreeRow | undefined} row */
  focus(row) {
    if (!row) return;
    this.setStop(row);
    row.element.focus();
    row.line.scrollIntoView({ block: "nearest" });
  }

  showChosen() {
    const chosen = new Set(this.lesson.chosen);
    for (const [id, row] of this.rows) row.showChosen(chosen.has(id));
    const row = this.rows.get(this.lesson.chosen[0]);
    if (!row) return;
    for (const group of this.lesson.groupsOf(row.node.id)) this.setOpen(group, true);
    this.setStop(row);
    // The card of what is chosen takes its room first.
    requestAnimationFrame(() => {
      if (this.element.offsetParent) row.line.scrollIntoView({ block: "nearest" });
    });
  }

  showLook() {
    for (const row of this.rows.values()) row.showLook();
  }

  /** Where labels are numbers the tree is their key. */
  showNumbers() {
    const { lesson } = this;
    /** @type {Map<number, number>} */
    const numbers = new Map();
    if (lesson.labels === "numbers")
      for (const placed of lesson.placed)
        for (const id of lesson.facts.labels.find((label) => label.id === placed.id)?.structures ?? [])
          if (!numbers.has(id)) numbers.set(id, placed.number);
    for (const [id, row] of this.rows) row.showNumber(numbers.get(id) ?? 0);
  }

  /** @param {number} group @param {boolean} open */
  setOpen(group, open) {
    if (open) this.folded.delete(group);
    else this.folded.add(group);
    this.rows.get(group)?.setOpen(open);
  }

  /** @param {Event} event */
  rowOf(event) {
    const item = event.target instanceof Element ? event.target.closest("[role=treeitem]") : null;
    return item ? this.rows.get(Number(item.getAttribute("data-id"))) : undefined;
  }

  /** @param {MouseEvent} event */
  clicked(event) {
    const row = this.rowOf(event);
    const target = event.target;
    if (!row || !(target instanceof Element) || target.closest(".eye, .gamma")) return;
    if (target.closest("button.fold")) {
      this.setOpen(row.node.id, !row.open);
      this.focus(row);
      return;
    }
    this.choose(row, event.ctrlKey || event.metaKey);
    this.focus(row);
  }

  /** @param {TreeRow} row @param {boolean} further */
  choose(row, further) {
    const { chosen } = this.lesson;
    const id = row.node.id;
    if (!further) this.lesson.choose(chosen.length === 1 && chosen[0] === id ? [] : [id]);
    else if (chosen.includes(id)) this.lesson.choose(chosen.filter((one) => one !== id));
    else this.lesson.choose([...chosen, id]);
  }

  /** @param {KeyboardEvent} event */
  filterKey(event) {
    const first = this.shown().find((row) => !row.node.group) ?? this.shown()[0];
    if (event.key === "Enter" && first && this.filter.value) this.lesson.choose([first.node.id]);
    else if (event.key === "ArrowDown") this.focus(this.shown()[0]);
    else return;
    event.preventDefault();
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    const row = this.rowOf(event);
    if (!row || event.altKey || event.target instanceof HTMLInputElement) return;
    const shown = this.shown();
    const at = shown.indexOf(row);
    /** @type {{[key: string]: () => void}} */
    const acts = {
      ArrowDown: () => this.focus(shown[at + 1]),
      ArrowUp: () => (at === 0 ? this.filter.focus() : this.focus(shown[at - 1])),
      Home: () => this.focus(shown[0]),
      End: () => this.focus(shown[shown.length - 1]),
      ArrowRight: () => this.inwards(row, shown[at + 1]),
      ArrowLeft: () => this.outwards(row),
      Enter: () => this.choose(row, event.ctrlKey),
      " ": () => row.toggle(),
      "+": () => row.addGamma(0.25),
      "-": () => row.addGamma(-0.25),
    };
    const act = acts[directed(event.key)];
    if (act) act();
    else if (event.key.length !== 1 || event.ctrlKey || event.key === "/" || !this.seek(event.key, shown, at)) return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** @param {TreeRow} row @param {TreeRow | undefined} next */
  inwards(row, next) {
    if (row.inside && !row.open) this.setOpen(row.node.id, true);
    else if (row.inside) this.focus(next);
  }

  /** @param {TreeRow} row */
  outwards(row) {
    if (row.inside && row.open) this.setOpen(row.node.id, false);
    else this.focus(this.rows.get(row.node.parent));
  }

  /** Goes to the next row that begins with what is typed. @param {string} letter @param {TreeRow[]} shown @param {number} at */
  seek(letter, shown, at) {
    const now = performance.now();
    this.typed = now - this.typedAt > 700 ? letter : this.typed + letter;
    this.typedAt = now;
    const wanted = normalised(this.typed);
    if (!wanted) return false;
    const from = this.typed.length === 1 ? at + 1 : at;
    const order = [...shown.slice(from), ...shown.slice(0, from)];
    this.focus(order.find((row) => normalised(this.lesson.nameOf(row.node.id)).startsWith(wanted)));
    return true;
  }
}

/** An arrow as it means in a page written from left to right. @param {string} key */
export function directed(key) {
  if (document.documentElement.dir !== "rtl") return key;
  return { ArrowLeft: "ArrowRight", ArrowRight: "ArrowLeft" }[key] ?? key;
}
