// SPDX-License-Identifier: Apache-2.0
// Reads what a segmentation says about its segments.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/base/units.h"
#include "model/import/dicom/dicom_file.h"

namespace sline::model {

struct Segment {
  std::string name;
  std::vector<std::string> groups;  ///< the segment's category
  std::optional<Colour> colour;
};
/// Returns the segments by their number, from the segment sequence (PS3.3 §C.8.20.4).
std::map<std::uint32_t, Segment> segmentsIn(const DicomFile& file);

/// Converts CIELab as DICOM codes it (PS3.3 §C.10.7.1.1, white of D50) to sRGB.
Colour colourOfLab(const std::array<std::uint16_t, 3>& lab);

}  // namespace sline::model
