// SPDX-License-Identifier: Apache-2.0
// What a segmentation says about its segments and where its frames lie.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/base/units.h"
#include "model/import/dicom/dicom_file.h"

namespace sline::model {

struct Segment {
  std::string name;
  std::vector<std::string> groups;  ///< its category
  std::optional<Colour> colour;
};
/// Segments by their number, from the segment sequence (PS3.3 §C.8.20.4).
Result<std::map<std::uint32_t, Segment>> segmentsIn(const DicomFile& file);

/// The functional groups of one frame (PS3.3 §C.7.6.16).
struct FramePlace {
  std::uint32_t segment = 0;
  glm::dvec3 position{0.0};   ///< centre of the first pixel, mm LPS
  glm::dvec3 along{1, 0, 0};  ///< unit; the direction in which columns follow
  glm::dvec3 down{0, 1, 0};   ///< unit; the direction in which rows follow
  double columnSpacing = 1.0;
  double rowSpacing = 1.0;
  double sliceSpacing = 0.0;  ///< mm; 0: not given
};
/// In the order of the pixel data; a frame's own groups before the shared ones. An error where one
/// has no segment, position, orientation or pixel spacing.
Result<std::vector<FramePlace>> framesIn(const DicomFile& file);

/// CIELab as DICOM codes it (PS3.3 §C.10.7.1.1, white of D50) in sRGB.
Colour colourOfLab(const std::array<std::uint16_t, 3>& lab);

}  // namespace sline::model
