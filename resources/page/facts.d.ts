// SPDX-License-Identifier: Apache-2.0
// What a page knows of its scene besides the drawing: every text comes from here. The exporter writes
// it as JSON into the page's element `facts`.

/** Plain text by language tag: "la", "en", "de", "nl", "nb". */
export type Words = { [language: string]: string };

/** A stretch of text of one look; it may be a link that lights a structure up or goes to a view. */
export interface Run {
  text: string;
  bold?: true;
  italic?: true;
  raised?: true;
  lowered?: true;
  structure?: number;
  view?: number;
}

export type Lines = Run[][];

/** A group or a structure. */
export interface NodeFacts {
  id: number;
  /** Id of the group it lies in; 0 at the top. */
  parent: number;
  group: boolean;
  names: Words;
  /** "#rrggbb" */
  colour: string;
  gamma: number;
  visible: boolean;
  focus: boolean;
  note?: { [language: string]: Lines };
}

/** A saved view. The first has the number 1, as in the deep link #view=1. */
export interface ViewFacts {
  title: Words;
  words: { [language: string]: Lines };
  alt: Words;
  /** How long the flight there takes. */
  seconds: number;
}

export interface LabelFacts {
  id: number;
  structures: number[];
  kind: "label" | "callout" | "pin" | "distance";
  words: { [language: string]: Lines };
}

export interface QuestionFacts {
  id: string;
  kind: "find" | "name" | "choose" | "order" | "drag";
  /** What is asked for; absent where no name may be in the page. */
  words?: Words;
  structures: number[];
  labels: number[];
  choices?: Words[];
  /** Which of the choices is right, from 0. */
  right?: number;
  /** The first 16 hexadecimal digits of SHA-256 of salt and normalised name, of all languages. */
  answers: string[];
  /** From 1; absent where the question is asked in whatever view there is. */
  view?: number;
}

export interface QuizFacts {
  mode: "beside" | "only" | "off";
  /** Whether the first answer counts; else the quiz is practice and may be taken again. */
  counts: boolean;
  lockCamera: boolean;
  lockLook: boolean;
  salt: string;
  questions: QuestionFacts[];
}

export interface Facts {
  schema: 1;
  title: string;
  /** The language that texts fall back on. */
  language: string;
  languages: string[];
  /** In the tree's order, parents first. */
  nodes: NodeFacts[];
  views: ViewFacts[];
  labels: LabelFacts[];
  /** The labels were found for the page: each is shown where what it names is seen. */
  labelsFound?: true;
  /** Nobody knows which sides of the body what is shown has. */
  sideless?: true;
  quiz: QuizFacts;
  credits: string[];
  alt: Words;
  /** How far, in mm, surfaces lie from what they were made of; absent where none was simplified. */
  simplifiedMm?: number;
  report?: "scorm12" | "scorm2004" | "cmi5";
}
