// SPDX-License-Identifier: Apache-2.0
#include "app/cli/sheet_flags.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace sline::cli {

namespace {

/// Enough for a book; what is longer is no leaflet's text.
constexpr std::uintmax_t mostBytes = 1'000'000;

/// The text of the file of that name, where there is one.
Result<std::string> textOrFile(const std::string& text) {
  namespace fs = std::filesystem;
  std::error_code fault;
  const fs::path file(text);
  if (text.empty() || text.size() > 4000 || text.find('\n') != std::string::npos ||
      !fs::is_regular_file(file, fault))
    return text;
  if (fs::file_size(file, fault) > mostBytes || fault)
    return Error{.file = text,
                 .reason = "the file is too long for the text of a sheet",
                 .remedy = "Give a text file of less than 1 MB"};
  std::ifstream in(file, std::ios::binary);
  std::ostringstream read;
  read << in.rdbuf();
  if (!in)
    return Error{.file = text, .reason = "the file cannot be read", .remedy = "Check its rights"};
  return read.str();
}

}  // namespace

Result<render::ExportSheet> understood(const SheetFlags& flags) {
  using render::SheetKind;
  static constexpr std::array<std::pair<std::string_view, SheetKind>, 4> kinds{
      {{"", SheetKind::none},
       {"figure", SheetKind::figure},
       {"teaching", SheetKind::teaching},
       {"patient", SheetKind::patient}}};
  render::ExportSheet sheet;
  bool known = false;
  for (const auto& [name, kind] : kinds)
    if (name == flags.kind) {
      sheet.kind = kind;
      known = true;
    }
  if (!known)
    return Error{.reason = "--sheet " + flags.kind + " is unknown",
                 .remedy = "Give figure, teaching or patient"};
  if (flags.paper != "a4" && flags.paper != "letter")
    return Error{.reason = "--paper " + flags.paper + " is unknown", .remedy = "Give a4 or letter"};
  if (!flags.text.empty() && sheet.kind != SheetKind::patient)
    return Error{.reason = "--text stands on sheets for patients alone",
                 .remedy = "Add --sheet patient"};
  sheet.paper = flags.paper == "letter" ? render::Paper::letter : render::Paper::a4;
  sheet.landscape = flags.landscape;
  sheet.title = flags.title;
  const Result<std::string> text = textOrFile(flags.text);
  if (!text.ok())
    return text.error();
  sheet.text = *text;
  return sheet;
}

}  // namespace sline::cli
