// SPDX-License-Identifier: Apache-2.0
// Lists the keys of a figure's file once: the reader, the writer, the command's help, the window's
// tips and the test of the guide are made from these rows.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace sline::model {

/// Describes one key for people. Texts are English.
struct FigureKeyNote {
  const char* object = "";  ///< where it stands: "figure", "panel", "camera" or "inset"
  const char* id = "";
  const char* value = "";  ///< what is written after it: "MM", "true|false"
  const char* help = "";
};

/// Returns all keys, those of the figure first, in the order in which they are written.
const std::vector<FigureKeyNote>& figureKeyNotes();

/// Returns what the key of that object does; it must exist.
const char* figureKeyHelp(std::string_view object, std::string_view id);

}  // namespace sline::model
