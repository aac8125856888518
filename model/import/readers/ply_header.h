// SPDX-License-Identifier: Apache-2.0
// Reads the header of a PLY file (Turk 1994, "The PLY Polygon File Format").
#pragma once

#include <bit>
#include <optional>
#include <string>
#include <vector>

#include "model/import/source/source.h"
#include "model/import/source/values.h"

namespace sline::model {

struct PlyProperty {
  std::string name;
  ScalarType type = ScalarType::float32;
  std::optional<ScalarType> countType;  ///< set for a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  const char* place = nullptr;  ///< its line in the header
};

struct PlyHeader {
  std::optional<std::endian> binary;  ///< the byte order; none for text
  std::vector<PlyElement> elements;
  std::optional<Frame> frame;  ///< from a comment
  const char* body = nullptr;  ///< first byte after the header
};

Result<PlyHeader> readPlyHeader(const Source& source);

}  // namespace sline::model
