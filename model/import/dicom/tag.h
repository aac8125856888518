// SPDX-License-Identifier: Apache-2.0
// Names the DICOM data elements that are read, and lists those of them that are sequences: a file
// with implicit VR does not say so itself.
#pragma once

#include <array>
#include <compare>
#include <cstdint>

namespace sline::model {

struct Tag {
  std::uint16_t group = 0;
  std::uint16_t element = 0;
  auto operator<=>(const Tag&) const = default;
};

inline constexpr Tag pixelData{0x7fe0, 0x0010};

inline constexpr Tag structureSetRois{0x3006, 0x0020};
inline constexpr Tag roiContours{0x3006, 0x0039};
inline constexpr Tag contourSequence{0x3006, 0x0040};
inline constexpr Tag observations{0x3006, 0x0080};
inline constexpr Tag segmentSequence{0x0062, 0x0002};
inline constexpr Tag propertyCategory{0x0062, 0x0003};
inline constexpr Tag propertyType{0x0062, 0x000f};
inline constexpr Tag sharedGroups{0x5200, 0x9229};
inline constexpr Tag frameGroups{0x5200, 0x9230};
inline constexpr Tag positionGroup{0x0020, 0x9113};
inline constexpr Tag orientationGroup{0x0020, 0x9116};
inline constexpr Tag measuresGroup{0x0028, 0x9110};
inline constexpr Tag rescaleGroup{0x0028, 0x9145};
inline constexpr Tag segmentGroup{0x0062, 0x000a};

/// Lists every sequence that is read here.
inline constexpr std::array sequenceTags{
    structureSetRois, roiContours,   contourSequence, observations, segmentSequence,
    propertyCategory, propertyType,  sharedGroups,    frameGroups,  positionGroup,
    orientationGroup, measuresGroup, rescaleGroup,    segmentGroup};

}  // namespace sline::model
