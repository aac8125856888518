// SPDX-License-Identifier: Apache-2.0
// What the linter looks for in the scripts of the students' page and of its tests.
import { createRequire } from "node:module";
import { join } from "node:path";

const modules = createRequire(join(process.env.PAGE_MODULES ?? "", "x.js"));
const js = modules("@eslint/js");
const globals = modules("globals");

export default [
  js.configs.recommended,
  {
    linterOptions: { reportUnusedDisableDirectives: "error" },
    rules: {
      eqeqeq: "error",
      "no-duplicate-imports": "error",
      "no-implicit-coercion": "error",
      "no-self-compare": "error",
      "no-unused-vars": ["error", { argsIgnorePattern: "^_" }],
      "no-use-before-define": ["error", { functions: false, classes: false, variables: true }],
      "no-var": "error",
      "object-shorthand": "error",
      "prefer-const": "error",
    },
  },
  {
    files: ["resources/page/*.js", "render/web/*.js", "tests/page/*.js"],
    languageOptions: { globals: globals.browser },
  },
  // What tests do in the page stands among what they do in node.
  { files: ["tests/page/**/*.mjs"], languageOptions: { globals: { ...globals.node, ...globals.browser } } },
];
