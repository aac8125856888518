// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/formats/analyze_geometry.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "model/import/source/values.h"

namespace sline::model {

namespace {
constexpr std::size_t sizesAt = 40;         // dim: their number, then each
constexpr std::size_t unitAt = 56;          // vox_units: four letters
constexpr std::size_t spacingAt = 76;       // pixdim
constexpr std::size_t orientationAt = 252;  // hist.orient
constexpr std::size_t originAt = 253;       // hist.originator, as SPM uses it

/// Lists where the voxels' axes lead, as (to the side, anterior, superior): slices across, from the
/// front or from the side, and the same three upside down.
using Axes = std::array<glm::dvec3, 3>;
constexpr glm::dvec3 toSide{1.0, 0.0, 0.0};
constexpr glm::dvec3 toFront{0.0, 1.0, 0.0};
constexpr glm::dvec3 toHead{0.0, 0.0, 1.0};
constexpr std::array<Axes, 6> orientations = {
    Axes{toSide, toFront, toHead},  Axes{toSide, toHead, toFront},  Axes{toFront, toHead, toSide},
    Axes{toSide, -toFront, toHead}, Axes{toSide, -toHead, toFront}, Axes{toFront, -toHead, toSide}};
}  // namespace

AnalyzeGeometry analyzeGeometry(const char* header, bool swap) {
  AnalyzeGeometry place;
  const std::string_view unit(header + unitAt, 2);
  const double scale = unit == "cm" ? 10.0 : unit == "um" ? 0.001 : 1.0;
  place.unitReason = unit == "cm"   ? "header: centimetres"
                     : unit == "um" ? "header: micrometres"
                     : unit == "mm" ? "header: millimetres"
                                    : "Analyze without a unit is in millimetres";
  const auto code = std::size_t(static_cast<unsigned char>(header[orientationAt]));
  const Axes& axes = orientations[code < orientations.size() ? code : 0];
  glm::dvec3 origin(0.0);
  bool counted = true;
  for (int i = 0; i < 3; ++i) {
    double spacing =
        std::abs(double(loadAs<float>(header + spacingAt + 4 * (std::size_t(i) + 1), swap)));
    if (!std::isfinite(spacing) || spacing == 0.0)
      spacing = 1.0;
    place.toMillimetres[i] = glm::dvec4(axes[std::size_t(i)] * spacing * scale, 0.0);
    const int voxel = loadAs<std::int16_t>(header + originAt + 2 * std::size_t(i), swap);
    const int size = loadAs<std::int16_t>(header + sizesAt + 2 * (std::size_t(i) + 1), swap);
    counted = counted && voxel >= 1 && voxel <= size;
    origin[i] = double(voxel - 1);
  }
  if (counted)
    place.toMillimetres[3] =
        glm::dvec4(-glm::dvec3(place.toMillimetres * glm::dvec4(origin, 0.0)), 1.0);
  return place;
}

}  // namespace sline::model
