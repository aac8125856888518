// SPDX-License-Identifier: Apache-2.0
// Makes elements. Texts become text nodes: nothing that comes from a scene is ever read as HTML.

/**
 * A trait that is a function listens, `true` is an attribute without a value, `false` and absent
 * ones are left out, all others are attributes.
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {{[name: string]: string | number | boolean | undefined | ((event: any) => void)}} [traits]
 * @param {...(Node | string | null | undefined)} inside
 * @returns {HTMLElementTagNameMap[Tag]}
 */
export function make(tag, traits = {}, ...inside) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(traits)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false && value !== undefined) element.setAttribute(name, String(value));
  }
  for (const part of inside) if (part !== null && part !== undefined) element.append(part);
  return element;
}

/** Outlines on a square of 24. */
const iconPaths = {
  eye: "M2 12s3.6-6.5 10-6.5S22 12 22 12s-3.6 6.5-10 6.5S2 12 2 12z M12 9a3 3 0 1 0 0 6 3 3 0 0 0 0-6z",
  closed: "M3 11c2 3.2 5 5 9 5s7-1.8 9-5 M12 16v3 M6.5 14.5l-1.8 2.5 M17.5 14.5l1.8 2.5",
  fit: "M4 9V4h5 M15 4h5v5 M20 15v5h-5 M9 20H4v-5",
  plus: "M12 5v14 M5 12h14",
  minus: "M5 12h14",
  close: "M6 6l12 12 M18 6L6 18",
  open: "M9 6l6 6-6 6",
  back: "M15 5l-7 7 7 7",
  on: "M9 5l7 7-7 7",
  up: "M5 15l7-7 7 7",
  down: "M5 9l7 7 7-7",
  list: "M4 6h2 M9 6h11 M6 12h2 M11 12h9 M6 18h2 M11 18h9",
  book: "M12 6.5C10 5 7 4.5 3 4.5v13c4 0 7 .5 9 2 2-1.5 5-2 9-2v-13c-4 0-7 .5-9 2z M12 6.5v13",
  quiz: "M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18z M9.5 10a2.5 2.5 0 1 1 3.6 2.2c-.8.4-1.1.9-1.1 1.8 M12 16.8v.2",
  about: "M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18z M12 11v5.5 M12 7.5v.3",
  alone: "M12 8a4 4 0 1 0 0 8 4 4 0 0 0 0-8z M12 2.5v2 M12 19.5v2 M2.5 12h2 M19.5 12h2",
  reset: "M5 5v5h5 M5.5 10a7.5 7.5 0 1 1-.8 5",
  right: "M5 12.5l4.5 4.5L19 7",
  wrong: "M7 7l10 10 M17 7L7 17",
};

/**
 * A drawing beside or in place of words; readers of the page aloud pass over it.
 * @param {keyof typeof iconPaths} name
 */
export function icon(name) {
  const space = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(space, "svg");
  const path = document.createElementNS(space, "path");
  svg.setAttribute("viewBox", "0 0 24 24");
  svg.setAttribute("class", "icon");
  svg.setAttribute("aria-hidden", "true");
  path.setAttribute("d", iconPaths[name]);
  svg.append(path);
  return svg;
}

/**
 * A button that shows a drawing and says what it does.
 * @param {keyof typeof iconPaths} name
 * @param {string} words
 * @param {(event: MouseEvent) => void} act
 * @param {{[name: string]: string | boolean}} [traits]
 */
export function iconButton(name, words, act, traits = {}) {
  return make(
    "button",
    { type: "button", class: "icon-button", title: words, "aria-label": words, click: act, ...traits },
    icon(name),
  );
}

/**
 * Makes the element take two lines at most. What is cut even so is whole in a tooltip; who listens to the page hears
 * all of it at any rate.
 * @template {HTMLElement} Titled
 * @param {Titled} element
 */
export function inTwoLines(element) {
  element.classList.add("two-lines");
  element.addEventListener("pointerenter", () => {
    const cut = element.scrollHeight > element.clientHeight || element.scrollWidth > element.clientWidth;
    if (cut) element.title = element.textContent ?? "";
    else element.removeAttribute("title");
  });
  return element;
}

/**
 * Words that are in the page for who listens to it.
 * @param {string} words
 */
export function unseen(words) {
  return make("span", { class: "unseen" }, words);
}
