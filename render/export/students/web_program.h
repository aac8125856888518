// SPDX-License-Identifier: Apache-2.0
// Finds what all students' pages share: the page itself, and the renderer compiled for browsers. It
// lies in the folder `page` beside the program, or in ../lib/sline/page from there; SLINE_PAGE in
// the environment names another folder.
#pragma once

#include <string>

#include "model/base/result.h"

namespace sline::render {

/// What the build makes of resources/page and render/web.
struct PageTemplate {
  std::string html;    ///< page.html, which describes its placeholders
  std::string style;   ///< page.css
  std::string script;  ///< page.js: all modules in one function
  std::string wasm;    ///< engine.wasm, the renderer
};

/// The error says what to install.
Result<PageTemplate> pageTemplate();

}  // namespace sline::render
