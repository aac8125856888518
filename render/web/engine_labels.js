// SPDX-License-Identifier: Apache-2.0
// Labels as they are drawn over the picture: texts with their leaders, and the letters of the body's
// sides (resources/page/engine.d.ts names their classes).

/** @import { Placed } from "../../resources/page/engine.d.ts" */

/**
 * A label as the program lays it out: on which side of its box the leader begins, where it points, and
 * the leader's corners.
 * @typedef {{ label: Placed, side: number, places: number[][], leader: number[][] }} LaidLabel
 */

const svgSpace = "http://www.w3.org/2000/svg";
/** Lengths of labels, in CSS pixels. */
export const labelSize = { text: 14, line: 18, padding: 3, badge: 11, dot: 2, edge: 10 };

/**
 * @param {string} name @param {string} kind its class
 * @param {{[key: string]: string | number}} values @param {string} [words] in it
 */
function shape(name, kind, values, words = "") {
  const made = document.createElementNS(svgSpace, name);
  made.setAttribute("class", kind);
  for (const [key, value] of Object.entries(values)) made.setAttribute(key, String(value));
  made.textContent = words;
  return made;
}

/**
 * The sides of the body at the picture's edges, as near to their middles as no label stands.
 * @param {string[]} letters of the left edge, the right one, above and below; empty ones are not shown
 * @param {Placed[]} placed @param {{ width: number, height: number }} size of the picture
 */
export function edgeLetters(letters, placed, { width, height }) {
  const { text, edge } = labelSize;
  return letters.flatMap((letter, i) => {
    const anchor = ["start", "end", "middle", "middle"][i];
    const across = [edge, width - edge, edge + text / 2, height - edge - text / 2][i];
    const [length, reach] = [i < 2 ? height : width, text * letter.length];
    for (let k = 0; letter && k * text < 0.9 * length; ++k) {
      const along = length / 2 + (k % 2 ? 1 : -1) * Math.ceil(k / 2) * text;
      const [x, y] = i < 2 ? [across, along] : [along, across];
      if (
        !placed.some(
          ({ box: [left, top, wide, high] }) =>
            left < x + reach && left + wide > x - reach && top < y + text && top + high > y - text,
        )
      )
        return [
          shape("text", "edge-letter", { x, y: y + 0.35 * text, "text-anchor": anchor, "font-size": text }, letter),
        ];
    }
    return [];
  });
}

/** @param {LaidLabel} laid @param {string[]} lines @param {boolean} numbered the text is a number, in a badge */
export function labelGroup({ label, side, places, leader }, lines, numbered) {
  const group = shape("g", "label", { "data-id": label.id });
  const line = leader.length > 1 ? leader : places.length > 1 ? places : [];
  if (line.length > 1)
    group.append(
      shape("path", label.hidden ? "leader hidden" : "leader", { d: `M${line.map((p) => p.join(" ")).join("L")}` }),
    );
  for (const [x, y] of places)
    group.append(shape("circle", label.hidden ? "dot hidden" : "dot", { cx: x, cy: y, r: labelSize.dot }));
  const [left, top, width, height] = label.box;
  if (numbered)
    group.append(shape("circle", "badge", { cx: left + width / 2, cy: top + height / 2, r: labelSize.badge }));
  const toLeft = side === 0 || (side >= 2 && left + width / 2 < (places[0]?.[0] ?? 0));
  const anchor = numbered ? "middle" : toLeft ? "end" : "start";
  const x =
    anchor === "middle"
      ? left + width / 2
      : anchor === "end"
        ? left + width - labelSize.padding
        : left + labelSize.padding;
  const first = top + height / 2 - ((lines.length - 1) * labelSize.line) / 2 + 0.35 * labelSize.text;
  lines.forEach((words, i) =>
    group.append(
      shape(
        "text",
        "label-text",
        { x, y: first + i * labelSize.line, "text-anchor": anchor, "font-size": labelSize.text },
        words,
      ),
    ),
  );
  return group;
}
