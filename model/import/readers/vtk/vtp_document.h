// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "model/import/readers/vtk/vtp_blocks.h"
#include "model/import/source/source.h"

namespace sline::model {

/// Describes an array of a piece and where its values are stored.
struct VtpArray {
  std::string section;  ///< Points, Polys or Strips
  std::string name;     ///< "connectivity", "offsets"
  const char* place = nullptr;
  VtpContent content;
};

struct VtpPiece {
  const char* place = nullptr;
  std::uint64_t points = 0;
  std::uint64_t polys = 0;
  std::uint64_t strips = 0;
  bool hasLines = false;  ///< lines or vertices
  std::vector<VtpArray> arrays;
};

/// Holds the parts of a VTP file that make a surface; point and cell data are stepped over.
struct VtpDocument {
  VtpEncoding encoding;
  std::vector<VtpPiece> pieces;
  std::optional<VtpContent> space;  ///< the field array of that name: the frame
};

/// Scans the file's tags. Every array of the result lies within the file and has a type that suits
/// it.
Result<VtpDocument> scanVtp(const Source& source);

}  // namespace sline::model
