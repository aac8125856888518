// SPDX-License-Identifier: Apache-2.0
// An engine for tests of what needs none: it draws balls on a Canvas 2D. Its scene is JSON. What was
// asked of it is kept in `window.engineCalls`. What readers see is tested with the real one (made.mjs).

/** @import { CameraState, Direction, Engine, EngineOptions, LabelMode, Placed, StartEngine } from "../../resources/page/engine.d.ts" */

/** @typedef {{id: number, at: [number, number, number], size: [number, number, number], colour: string,
 *             gamma: number, visible: boolean}} Ball */
/** @typedef {{balls: Ball[], labels: {id: number, structure: number, view?: number}[],
 *             views: {turn: number, tilt: number, scale: number, gamma?: {[id: string]: number}}[]}} FakeScene */

/** @implements {Engine} */
class FakeEngine {
  /** @param {EngineOptions} options */
  constructor(options) {
    this.means = /** @type {"webgl" | "canvas"} */ (location.search.includes("plain") ? "canvas" : "webgl");
    this.canvas = options.canvas;
    this.overlay = options.overlay;
    this.pen = /** @type {CanvasRenderingContext2D} */ (options.canvas.getContext("2d"));
    /** @type {FakeScene} */
    this.scene = { balls: [], labels: [], views: [] };
    /** @type {Set<number>} */
    this.selected = new Set();
    /** @type {LabelMode} */
    this.mode = { show: false, texts: {} };
    this.eye = { turn: 0, tilt: 0, roll: 0, scale: 1, x: 0, y: 0 };
    this.flight = { view: 0, from: this.eye };
    this.view = 0;
    this.width = this.height = this.ratio = 1;
    /** @type {string[]} */
    this.calls = [];
    Object.assign(window, { engineCalls: this.calls, engine: this });
  }

  /** @param {Uint8Array} bytes */
  read(bytes) {
    return /** @type {FakeScene} */ (JSON.parse(new TextDecoder().decode(bytes)));
  }

  /** @param {Uint8Array} scene @param {Uint8Array} [context] */
  load(scene, context) {
    this.scene = this.read(scene);
    this.first = JSON.stringify(this.scene.balls);
    if (context) this.addContext(context);
  }

  /** @param {Uint8Array} scene */
  addContext(scene) {
    this.calls.push("context");
    const { balls } = this.read(scene);
    this.scene.balls.push(...balls);
    this.first = JSON.stringify([...JSON.parse(this.first ?? "[]"), ...balls]);
  }

  /** @param {number} width @param {number} height @param {number} ratio */
  size(width, height, ratio) {
    this.width = width;
    this.height = height;
    this.ratio = ratio;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
  }

  /** @param {number} dx @param {number} dy */
  orbit(dx, dy) {
    this.calls.push("orbit");
    this.eye.turn += dx / 120;
    this.eye.tilt = Math.max(-1.57, Math.min(1.57, this.eye.tilt + dy / 120));
  }

  /** @param {number} dx @param {number} dy */
  pan(dx, dy) {
    this.calls.push("pan");
    this.eye.x += dx;
    this.eye.y += dy;
  }

  /** @param {number} degrees */
  roll(degrees) {
    this.calls.push("roll");
    this.eye.roll += degrees;
  }

  /** @param {number} factor @param {number} x @param {number} y */
  zoom(factor, x, y) {
    this.calls.push("zoom");
    const { eye } = this;
    eye.x = x - this.width / 2 - (x - this.width / 2 - eye.x) * factor;
    eye.y = y - this.height / 2 - (y - this.height / 2 - eye.y) * factor;
    eye.scale *= factor;
  }

  /** @param {number[]} ids */
  fit(ids) {
    this.calls.push(`fit ${ids.join()}`);
    Object.assign(this.eye, { x: 0, y: 0, scale: ids.length ? 1.6 : 1 });
  }

  /** @param {Direction} name */
  direction(name) {
    this.calls.push(name);
    const quarter = Math.PI / 2;
    const ways = {
      anterior: [0, 0],
      posterior: [2, 0],
      left: [-1, 0],
      right: [1, 0],
      superior: [0, 1],
      inferior: [0, -1],
    };
    Object.assign(this.eye, { turn: ways[name][0] * quarter, tilt: ways[name][1] * quarter });
  }

  camera() {
    return { ...this.eye };
  }

  /** @param {CameraState} camera */
  setCamera(camera) {
    Object.assign(this.eye, camera);
  }

  /** @param {number} view @param {number} share */
  goTo(view, share) {
    if (share === 0 || share === 1) this.calls.push(`view ${view} ${share === 1 ? 1 : 0}`);
    if (share === 0) this.flight = { view, from: { ...this.eye } };
    const to = { roll: 0, x: 0, y: 0, ...this.scene.views[view - 1] };
    for (const field of /** @type {const} */ (["turn", "tilt", "scale", "roll", "x", "y"]))
      this.eye[field] = this.flight.from[field] * (1 - share) + to[field] * share;
    this.view = view;
    if (share > 0) return;
    this.resetLook();
    for (const ball of this.scene.balls) ball.gamma = to.gamma?.[ball.id] ?? ball.gamma;
  }

  facing() {
    const turn = (((Math.round((this.eye.turn / (Math.PI / 2)) * 20) / 20) % 4) + 4) % 4;
    if (Math.abs(this.eye.tilt) > 1.5) return this.eye.tilt > 0 ? "S" : "I";
    return this.eye.tilt === 0 && Number.isInteger(turn) ? "ARPL"[turn] : "";
  }

  /** @param {number} id */
  ball(id) {
    return this.scene.balls.find((ball) => ball.id === id);
  }

  /** @param {number[]} ids @param {number} gamma */
  setGamma(ids, gamma) {
    for (const ball of this.scene.balls) if (ids.includes(ball.id)) ball.gamma = gamma;
  }

  /** @param {number} id */
  gamma(id) {
    return this.ball(id)?.gamma ?? 0;
  }

  /** @param {number[]} ids @param {boolean} visible */
  setVisible(ids, visible) {
    for (const ball of this.scene.balls) if (ids.includes(ball.id)) ball.visible = visible;
  }

  /** @param {number} id */
  visible(id) {
    return this.ball(id)?.visible ?? false;
  }

  resetLook() {
    const first = /** @type {Ball[]} */ (JSON.parse(this.first ?? "[]"));
    for (const ball of this.scene.balls)
      Object.assign(
        ball,
        first.find((one) => one.id === ball.id),
      );
  }

  /** @param {number[]} ids */
  select(ids) {
    this.selected = new Set(ids);
  }

  /** @param {LabelMode} mode */
  labels(mode) {
    this.mode = mode;
  }

  /** Where a ball is seen: middle, half axes, depth. @param {Ball} ball */
  seen(ball) {
    const { turn, tilt, scale, x, y } = this.eye;
    const unit = (Math.min(this.width, this.height) / 260) * scale;
    const [px, py, pz] = ball.at;
    const across = px * Math.cos(turn) - py * Math.sin(turn);
    const away = px * Math.sin(turn) + py * Math.cos(turn);
    const up = pz * Math.cos(tilt) - away * Math.sin(tilt);
    const depth = away * Math.cos(tilt) + pz * Math.sin(tilt);
    const rx = Math.hypot(ball.size[0] * Math.cos(turn), ball.size[1] * Math.sin(turn));
    const ry = Math.hypot(ball.size[2] * Math.cos(tilt), ball.size[1] * Math.sin(tilt));
    return {
      x: this.width / 2 + x + across * unit,
      y: this.height / 2 + y - up * unit,
      rx: rx * unit,
      ry: ry * unit,
      depth,
    };
  }

  /** @param {boolean} moving */
  draw(moving) {
    const began = performance.now();
    const { pen } = this;
    pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    pen.fillStyle = "#ffffff";
    pen.fillRect(0, 0, this.width, this.height);
    const shown = this.scene.balls
      .filter((ball) => ball.visible)
      .sort((a, b) => this.seen(b).depth - this.seen(a).depth);
    for (const ball of shown) this.drawBall(ball);
    return { labels: this.drawLabels(), milliseconds: performance.now() - began, complete: !moving };
  }

  /** @param {Ball} ball */
  drawBall(ball) {
    const { pen } = this;
    const { x, y, rx, ry } = this.seen(ball);
    pen.beginPath();
    pen.ellipse(x, y, rx, ry, 0, 0, 2 * Math.PI);
    pen.fillStyle =
      ball.gamma < 0.5 ? "#ffffff00" : ball.colour + (ball.gamma > 4 ? "ff" : ball.gamma > 2 ? "b0" : "30");
    pen.fill();
    pen.lineWidth = this.selected.has(ball.id) ? 3 : 1.1;
    pen.strokeStyle = this.selected.has(ball.id) ? "#b3321d" : "#2a2622";
    pen.stroke();
    if (ball.gamma < 1.5) return;
    pen.save();
    pen.clip();
    pen.lineWidth = 0.5;
    for (let i = 0; i < ball.gamma * 6; ++i) {
      pen.beginPath();
      pen.ellipse(x - rx * 0.35, y - ry * 0.2, rx * (0.95 + i * 0.022), ry * (0.95 + i * 0.022), 0, -0.9, 1.6);
      pen.stroke();
    }
    pen.restore();
  }

  /** @returns {Placed[]} */
  drawLabels() {
    const { mode } = this;
    this.overlay.replaceChildren();
    if (!mode.show) return [];
    const ids = mode.only ?? Object.keys(mode.texts).map(Number);
    const wanted = this.scene.labels.filter((label) => ids.includes(label.id) && this.ball(label.structure)?.visible);
    const sides = [wanted.filter((_, i) => i % 2 === 0), wanted.filter((_, i) => i % 2 === 1)];
    return sides.flatMap((side, right) =>
      side.map((label, row) => {
        const number = wanted.indexOf(label) + 1;
        return this.drawLabel(label, { number, right: right === 1, y: ((row + 1) * this.height) / (side.length + 1) });
      }),
    );
  }

  /** @param {{id: number, structure: number}} label @param {{number: number, right: boolean, y: number}} place @returns {Placed} */
  drawLabel(label, { number, right, y }) {
    const words = this.mode.numbers ? String(number) : (this.mode.texts[label.id] ?? []).join(" ");
    const ball = this.seen(/** @type {Ball} */ (this.ball(label.structure)));
    const wide = this.mode.numbers ? 22 : words.length * 6.5 + 6;
    const left = right ? this.width - 8 - wide : 8;
    const group = this.make("g", { class: "label", "data-id": label.id });
    group.append(
      this.make("path", { class: "leader", d: `M${right ? left : left + wide} ${y}L${ball.x} ${ball.y}` }),
      this.make("circle", { class: "dot", cx: ball.x, cy: ball.y, r: 2 }),
    );
    if (this.mode.numbers) group.append(this.make("circle", { class: "badge", cx: left + wide / 2, cy: y, r: 11 }));
    const anchor = this.mode.numbers ? "middle" : right ? "end" : "start";
    const x = { middle: left + wide / 2, end: left + wide - 3, start: left + 3 }[anchor];
    const text = this.make("text", { class: "label-text", x, y: y + 5, "text-anchor": anchor, "font-size": 14 });
    text.textContent = words;
    group.append(text);
    this.overlay.append(group);
    return { id: label.id, box: [left, y - 11, wide, 22], hidden: false, number };
  }

  /** @param {string} tag @param {{[name: string]: string | number}} traits */
  make(tag, traits) {
    const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
    for (const [name, value] of Object.entries(traits)) element.setAttribute(name, String(value));
    return element;
  }

  /** @param {number} x @param {number} y */
  pick(x, y) {
    const hit = this.scene.balls
      .filter((ball) => {
        const seen = this.seen(ball);
        return ball.visible && ball.gamma >= 0.5 && ((x - seen.x) / seen.rx) ** 2 + ((y - seen.y) / seen.ry) ** 2 <= 1;
      })
      .sort((a, b) => this.seen(a).depth - this.seen(b).depth)[0];
    return { structure: hit?.id ?? 0, label: 0 };
  }

  free() {}
}

/** @type {StartEngine} */
export async function startEngine(options) {
  if (location.search.includes("no-drawing")) throw new Error("neither WebGL 2 nor Canvas 2D");
  return new FakeEngine(options);
}
