// SPDX-License-Identifier: Apache-2.0
// Finds what all students' pages share: the renderer compiled for browsers, and the page itself. It
// lies in the folder `page` beside the program, or in ../lib/sline/page from there; SLINE_PAGE in
// the environment names another folder.
#pragma once

#include <string>

#include "model/base/result.h"

namespace sline::render {

/// The renderer for browsers, as Emscripten makes it.
struct WebProgram {
  std::string glue;  ///< JavaScript that starts it: engine_module.js
  std::string wasm;  ///< WebAssembly: engine.wasm
};

/// The page around it.
struct PageTemplate {
  std::string html;    ///< page.html, which describes its placeholders
  std::string style;   ///< page.css
  std::string script;  ///< the files that order.txt lists, without the glue
};

/// The error says what to install.
Result<WebProgram> webProgram();
Result<PageTemplate> pageTemplate();

}  // namespace sline::render
