// SPDX-License-Identifier: Apache-2.0
// What the page's parts tell one another, through the lesson (lesson.js): each event by its type, with
// what its hearers need beyond what the lesson itself holds.

import type { PanelName } from "./panels.js";

export type PageEvent =
  /** The language of names and texts is another. */
  | { type: "language" }
  /** Other structures are chosen. */
  | { type: "chosen" }
  /** Another saved view is gone to. */
  | { type: "view" }
  /** Γ or what is visible has changed. */
  | { type: "look" }
  /** The reader wants other labels. */
  | { type: "labels" }
  /** A question begins or ends. */
  | { type: "quiz" }
  /** There is a new picture. */
  | { type: "drawn" }
  /** The reader moves the scene. */
  | { type: "grab" }
  /** The picture's memory is gone. */
  | { type: "lost" }
  /** Panels open or close; `open` are those that are. */
  | { type: "panels"; open: ReadonlySet<PanelName> };

export type PageEventType = PageEvent["type"];
export type PageEventOf<Type extends PageEventType> = Extract<PageEvent, { type: Type }>;
