// SPDX-License-Identifier: Apache-2.0
// Holds points as vectors of four, which are read and added in one go, as those of three are not:
// filters over rings do little else.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace sline::model {

inline std::vector<glm::vec4> widened(std::span<const glm::vec3> points) {
  std::vector<glm::vec4> wide(points.size());
  for (std::size_t i = 0; i < wide.size(); ++i)
    wide[i] = glm::vec4(points[i], 0.0f);
  return wide;
}

inline std::vector<glm::vec3> narrowed(std::span<const glm::vec4> wide) {
  return {wide.begin(), wide.end()};
}

/// Returns the mean over a ring, which is not empty.
template <class Value>
Value ringMean(const std::vector<Value>& points, std::span<const std::uint32_t> ring) {
  Value total(0.0f);
  for (const std::uint32_t other : ring)
    total += points[other];
  return total / float(ring.size());
}

}  // namespace sline::model
