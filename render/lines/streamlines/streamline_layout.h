// SPDX-License-Identifier: Apache-2.0
// Keeps the streamlines of a surface that ConFIS and streamline hatching draw, for all views.
//
// ▲ The paper starts a line in every triangle, and where triangles are smaller than strokes are
// wide, that is fur. Lines that start on one streamline lie on top of each other; so lines are laid
// here that stay a distance apart, one after the other at ever smaller distances, each where most
// room is left (after B. Jobard and W. Lefer, "Creating Evenly-Spaced Streamlines of Arbitrary
// Density", 1997). A view draws those whose distance it shows well enough, and lets the next ones
// grow in between as it comes nearer: neither turning nor zooming moves a line or takes one away.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/geometry/surface.h"

namespace sline::render {

inline constexpr float waySteps = 65535.0f;
inline constexpr float featureSteps = 32.0f;
inline constexpr float bendSteps = 32767.0f;  ///< of the largest entry of S·F_c in a line

/// A point of a line with what a view needs to know there, in 36 bytes.
struct StreamlinePoint {
  glm::vec3 position{0.0f};  ///< on the surface, patient frame, mm
  std::uint32_t triangle = 0;
  std::uint32_t normal = 0;         ///< unit, outwards: glm::packSnorm3x10_1x2
  std::array<std::int16_t, 6> s{};  ///< S·F_c in space (xx, xy, xz, yy, yz, zz), in `bendSteps`
  std::uint16_t way = 0;            ///< from the line's first end, in `waySteps` of its length
  std::uint8_t feature = 0;  ///< |H|·F_c where H has an extremum, in `featureSteps` of 1; else 0
};

/// Returns a component (0 … 2) of a normal that glm::packSnorm3x10_1x2 has packed. Several are
/// unpacked at once where a loop does so.
inline float normalComponent(std::uint32_t packed, int component) {
  return float(std::int32_t(packed << (22 - 10 * component)) >> 22) * (1.0f / 511.0f);
}
/// Returns a point's unit normal, outwards.
inline glm::vec3 normalOf(const StreamlinePoint& point) {
  return {normalComponent(point.normal, 0), normalComponent(point.normal, 1),
          normalComponent(point.normal, 2)};
}

struct Streamline {
  std::uint32_t first = 0;  ///< in `points`
  std::uint32_t count = 0;
  float distance = 0.0f;  ///< mm, from lines that were laid before
  float reach = 0.0f;     ///< mm that a line goes either way from where it starts
  float length = 0.0f;    ///< mm
  model::Sphere bounds;
  glm::vec3 axis{0.0f};   ///< unit, the mean direction of its normals
  float within = 1.0f;    ///< the cosine of the largest angle between the axis and a normal
  float steepest = 0.0f;  ///< the largest |κ|·F_c
  float bend = 0.0f;      ///< the largest entry of S·F_c, 1/mm·F_c, which points hold in steps
  float feature = 0.0f;   ///< the largest |H|·F_c of an extremum
};

/// |H|·F_c from which on extrema are laid out first.
inline constexpr float usualFeature = 0.6f;

/// Says how long lines are.
struct StreamlineLengths {
  double reach = 1.0;  ///< times π/(3·max(|κ1|, |κ2|)) that a line goes at most either way
  double least = 0.2;  ///< share of all it may go that is worth drawing
};

class StreamlineLayout {
 public:
  explicit StreamlineLayout(const model::Surface& surface, const StreamlineLengths& lengths = {});

  /// Returns the lines; their distances never grow.
  std::span<const Streamline> lines() const { return m_lines; }
  std::span<const StreamlinePoint> points(const Streamline& line) const {
    return std::span(m_points).subspan(line.first, line.count);
  }
  /// Returns what the lines take.
  std::size_t bytes() const;

 private:
  class Builder;

  std::vector<Streamline> m_lines;
  std::vector<StreamlinePoint> m_points;
};

}  // namespace sline::render
