// SPDX-License-Identifier: Apache-2.0
// The drawing, as the page sees it: render/web/engine.js is one, tests/page/fake_engine.js another.
// Lengths are CSS pixels from the picture's upper left corner. The engine knows no texts.

export interface EngineOptions {
  /** The WebAssembly program. */
  program: Uint8Array;
  canvas: HTMLCanvasElement;
  /**
   * Labels are drawn into it, in the classes `label` (a group with data-id), `label-text`, `leader`,
   * `hidden` (a leader to what is hidden), `dot` and `badge`; and the sides of the body at its edges, of
   * the class `edge-letter`.
   */
  overlay: SVGSVGElement;
}

/** Opaque; may go through JSON. */
export interface CameraState {
  [field: string]: number;
}

/** Where a label stands: its box is left, top, width and height. */
export interface Placed {
  id: number;
  box: [number, number, number, number];
  hidden: boolean;
  number: number;
}

export interface LabelMode {
  show: boolean;
  /** Absent: those that the view shows. */
  only?: number[];
  numbers?: boolean;
  /** Whether labels of what is not seen are left out; else their leaders are dashed. */
  seen?: boolean;
  /** Whether the letters of the body's sides stand at the edges. */
  sides?: boolean;
  /** By label, its paragraphs. */
  texts: { [id: number]: string[] };
}

export type Direction = "anterior" | "posterior" | "left" | "right" | "superior" | "inferior";

/** Rejects with an Error where there is neither WebGL 2 nor Canvas 2D. */
export type StartEngine = (options: EngineOptions) => Promise<Engine>;

export interface Engine {
  readonly means: "webgl" | "canvas";
  /** The one that has the picture: that of the options, or another in its place. */
  readonly canvas: HTMLCanvasElement;
  /** Takes an unpacked scene. */
  load(scene: Uint8Array, context?: Uint8Array): void;
  /** Adds the structures that came later. */
  addContext(scene: Uint8Array): void;
  /** `ratio` is device pixels per CSS pixel. */
  size(width: number, height: number, ratio: number): void;

  orbit(dx: number, dy: number): void;
  pan(dx: number, dy: number): void;
  roll(degrees: number): void;
  /** Keeps what is under x, y. */
  zoom(factor: number, x: number, y: number): void;
  /** All of the scene when empty. */
  fit(ids: number[]): void;
  direction(name: Direction): void;
  camera(): CameraState;
  setCamera(camera: CameraState): void;
  /** Views count from 1; share is that of the flight: 0 begins it where the camera is and shows what the view shows, 1 is there. */
  goTo(view: number, share: number): void;
  /** The side that faces the reader: "A", "L", …; empty where the camera looks along no axis. */
  facing(): string;

  setGamma(ids: number[], gamma: number): void;
  gamma(id: number): number;
  setVisible(ids: number[], visible: boolean): void;
  visible(id: number): boolean;
  resetLook(): void;
  /** Outlines them in the picture. */
  select(ids: number[]): void;

  labels(mode: LabelMode): void;

  /** Draws at once; `moving` asks for speed rather than for everything. */
  draw(moving: boolean): { labels: Placed[]; milliseconds: number; complete: boolean };
  /** What is seen there; 0 for nothing. */
  pick(x: number, y: number): { structure: number; label: number };
  free(): void;
}
