// SPDX-License-Identifier: Apache-2.0
// Provides the pieces of a legacy VTK file ("VTK File Formats", vtk.org) that its two parsers
// share.
#pragma once

#include <optional>
#include <string>

#include "model/import/source/source.h"
#include "model/import/source/text_cursor.h"
#include "model/import/source/values.h"

namespace sline::model {

/// Represents the file as it is being read. In a binary file blocks of big-endian values stand
/// between lines of text.
struct LegacyVtk {
  const Source& source;
  TextCursor at;
  bool binary = false;
  int majorVersion = 0;
  std::optional<Frame> frame;
  std::string frameReason;

  Error wrong(const char* place, std::string reason, std::string remedy = {}) const {
    if (at.atEnd() && reason.find("file ends") == std::string::npos)
      reason += "; the file ends there";
    return binary ? source.atByte(place, std::move(reason), std::move(remedy))
                  : source.atLine(place, std::move(reason), std::move(remedy));
  }
  /// Returns the next word, over line ends; empty at the end of the file.
  std::string_view next() {
    at.skipSpace();
    return at.word();
  }
  /// Returns a count, or nothing where none follows.
  std::optional<std::uint64_t> nextCount();
  /// Moves past the line end that separates a keyword's line from its values.
  void toValues();
};

/// Returns the type that a name like "float" or "vtktypeint64" stands for; "bit" and "string" are
/// none.
std::optional<ScalarType> legacyType(std::string_view name);

/// Steps over METADATA, which ends with an empty line. The keyword must have been read.
void skipMetadata(LegacyVtk& file);
/// Steps over the arrays of FIELD and takes the frame from one called SPACE. The keyword must have
/// been read.
Status readField(LegacyVtk& file);
/// Steps over point and cell data; returns an error where the file ends within it. The keyword
/// POINT_DATA or CELL_DATA must have been read.
Status skipAttributes(LegacyVtk& file);

}  // namespace sline::model
