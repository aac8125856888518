// SPDX-License-Identifier: Apache-2.0
#include "render/export/students/web_program.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>

#include "model/disk/process.h"
#include "model/disk/whole_file.h"

namespace sline::render {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t largestPart = 50'000'000;
constexpr const char* glueName = "engine_module.js";

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
                   "emscripten, too (on Debian the package of that name), and build again"};
}

/// Returns the name on a line of order.txt; empty for remarks and for the glue.
std::string listedName(std::string line) {
  constexpr const char* blanks = " \t\r";
  const std::size_t from = line.find_first_not_of(blanks);
  if (from == std::string::npos || line[from] == '#')
    return {};
  line = line.substr(from, line.find_last_not_of(blanks) + 1 - from);
  const bool within = line.find('/') == std::string::npos && line != "..";
  return within && line != glueName ? line : std::string();
}

Result<std::string> scriptInOrder() {
  const Result<std::string> order = part("order.txt");
  if (!order.ok())
    return order.error();
  std::string script;
  std::istringstream lines(*order);
  for (std::string line; std::getline(lines, line);) {
    const std::string name = listedName(line);
    if (name.empty())
      continue;
    const Result<std::string> one = part(name);
    if (!one.ok())
      return one.error();
    script += *one + "\n";
  }
  return script;
}

}  // namespace

Result<WebProgram> webProgram() {
  WebProgram program;
  for (const auto& [name, text] :
       {std::pair{glueName, &program.glue}, std::pair{"engine.wasm", &program.wasm}}) {
    Result<std::string> read = part(name);
    if (!read.ok())
      return read.error();
    *text = std::move(*read);
  }
  return program;
}

Result<PageTemplate> pageTemplate() {
  Result<std::string> html = part("page.html");
  if (!html.ok())
    return html.error();
  Result<std::string> style = part("page.css");
  if (!style.ok())
    return style.error();
  Result<std::string> script = scriptInOrder();
  if (!script.ok())
    return script.error();
  return PageTemplate{std::move(*html), std::move(*style), std::move(*script)};
}

}  // namespace sline::render
