// SPDX-License-Identifier: Apache-2.0
// Says what the fields of NRRD headers mean.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "model/import/volumes/formats/nrrd_header.h"
#include "model/import/volumes/formats/volume_file.h"

namespace sline::model {

std::optional<ScalarType> nrrdType(std::string_view name);

/// Returns the words of a field, separated by blanks.
std::vector<std::string_view> nrrdWords(std::string_view text);

/// Holds what the space's name says: how its axes map to LPS, and how it is called.
struct NrrdSpace {
  glm::dvec3 toLps{1.0};
  std::optional<Frame> frame;
};

Result<NrrdSpace> nrrdSpace(const Source& source, const NrrdHeader& header);

/// Returns millimetres per unit of the space; 0 where the unit is not known.
double nrrdUnit(const NrrdHeader& header);

/// Reads the segments of 3D Slicer: Segment7_Name, _LabelValue, _Layer and _Color ("0.5 0.7 0.1").
LabelNames nrrdSegments(const NrrdHeader& header, bool layered, std::size_t layer);

}  // namespace sline::model
