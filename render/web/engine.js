// SPDX-License-Identifier: Apache-2.0
// The drawing of the students' page: hands what the page asks for to the program (exports.cpp), and
// draws the labels that it lays out (resources/page/engine.d.ts).

import { edgeLetters, labelGroup, labelSize } from "./engine_labels.js";

/** @import { CameraState, Direction, Engine, EngineOptions, LabelMode, Placed } from "../../resources/page/engine.d.ts" */

/**
 * @typedef {object} EngineModule what Emscripten makes of the program
 * @property {Uint8Array} HEAPU8
 * @property {Float32Array} HEAPF32
 * @property {Float64Array} HEAPF64
 * @property {{ createContext(canvas: HTMLCanvasElement, attributes: object): number, makeContextCurrent(context: number): boolean }} GL
 * @property {(place: number) => string} UTF8ToString
 * @property {(bytes: number) => number} _malloc
 * @property {(place: number) => void} _free
 */

/**
 * A text broken into lines, and the room it needs with its padding, in CSS pixels.
 * @typedef {{ lines: string[], width: number, height: number }} SetText
 */

const engineSides = ["anterior", "posterior", "left", "right", "superior", "inferior"];
const engineLetters = ["A", "P", "L", "R", "S", "I"];

/** @implements {Engine} */
class WebEngine {
  /** @param {any} module @param {EngineOptions} options */
  constructor(module, options) {
    this.module = module;
    this.canvas = options.canvas;
    this.overlay = options.overlay;
    /** @type {"webgl" | "canvas"} */
    this.means = "webgl";
    this.width = 1;
    this.height = 1;
    this.ratio = 1;
    /** @type {LabelMode} */
    this.mode = { show: false, texts: {} };
    /** @type {Map<number, SetText>} */
    this.setTexts = new Map();
    /** @type {CanvasRenderingContext2D | null} */
    this.measure = document.createElement("canvas").getContext("2d");
    /** @type {CanvasRenderingContext2D | null} */
    this.pen = null;
    /** The last picture of a moving camera, when it began and how long the program took. @type {{sync: WebGLSync, began: number, own: number} | undefined} */
    this.drawn = undefined;
    module._slineOpen();
    if (!this.openWebgl()) this.openPlain();
  }

  /** Opens the picture that WebGL 2 draws; returns false where there is none. */
  openWebgl() {
    const context = this.module.GL.createContext(this.canvas, {
      alpha: false,
      antialias: false,
      depth: false,
      stencil: false,
      majorVersion: 2,
      premultipliedAlpha: true,
      preserveDrawingBuffer: true,
    });
    return Boolean(context && this.module.GL.makeContextCurrent(context) && this.module._slineOpenPicture());
  }

  /** Opens a canvas that gets the pixels of the picture that the program draws by itself. */
  openPlain() {
    this.pen = this.canvas.getContext("2d");
    if (!this.pen) {
      // A canvas that has tried WebGL gives nothing else.
      const fresh = /** @type {HTMLCanvasElement} */ (this.canvas.cloneNode(false));
      this.canvas.replaceWith(fresh);
      this.canvas = fresh;
      this.pen = fresh.getContext("2d");
    }
    if (!this.pen) throw new Error("This browser has neither WebGL 2 nor a canvas");
    this.means = "canvas";
    this.module._slineOpenPlain();
  }

  /** @param {number | boolean} fine throws what went wrong */
  check(fine) {
    if (!fine) throw new Error(this.module.UTF8ToString(this.module._slineError()));
  }

  /** @param {Uint8Array} scene @param {Uint8Array} [context] */
  load(scene, context) {
    this.take(scene);
    if (context) this.take(context);
  }

  /** @param {Uint8Array} scene */
  addContext(scene) {
    this.take(scene);
  }

  /** @param {Uint8Array} bytes */
  take(bytes) {
    const place = this.module._malloc(bytes.length);
    if (!place) throw new Error("The memory of this page does not hold the scene");
    this.module.HEAPU8.set(bytes, place);
    const fine = this.module._slineTake(place, bytes.length);
    this.module._free(place);
    this.check(fine);
  }

  /**
   * Calls a function with numbers in memory.
   * @template T
   * @param {number[]} numbers @param {(place: number) => T} call @returns {T}
   */
  withNumbers(numbers, call) {
    const place = this.module._malloc(8 * Math.max(numbers.length, 1));
    this.module.HEAPF64.set(numbers, place / 8);
    const result = call(place);
    this.module._free(place);
    return result;
  }

  /** @param {number} width @param {number} height @param {number} ratio */
  size(width, height, ratio) {
    if (width !== this.width) this.setTexts.clear();
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
    this.ratio = ratio;
    this.module._slineSize(Math.round(this.width * ratio), Math.round(this.height * ratio), ratio);
    this.overlay.setAttribute("viewBox", `0 0 ${this.width} ${this.height}`);
    this.tellLabels();
  }

  /** @param {number} dx @param {number} dy */
  orbit(dx, dy) {
    this.module._slineOrbit(dx, dy);
  }

  /** @param {number} dx @param {number} dy */
  pan(dx, dy) {
    this.module._slinePan(dx, dy);
  }

  /** @param {number} degrees clockwise */
  roll(degrees) {
    this.module._slineRoll(degrees);
  }

  /** @param {number} factor @param {number} x @param {number} y */
  zoom(factor, x, y) {
    this.module._slineZoom(factor, x, y);
  }

  /** @param {number[]} ids */
  fit(ids) {
    this.withNumbers(ids, (place) => this.module._slineFit(place, ids.length));
  }

  /** @param {Direction} name */
  direction(name) {
    this.module._slineLook(Math.max(0, engineSides.indexOf(name)));
  }

  facing() {
    return engineLetters[this.module._slineSide()] ?? "";
  }

  /** @returns {CameraState} */
  camera() {
    const at = this.module._slineCamera() / 4;
    /** @type {CameraState} */
    const camera = {};
    for (let i = 0; i < 12; ++i) camera[`c${i}`] = this.module.HEAPF32[at + i];
    return camera;
  }

  /** @param {CameraState} camera */
  setCamera(camera) {
    const place = this.module._malloc(48);
    for (let i = 0; i < 12; ++i) this.module.HEAPF32[place / 4 + i] = camera[`c${i}`] ?? 0;
    this.module._slineSetCamera(place);
    this.module._free(place);
  }

  /** @param {number} view from 1 @param {number} share */
  goTo(view, share) {
    this.module._slineGoTo(view - 1, share);
  }

  /** @param {number[]} ids @param {number} gamma */
  setGamma(ids, gamma) {
    this.withNumbers(ids, (place) => this.module._slineSetGamma(place, ids.length, gamma));
  }

  /** @param {number} id @returns {number} */
  gamma(id) {
    return this.module._slineGamma(id);
  }

  /** @param {number[]} ids @param {boolean} visible */
  setVisible(ids, visible) {
    this.withNumbers(ids, (place) => this.module._slineSetVisible(place, ids.length, visible));
  }

  /** @param {number} id @returns {boolean} */
  visible(id) {
    return Boolean(this.module._slineVisible(id));
  }

  resetLook() {
    this.module._slineResetLook();
  }

  /** @param {number[]} ids */
  select(ids) {
    this.withNumbers(ids, (place) => this.module._slineSelect(place, ids.length));
  }

  /** @param {LabelMode} mode */
  labels(mode) {
    this.mode = mode;
    this.setTexts.clear();
    this.tellLabels();
  }

  /** The labels that may be shown. */
  labelIds() {
    return this.mode.show ? (this.mode.only ?? Object.keys(this.mode.texts).map(Number)) : [];
  }

  tellLabels() {
    const rows = [];
    const ids = this.labelIds();
    for (const id of ids) {
      const text = this.textOf(id);
      rows.push(id, text.width, text.height);
    }
    this.withNumbers(rows, (place) => this.module._slineSetLabels(place, ids.length, Boolean(this.mode.seen)));
  }

  /** @param {number} id @returns {SetText} */
  textOf(id) {
    const known = this.setTexts.get(id);
    if (known) return known;
    const made = this.mode.numbers
      ? { lines: [String(this.labelIds().indexOf(id) + 1)], width: 2 * labelSize.badge, height: 2 * labelSize.badge }
      : this.broken(this.mode.texts[id] ?? []);
    this.setTexts.set(id, made);
    return made;
  }

  /** Breaks paragraphs between words. @param {string[]} paragraphs @returns {SetText} */
  broken(paragraphs) {
    // Beside the anatomy there is room for about a sixth of the width; upright telephones have none.
    const widest = Math.min(220, Math.max(84, (this.width < 500 ? 0.28 : 0.17) * this.width));
    const lines = [];
    for (const paragraph of paragraphs) {
      let line = "";
      for (const word of paragraph.split(/\s+/)) {
        const longer = line ? `${line} ${word}` : word;
        if (line && this.widthOf(longer) > widest) {
          lines.push(line);
          line = word;
        } else {
          line = longer;
        }
      }
      lines.push(line);
    }
    const width = Math.max(0, ...lines.map((line) => this.widthOf(line)));
    return {
      lines,
      width: width + 2 * labelSize.padding,
      height: lines.length * labelSize.line + labelSize.padding,
    };
  }

  /** @param {string} line */
  widthOf(line) {
    if (!this.measure) return 0.55 * labelSize.text * line.length;
    this.measure.font = `${labelSize.text}px ${getComputedStyle(this.overlay).fontFamily || "sans-serif"}`;
    return this.measure.measureText(line).width;
  }

  /** @param {boolean} moving */
  draw(moving) {
    const began = performance.now();
    const complete = this.pen ? this.drawPlain(this.pen, moving) : this.drawPicture(moving);
    const labels = this.drawLabels(moving);
    return { labels, milliseconds: performance.now() - began, complete };
  }

  /** Gives the canvas its pixels. @param {number} ratio of its pixels to the page's */
  setCanvas(ratio) {
    const width = Math.max(1, Math.round(this.width * ratio));
    const height = Math.max(1, Math.round(this.height * ratio));
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
    this.module._slineSize(width, height, ratio);
  }

  /** Draws by WebGL. @param {boolean} moving */
  drawPicture(moving) {
    const gl = /** @type {WebGL2RenderingContext} */ (this.canvas.getContext("webgl2"));
    this.judgeLast(gl);
    this.setCanvas(this.ratio * this.module._slineScale(moving));
    const began = performance.now();
    const state = this.module._slineDraw(moving);
    this.check(state >= 0);
    const sync = moving ? gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0) : null;
    if (sync) this.drawn = { sync, began, own: performance.now() - began };
    return state === 1;
  }

  /** Tells how long the picture before took: WebGL draws on while the program has done its part. @param {WebGL2RenderingContext} gl */
  judgeLast(gl) {
    if (!this.drawn) return;
    const { sync, began, own } = this.drawn;
    this.drawn = undefined;
    const done = gl.getSyncParameter(sync, gl.SYNC_STATUS) === gl.SIGNALED;
    gl.deleteSync(sync);
    this.module._slineTook(done ? own : performance.now() - began);
  }

  /** Draws without WebGL. @param {CanvasRenderingContext2D} pen @param {boolean} moving */
  drawPlain(pen, moving) {
    this.setCanvas(this.ratio * this.module._slineScale(moving));
    const began = performance.now();
    const state = this.module._slineDraw(moving);
    this.check(state >= 0);
    const { width, height } = this.canvas;
    const pixels = new Uint8ClampedArray(this.module.HEAPU8.buffer, this.module._slinePixels(), 4 * width * height);
    pen.putImageData(new ImageData(pixels, width, height), 0, 0);
    if (moving) this.module._slineTook(performance.now() - began);
    return state === 1;
  }

  /** @param {boolean} moving @returns {Placed[]} */
  drawLabels(moving) {
    const first = this.module._slineLabels(moving) / 4;
    const numbers = this.module.HEAPF32;
    const end = first + numbers[first];
    const placed = [];
    const groups = [];
    for (let at = first + 1; at < end;) {
      const [id, hidden, side, left, top, right, bottom, places, points] = numbers.subarray(at, at + 9);
      at += 9;
      const pairs = [];
      for (let i = 0; i < places + points; ++i, at += 2) pairs.push([numbers[at], numbers[at + 1]]);
      const label = {
        id,
        box: /** @type {[number, number, number, number]} */ ([left, top, right - left, bottom - top]),
        hidden: hidden === 1,
        number: this.labelIds().indexOf(id) + 1,
      };
      placed.push(label);
      groups.push(
        labelGroup(
          { label, side, places: pairs.slice(0, places), leader: pairs.slice(places) },
          this.textOf(id).lines,
          this.mode.numbers === true,
        ),
      );
    }
    const letters = (this.mode.sides ? this.module.UTF8ToString(this.module._slineEdges()) : "").split(",");
    this.overlay.replaceChildren(...edgeLetters(letters, placed, this), ...groups);
    return placed;
  }

  /** @param {number} x @param {number} y */
  pick(x, y) {
    const at = this.module._slinePick(x, y) / 8;
    return { structure: this.module.HEAPF64[at], label: this.module.HEAPF64[at + 1] };
  }

  free() {
    this.overlay.replaceChildren();
    this.module._slineOpen();
  }
}

/**
 * @param {(settings: {wasmBinary: Uint8Array}) => Promise<any>} createModule what Emscripten makes
 * @param {EngineOptions} options
 * @returns {Promise<Engine>}
 */
export async function startEngine(createModule, options) {
  return new WebEngine(await createModule({ wasmBinary: options.program }), options);
}
