// SPDX-License-Identifier: Apache-2.0
#include "render/export/order/export_notes.h"

#include <algorithm>
#include <map>

namespace sline::render {

void addNote(ExportNotes& notes, ExportNote note) {
  const auto same = std::find_if(notes.begin(), notes.end(), [&note](const ExportNote& other) {
    return other.kind == note.kind && other.detail == note.detail;
  });
  if (same == notes.end()) {
    notes.push_back(std::move(note));
    return;
  }
  std::map<std::string, std::size_t> there;
  for (const std::string& name : same->names)
    ++there[name];
  for (std::string& name : note.names)
    if (std::size_t& known = there[name]; known > 0)
      --known;
    else
      same->names.push_back(std::move(name));
}

}  // namespace sline::render
