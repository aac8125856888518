// SPDX-License-Identifier: Apache-2.0
// Determines where the frames of an image lie and what their values mean.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "model/import/dicom/dicom_file.h"

namespace sline::model {

struct FrameAttributes {
  std::optional<std::uint32_t> segment;  ///< the segment of a segmentation that it shows
  glm::dvec3 position{0.0};              ///< centre of the first pixel, mm LPS
  glm::dvec3 along{1, 0, 0};             ///< unit vector; the direction in which columns follow
                                         ///< each other
  glm::dvec3 down{0, 1, 0};              ///< unit vector; the direction in which rows follow each
                                         ///< other
  double columnSpacing = 1.0;            ///< mm
  double rowSpacing = 1.0;
  double sliceSpacing = 0.0;  ///< mm; 0: not given
  double slope = 1.0;         ///< value = slope × stored + intercept
  double intercept = 0.0;
  std::string unit;  ///< "HU"; empty: not given
};

/// Returns the frames in the order of the pixel data. They are read from the functional groups
/// (PS3.3 §C.7.6.16), a frame's own before the shared ones, or where there are no groups from the
/// image itself, which then is one frame. It is an error where a frame has no position, orientation
/// or pixel spacing.
Result<std::vector<FrameAttributes>> frameAttributesIn(const DicomFile& file);

}  // namespace sline::model
