// SPDX-License-Identifier: Apache-2.0
// Holds points in lanes of four, which are read and added in one go: filters over rings do little
// else.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/base/lanes.h"

namespace sline::model {

inline Lanes widened(const glm::vec3& point) {
  return Lanes{point.x, point.y, point.z, 0.0f};
}

inline std::vector<Lanes> widened(std::span<const glm::vec3> points) {
  std::vector<Lanes> wide(points.size());
  for (std::size_t i = 0; i < wide.size(); ++i)
    wide[i] = widened(points[i]);
  return wide;
}

inline glm::vec3 narrowed(Lanes wide) {
  return {wide[0], wide[1], wide[2]};
}

inline std::vector<glm::vec3> narrowed(std::span<const Lanes> wide) {
  std::vector<glm::vec3> points(wide.size());
  for (std::size_t i = 0; i < wide.size(); ++i)
    points[i] = narrowed(wide[i]);
  return points;
}

/// Returns the mean over a ring, which is not empty.
template <class Value, std::size_t Length>
Value ringMean(const std::vector<Value>& points, std::span<const std::uint32_t, Length> ring) {
  Value total{};
  for (const std::uint32_t other : ring)
    total += points[other];
  return total / float(ring.size());
}

}  // namespace sline::model
