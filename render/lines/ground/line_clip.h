// SPDX-License-Identifier: Apache-2.0
// Cuts a line within a triangle to where one sees it and where it is strong enough.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/camera/camera.h"
#include "model/geometry/surface.h"
#include "render/lines/ground/segments.h"

namespace sline::render {

/// An end of a line in a triangle.
struct LineEnd {
  glm::vec3 position{0.0f};
  glm::vec3 normal{0.0f};  ///< outward, of any length
  float nv = 0.0f;
  float strength = 0.0f;  ///< above the threshold the line is drawn
};

/// Describes what of a line is drawn.
struct LineClip {
  float least = 0.0f;     ///< the threshold; twice of it is drawn in full
  bool twoSided = false;  ///< inner sides count too
  /// Seen from within, the strength has the other sign, as curvature has.
  bool signedStrength = false;
};

/// Narrows a range of a line, 0 … 1, to where a value that is linear along it is positive; the
/// range is empty where it is so nowhere.
void keepWherePositive(float atA, float atB, std::array<float, 2>& range);

/// Appends what is drawn of the line, for each side of the surface that counts. Where it is
/// stronger it enters earlier (Segment::entryA).
void appendClipped(const std::array<LineEnd, 2>& ends, const LineClip& clip, std::uint32_t triangle,
                   std::vector<Segment>& segments);

/// Lets the strongest lines enter first.
void rankByStrength(std::vector<Segment>& segments, const model::Surface& surface,
                    const model::Camera& camera, float t);

}  // namespace sline::render
