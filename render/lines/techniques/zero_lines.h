// SPDX-License-Identifier: Apache-2.0
// Finds lines where a value of the vertices becomes zero, in one cluster of a surface.
#pragma once

#include <array>
#include <optional>

#include "render/lines/ground/cluster_walk.h"
#include "render/lines/ground/line_clip.h"

namespace sline::render {

/// What is known of a line at a vertex.
struct ZeroSample {
  float value = 0.0f;     ///< zero on the line
  float strength = 0.0f;  ///< see LineEnd
  /// The value falls along this vector, in space, where the line counts; zero: it counts anyway.
  glm::vec3 falls{0.0f};
};

/// Appends the lines of the cluster. `sampleAt` returns the sample of a vertex by its number in the
/// mesh; it is asked once for each vertex of a triangle that may show.
template <class SampleAt>
class ZeroLines {
 public:
  ZeroLines(const ClusterWalk& walk, const LineClip& clip, SampleAt sampleAt)
      : m_walk(walk), m_clip(clip), m_sampleAt(std::move(sampleAt)) {}

  void extract(std::vector<Segment>& segments) {
    for (std::uint32_t i = 0; i < m_walk.cluster().triangleCount; ++i)
      add(i, segments);
  }

 private:
  const ZeroSample& at(std::uint8_t local) {
    std::optional<ZeroSample>& sample = m_samples[local];
    if (!sample) {
      sample = m_sampleAt(m_walk.vertex(local));
      m_values[local] = sample->value;
    }
    return *sample;
  }

  /// Returns the corner with another sign than the two others; 3 where all are equal.
  std::size_t oddCorner(const ClusterWalk::Local& local) const {
    const bool n0 = m_values[local[0]] < 0.0f;
    const bool n1 = m_values[local[1]] < 0.0f;
    const bool n2 = m_values[local[2]] < 0.0f;
    if (n0 == n1 && n1 == n2)
      return 3;
    return n1 == n2 ? 0 : n0 == n2 ? 1 : 2;
  }

  bool mayShow(const ClusterWalk::Local& local) const {
    return m_clip.twoSided || m_walk.facing()[local[0]] > 0.0f ||
           m_walk.facing()[local[1]] > 0.0f || m_walk.facing()[local[2]] > 0.0f;
  }

  void add(std::uint32_t triangle, std::vector<Segment>& segments) {
    const ClusterWalk::Local& local = m_walk.local(triangle);
    if (!mayShow(local))
      return;
    for (const std::uint8_t corner : local)
      at(corner);
    const std::size_t odd = oddCorner(local);
    if (odd == 3 || !falls(local))
      return;
    const std::array<Crossing, 2> on =
        m_walk.ends(local, odd, [this](std::uint8_t vertex) { return m_values[vertex]; });
    appendClipped({endAt(on[0]), endAt(on[1])}, m_clip, m_walk.triangle(triangle), segments);
  }

  LineEnd endAt(const Crossing& on) {
    return {.position = on.position,
            .normal = on.normal,
            .nv = on.nv,
            .strength = on.mix(at(on.a).strength, at(on.b).strength)};
  }

  /// Tells whether the value, linear over the triangle, falls along the mean of its corners'
  /// vectors.
  bool falls(const ClusterWalk::Local& local) {
    const glm::vec3 along = at(local[0]).falls + at(local[1]).falls + at(local[2]).falls;
    if (along == glm::vec3(0.0f))
      return true;
    const auto positions = m_walk.surface().mesh->positions();
    const glm::vec3& p = positions[m_walk.vertex(local[0])];
    const glm::vec3 u = positions[m_walk.vertex(local[1])] - p;
    const glm::vec3 v = positions[m_walk.vertex(local[2])] - p;
    const glm::vec3 n = glm::cross(u, v);
    const glm::vec3 gradient = (m_values[local[1]] - m_values[local[0]]) * glm::cross(v, n) +
                               (m_values[local[2]] - m_values[local[0]]) * glm::cross(n, u);
    return glm::dot(gradient, along) < 0.0f;
  }

  const ClusterWalk& m_walk;
  LineClip m_clip;
  SampleAt m_sampleAt;
  std::array<std::optional<ZeroSample>, model::Clusters::maximumVertices> m_samples;
  ClusterWalk::Field m_values{};
};

}  // namespace sline::render
