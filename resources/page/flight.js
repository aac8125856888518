// SPDX-License-Identifier: Apache-2.0
// Goes to a saved view: a flight, or at once where the reader wants no motion.

/** @import { Engine } from "./engine.d.ts" */
/** @import { Stage } from "./stage.js" */

/** @returns {boolean} */
function stillnessWanted() {
  return matchMedia("(prefers-reduced-motion: reduce)").matches;
}

export class Flight {
  /** @param {Stage} stage */
  constructor(stage) {
    this.stage = stage;
    this.frame = 0;
    this.view = 0;
    stage.lesson.hear("grab", () => this.stop());
  }

  /** @param {number} view from 1 */
  goTo(view, atOnce = false) {
    const { engine, lesson } = this.stage;
    const facts = lesson.facts.views[view - 1];
    if (!facts) return;
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    this.view = view;
    lesson.view = view;
    lesson.tell({ type: "view" });
    if (!engine) return;
    // What the view shows is shown from here on, wherever the reader was before.
    engine.goTo(view, 0);
    lesson.tell({ type: "look" });
    const milliseconds = 1000 * Math.min(10, Math.max(0, facts.seconds));
    if (atOnce || stillnessWanted() || milliseconds < 50) this.land(engine, view);
    else this.fly(engine, view, milliseconds);
  }

  /** @param {Engine} engine @param {number} view @param {number} milliseconds */
  fly(engine, view, milliseconds) {
    const began = performance.now();
    const step = () => {
      const share = (performance.now() - began) / milliseconds;
      if (share >= 1) {
        this.land(engine, view);
        return;
      }
      engine.goTo(view, share);
      this.stage.redraw(true);
      this.frame = requestAnimationFrame(step);
    };
    this.frame = requestAnimationFrame(step);
  }

  /** @param {Engine} engine @param {number} view */
  land(engine, view) {
    this.frame = 0;
    engine.goTo(view, 1);
    this.stage.lesson.tell({ type: "look" });
    this.stage.redraw();
  }

  /** Ends a flight where it is, as the reader takes hold of the scene; the look is the view's. */
  stop() {
    const { engine } = this.stage;
    if (!this.frame || !engine) return;
    cancelAnimationFrame(this.frame);
    const camera = engine.camera();
    this.land(engine, this.view);
    engine.setCamera(camera);
  }
}
