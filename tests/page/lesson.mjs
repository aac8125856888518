// SPDX-License-Identifier: Apache-2.0
// A lesson for tests: a pelvis made of balls, with labels, three views and a question of each kind.
import { createHash } from "node:crypto";

// prettier-ignore
/** id, parent, colour, middle, half axes, Γ, names in English, Latin, German, Dutch, Norwegian */
const rows = [
  [1, 0, "", null, null, 0, "Bones", "Ossa", "Knochen", "Botten", "Knokler"],
  [2, 1, "#e5d9b6", [-62, 10, 10], [34, 30, 62], 1, "Right hip bone", "Os coxae dextrum", "Rechtes Hüftbein", "Rechter heupbeen", "Høyre hoftebein"],
  [3, 1, "#e5d9b6", [62, 10, 10], [34, 30, 62], 1, "Left hip bone", "Os coxae sinistrum", "Linkes Hüftbein", "Linker heupbeen", "Venstre hoftebein"],
  [4, 1, "#e5d9b6", [0, 62, 34], [30, 16, 44], 2, "Sacrum", "Os sacrum", "Kreuzbein", "Heiligbeen", "Korsbein"],
  [5, 0, "", null, null, 0, "Urinary system", "Systema urinarium", "Harnsystem", "Urinewegen", "Urinveier"],
  [6, 5, "#e2b35a", [0, -18, -22], [24, 20, 20], 4.4, "Urinary bladder", "Vesica urinaria", "Harnblase", "Urineblaas", "Urinblære"],
  [7, 5, "#d9a441", [24, 6, 22], [4, 5, 46], 4.4, "Left ureter", "Ureter sinister", "Linker Harnleiter", "Linker ureter", "Venstre urinleder"],
  [8, 5, "#d9a441", [-24, 6, 22], [4, 5, 46], 4.4, "Right ureter", "Ureter dexter", "Rechter Harnleiter", "Rechter ureter", "Høyre urinleder"],
  [9, 5, "#c98e3a", [0, -14, -54], [5, 5, 14], 4.4, "Urethra", "Urethra", "Harnröhre", "Urinebuis", "Urinrør"],
  [10, 0, "", null, null, 0, "Vessels", "Vasa sanguinea", "Blutgefäße", "Bloedvaten", "Blodårer"],
  [11, 10, "#b8402f", [0, 40, 96], [8, 8, 30], 3, "Abdominal aorta", "Aorta abdominalis", "Bauchaorta", "Buikaorta", "Bukaorta"],
  [12, 10, "#b8402f", [17, 36, 56], [5, 5, 18], 3, "Left common iliac artery", "Arteria iliaca communis sinistra", "Linke gemeinsame Beckenschlagader", "Linker arteria iliaca communis", "Venstre felles bekkenarterie"],
  [13, 10, "#b8402f", [38, 26, 18], [5, 5, 26], 3, "Left external iliac artery", "Arteria iliaca externa sinistra", "Linke äußere Beckenschlagader", "Linker arteria iliaca externa", "Venstre ytre bekkenarterie"],
  [14, 0, "", null, null, 0, "Digestive system", "Systema digestorium", "Verdauungssystem", "Spijsvertering", "Fordøyelse"],
  [15, 14, "#cf8f7a", [0, 36, -18], [15, 14, 38], 2.4, "Rectum", "Rectum", "Mastdarm", "Endeldarm", "Endetarm"],
];
const tags = ["en", "la", "de", "nl", "nb"];
const namesOf = (row) => Object.fromEntries(tags.map((tag, i) => [tag, row[6 + i]]));
const named = (id) => namesOf(rows.find((row) => row[0] === id));
/** The context comes in the second phase. */
const later = new Set([2, 3, 4]);

export const hostile = '<img src=x onerror="window.hacked=1"> & </script>';

/** The hash of a name as answer_hash.cpp makes it. */
export function hashed(salt, name) {
  const normal = name
    .normalize("NFKD")
    .toLowerCase()
    .replace(/[^\p{L}\p{Nd}]/gu, "")
    .replace(/ς/g, "σ");
  return createHash("sha256")
    .update(salt + normal)
    .digest("hex")
    .slice(0, 16);
}

const words = {
  1: {
    en: [
      [
        { text: "The " },
        { text: "urinary bladder", structure: 6 },
        {
          text: " lies behind the pubic symphysis. When empty it is a pyramid with four sides; when it fills it rises over the brim.",
        },
      ],
      [{ text: "Compare the " }, { text: "view from behind", view: 2, italic: true }, { text: "." }],
    ],
    de: [
      [
        { text: "Die " },
        { text: "Harnblase", structure: 6 },
        { text: " liegt hinter der Symphyse. Leer ist sie eine vierseitige Pyramide." },
      ],
    ],
  },
  2: {
    en: [
      [
        { text: "The " },
        { text: "left ureter", structure: 7 },
        { text: " crosses the " },
        { text: "common iliac artery", structure: 12 },
        { text: " where it divides." },
      ],
      [{ text: "• A stone lodges here." }],
      [{ text: "• At hysterectomy it is in danger.", bold: true }],
    ],
  },
  3: { en: [[{ text: "From above one looks into the true pelvis." }]] },
};

const titles = [
  { en: "The bladder from in front", de: "Die Harnblase von vorn" },
  { en: "Where ureter and artery cross", de: "Kreuzung von Harnleiter und Arterie" },
  { en: "Into the true pelvis", de: "Blick ins kleine Becken" },
];

const labels = [
  [1, 6],
  [2, 7],
  [3, 8],
  [4, 12],
  [5, 11],
  [6, 15],
  [7, 9],
  [8, 4],
  [9, 13],
];

function questions(salt, nameless) {
  const answers = (id) => tags.map((tag) => hashed(salt, named(id)[tag]));
  const of = (id, kind, asked, more = {}) => ({
    id,
    kind,
    structures: asked,
    labels: asked.map((one) => labels.find((label) => label[1] === one)[0]),
    ...(nameless ? {} : { words: named(asked[0]) }),
    answers: answers(asked[0]),
    ...more,
  });
  const typed = [of("name-1", "name", [7], { view: 1 }), of("name-2", "name", [9])];
  if (nameless) return typed;
  return [
    of("find-1", "find", [6], { view: 1 }),
    ...typed,
    of("choose-3", "choose", [12], { choices: [13, 12, 11, 8].map(named), right: 1 }),
    of("order-4", "order", [11, 12, 13], { words: named(10), choices: [11, 12, 13].map(named) }),
    of("drag-5", "drag", [6, 15, 7], { words: undefined, choices: [6, 15, 7].map(named), view: 1 }),
  ];
}

/** Returns facts, stills, scene and context; a mode "only" has no name in it. */
export function lesson({ mode = "beside", counts = true, lock = false, report, languages = tags, title } = {}) {
  const nameless = mode === "only";
  const salt = "b3";
  const shown = nameless ? {} : undefined;
  const nodes = rows.map((row) => ({
    id: row[0],
    parent: row[1],
    group: !row[2],
    names: shown ?? namesOf(row),
    colour: row[2] || "#888888",
    gamma: row[5],
    visible: true,
    focus: !later.has(row[0]),
    ...(row[0] === 6 && !nameless
      ? {
          note: {
            en: [[{ text: "Holds 300 to 500 ml. " }, { text: "Detrusor", italic: true }, { text: " is its muscle." }]],
          },
        }
      : {}),
  }));
  const ball = (row) => ({ id: row[0], at: row[3], size: row[4], colour: row[2], gamma: row[5], visible: true });
  const balls = rows.filter((row) => row[3]);
  return {
    facts: {
      schema: 1,
      title: title ?? (nameless ? "Quiz" : "The female pelvis"),
      language: "en",
      languages: nameless ? ["en", "de"] : languages,
      nodes,
      views: titles.map((each, i) => ({
        title: shown ?? each,
        words: shown ?? words[i + 1],
        alt: shown ?? { en: `${each.en}: the bladder in front of the rectum.` },
        seconds: 0.3,
      })),
      labels: [
        ...labels.map(([id, structure]) => ({
          id,
          structures: [structure],
          kind: "label",
          words: shown ?? Object.fromEntries(tags.map((tag) => [tag, [[{ text: named(structure)[tag] }]]])),
        })),
        ...(nameless ? [] : [{ id: 20, structures: [15], kind: "callout", words: { en: [[{ text: hostile }]] } }]),
      ],
      quiz: {
        mode,
        counts,
        lockCamera: lock,
        lockLook: lock,
        salt,
        questions: mode === "off" ? [] : questions(salt, nameless),
      },
      credits: ["Balls made for tests, CC0"],
      alt: shown ?? { en: "A pelvis from in front: bladder, ureters, rectum." },
      simplifiedMm: 0.3,
      ...(report ? { report } : {}),
    },
    scene: JSON.stringify({
      balls: balls.filter((row) => !later.has(row[0])).map(ball),
      labels: labels.map(([id, structure]) => ({ id, structure })),
      views: [
        { turn: 0, tilt: 0, scale: 1 },
        { turn: Math.PI, tilt: 0, scale: 1.2, gamma: { 15: 0.4 } },
        { turn: 0, tilt: 1.2, scale: 1.1 },
      ],
    }),
    context: JSON.stringify({ balls: balls.filter((row) => later.has(row[0])).map(ball), labels: [], views: [] }),
    stills: titles
      .map(
        (each, i) =>
          `<figure><img alt="${nameless ? "" : each.en}" src="data:image/gif;base64,R0lGODlhAQABAIAAAP///wAAACH5BAAAAAAALAAAAAABAAEAAAICRAEAOw=="><figcaption>${nameless ? `View ${i + 1}` : each.en}</figcaption></figure>`,
      )
      .join("\n"),
  };
}
