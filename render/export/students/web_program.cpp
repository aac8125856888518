// SPDX-License-Identifier: Apache-2.0
#include "render/export/students/web_program.h"

#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

#include "model/disk/process.h"
#include "model/disk/whole_file.h"

namespace sline::render {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t largestPart = 50'000'000;

fs::path pageFolder() {
  if (const char* named = std::getenv("SLINE_PAGE"); named && *named)
    return named;
  std::error_code none;
  const fs::path folder = model::programFile().parent_path();
  const fs::path beside = folder / "page";
  return fs::exists(beside, none) ? beside : folder.parent_path() / "lib/sline/page";
}

Result<std::string> part(const std::string& name) {
  const fs::path file = pageFolder() / name;
  Result<std::string> text = model::readText(file, largestPart);
  if (text.ok())
    return text;
  return Error{.file = file.string(),
               .reason = "a part of the program that students' pages need cannot be read: " +
                         text.error().reason,
               .remedy =
                   "Install Sline's package again; where you build it yourself, install "
                   "emscripten and esbuild, too (on Debian the packages of these names), and build "
                   "again"};
}

}  // namespace

Result<PageTemplate> pageTemplate() {
  PageTemplate page;
  for (const auto& [name, text] :
       {std::pair{"page.html", &page.html}, std::pair{"page.css", &page.style},
        std::pair{"page.js", &page.script}, std::pair{"engine.wasm", &page.wasm}}) {
    *text = TRY(part(name));
  }
  return page;
}

}  // namespace sline::render
