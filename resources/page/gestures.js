// SPDX-License-Identifier: Apache-2.0
// Mouse, fingers and keys on the picture.

import { directions } from "./stage.js";

/** @import { Stage } from "./stage.js" */

/** Pixels within which a press is a click. */
export const clickReach = 6;
/** Milliseconds, and pixels, between the two clicks of a double one. */
const twiceWithin = 350;
const twiceReach = 30;

export class Gestures {
  /**
   * @param {Stage} stage
   * @param {{clicked: (structure: number) => void, twice: (structure: number) => void}} acts
   */
  constructor(stage, acts) {
    this.stage = stage;
    this.acts = acts;
    /** @type {Map<number, {x: number, y: number}>} */
    this.fingers = new Map();
    this.wandered = false;
    this.start = { x: 0, y: 0 };
    this.last = { at: -1e6, structure: 0, x: 0, y: 0 };
    this.hover = 0;
    const { element } = stage;
    element.addEventListener("pointerdown", (event) => this.down(event));
    element.addEventListener("pointermove", (event) => this.moved(event));
    element.addEventListener("pointerup", (event) => this.up(event));
    element.addEventListener("pointercancel", (event) => this.fingers.delete(event.pointerId));
    element.addEventListener("pointerleave", () => this.tip(undefined));
    element.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    element.addEventListener("contextmenu", (event) => event.preventDefault());
    element.addEventListener("keydown", (event) => {
      if (this.key(event)) event.preventDefault();
    });
  }

  /** @param {PointerEvent} event */
  down(event) {
    this.stage.element.focus({ preventScroll: true });
    this.stage.element.setPointerCapture(event.pointerId);
    this.fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    this.wandered = this.fingers.size > 1;
    this.start = { x: event.clientX, y: event.clientY };
    this.tip(undefined);
  }

  /** @param {PointerEvent} event */
  moved(event) {
    const finger = this.fingers.get(event.pointerId);
    if (!finger) {
      if (event.pointerType === "mouse") this.hovered(event);
      return;
    }
    const { clientX: x, clientY: y } = event;
    if (Math.hypot(x - this.start.x, y - this.start.y) > clickReach) this.wandered = true;
    if (!this.wandered) return;
    const dx = x - finger.x;
    const dy = y - finger.y;
    if (this.fingers.size === 2) this.pinch(event.pointerId, { x, y });
    else if (event.buttons === 4 || event.shiftKey) this.stage.move((engine) => engine.pan(dx, dy));
    else this.stage.move((engine) => engine.orbit(dx, dy));
    this.fingers.set(event.pointerId, { x, y });
  }

  /** Two fingers keep what is under them. @param {number} id @param {{x: number, y: number}} to */
  pinch(id, to) {
    const from = /** @type {{x: number, y: number}} */ (this.fingers.get(id));
    const other = [...this.fingers].find(([finger]) => finger !== id)?.[1];
    if (!other) return;
    const box = this.stage.element.getBoundingClientRect();
    const before = Math.hypot(from.x - other.x, from.y - other.y);
    const after = Math.hypot(to.x - other.x, to.y - other.y);
    this.stage.move((engine) => {
      engine.pan((to.x - from.x) / 2, (to.y - from.y) / 2);
      if (before > 10 && after > 10)
        engine.zoom(after / before, (to.x + other.x) / 2 - box.left, (to.y + other.y) / 2 - box.top);
    });
  }

  /** @param {PointerEvent} event */
  up(event) {
    if (!this.fingers.delete(event.pointerId) || this.wandered) return;
    const { clientX: x, clientY: y, timeStamp } = event;
    // What was clicked first counts: the picture may have made room for its card by the second time.
    const twice = timeStamp - this.last.at < twiceWithin && Math.hypot(x - this.last.x, y - this.last.y) < twiceReach;
    if (twice) {
      this.acts.twice(this.last.structure);
      this.last.at = -1e6;
      return;
    }
    this.last = { at: timeStamp, structure: this.stage.structureAt(x, y), x, y };
    this.acts.clicked(this.last.structure);
  }

  /** @param {WheelEvent} event */
  wheel(event) {
    event.preventDefault();
    const box = this.stage.element.getBoundingClientRect();
    const lines = event.deltaMode === 1 ? 20 : 1;
    const turn = Math.max(-240, Math.min(240, event.deltaY * lines));
    const factor = Math.exp(-turn * (event.ctrlKey ? 0.008 : 0.0016));
    this.stage.move((engine) => engine.zoom(factor, event.clientX - box.left, event.clientY - box.top));
  }

  /** Says under a resting mouse what is there. @param {PointerEvent} event */
  hovered(event) {
    window.clearTimeout(this.hover);
    this.tip(undefined);
    const { lesson } = this.stage;
    if (lesson.asking || lesson.nameless) return;
    this.hover = window.setTimeout(() => {
      const structure = this.stage.structureAt(event.clientX, event.clientY);
      if (structure && !lesson.asking) this.tip({ structure, x: event.clientX, y: event.clientY });
    }, 120);
  }

  /** @param {{structure: number, x: number, y: number} | undefined} at */
  tip(at) {
    const { hint, element, lesson } = this.stage;
    if (!at) window.clearTimeout(this.hover);
    hint.hidden = !at;
    if (!at) return;
    const box = element.getBoundingClientRect();
    hint.replaceChildren(lesson.nameElement(at.structure));
    const left = Math.min(at.x - box.left + 14, box.width - hint.offsetWidth - 6);
    const top = Math.min(at.y - box.top + 18, box.height - hint.offsetHeight - 6);
    hint.style.setProperty("left", `${Math.max(4, left)}px`);
    hint.style.setProperty("top", `${Math.max(4, top)}px`);
  }

  /** @param {KeyboardEvent} event @returns {boolean} whether the key meant something */
  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return false;
    const { stage } = this;
    const step = event.shiftKey ? 40 : 24;
    /** @type {{[key: string]: [number, number]}} */
    const arrows = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step] };
    const arrow = arrows[event.key];
    const side = directions.find(([, letter]) => letter === event.key.toUpperCase());
    if (arrow) stage.move((engine) => (event.shiftKey ? engine.pan(...arrow) : engine.orbit(...arrow)));
    else if (side) stage.move((engine) => engine.direction(side[0]), false);
    else if (event.key === "+" || event.key === "=") stage.zoomMiddle(1.15);
    else if (event.key === "-") stage.zoomMiddle(1 / 1.15);
    else if (event.key === "," || event.key === ".") stage.move((engine) => engine.roll(event.key === "," ? -5 : 5));
    else if (event.key === "Home") stage.fit([]);
    else return false;
    return true;
  }
}
