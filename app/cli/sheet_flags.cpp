// SPDX-License-Identifier: Apache-2.0
#include "app/cli/sheet_flags.h"

#include <array>
#include <filesystem>

#include "app/cli/text_file.h"

namespace sline::cli {

namespace {

/// Enough for a book; what is longer is no leaflet's text.
constexpr std::size_t mostBytes = 1'000'000;

/// A single word with a folder or an ending, as in "leaflets/bladder.txt"; no address of a page.
bool looksLikeFile(const std::string& text) {
  if (text.empty() || text.find_first_of(" \t\r\n") != std::string::npos ||
      text.find("://") != std::string::npos)
    return false;
  return text.find('/') != std::string::npos ||
         std::filesystem::path(text).extension().string().size() > 1;
}

/// The text of the file of that name, where there is one.
Result<std::string> textOrFile(const std::string& text) {
  namespace fs = std::filesystem;
  std::error_code fault;
  const fs::file_status there = text.find('\n') == std::string::npos && text.size() <= 4000
                                    ? fs::status(text, fault)
                                    : fs::file_status(fs::file_type::not_found);
  if (fs::exists(there) && !fs::is_directory(there))
    return readText(text, mostBytes);
  if (looksLikeFile(text))
    return Error{.file = text,
                 .reason = fs::is_directory(there) ? "it is a folder, and no text for a patient"
                                                   : "there is no such file with a text",
                 .remedy = "Check its name; a text of one word ends with a full stop"};
  return text;
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
