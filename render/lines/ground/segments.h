// SPDX-License-Identifier: Apache-2.0
// Lines are geometry first: segments on a surface. The picture, the vector export, the tests and
// the web page all use these same segments.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <vector>

namespace sline::render {

/// A segment is a piece of a line within one triangle; a and b lie on the triangle, patient frame,
/// mm.
struct Segment {
  glm::vec3 a{0.0f};
  glm::vec3 b{0.0f};
  glm::vec3 normalA{0.0f};  ///< interpolated unit normals, on the side that faces the eye
  glm::vec3 normalB{0.0f};
  float opacityA = 1.0f;  ///< 0 … 1: lines fade towards their thresholds
  float opacityB = 1.0f;
  float entryA = 0.0f;  ///< suggestive contours: the T_SC at which S eq. 9 lets the point in, 0 … 1
  float entryB = 0.0f;
  float gammaA = 0.0f;  ///< Γ there, where it varies over the structure; else without a meaning
  float gammaB = 0.0f;
  /// The move from the line to the curve that a pen draws in its place (METHOD §11.2), mm, across
  /// the view.
  glm::vec3 moveA{0.0f};
  glm::vec3 moveB{0.0f};
  float pressureA = 1.0f;  ///< times the pen's width (METHOD §11.4)
  float pressureB = 1.0f;
  std::uint32_t triangle = 0;
  bool concave = false;  ///< contours only: radial curvature < 0, hidden on any closed surface
};

/// Lists the kinds of lines in the order in which they are drawn over each other; each is an index
/// into `lineTechniques()`.
enum class LineKind : std::uint8_t {
  suggestive,
  confis,
  hatchingStreamline,
  apparentRidge,
  ridge,
  valley,
  photic,
  laplacian,
  demarcating,
  suggestiveHighlight,
  principalHighlight,
  contour,
  section
};
inline constexpr std::size_t lineKindCount = 13;

class LineKinds {
 public:
  constexpr LineKinds(std::initializer_list<LineKind> kinds) {
    for (const LineKind kind : kinds)
      add(kind);
  }
  constexpr void add(LineKind kind) { m_bits |= 1u << unsigned(kind); }
  constexpr void add(LineKinds kinds) { m_bits |= kinds.m_bits; }
  constexpr bool empty() const { return m_bits == 0; }
  constexpr bool has(LineKind kind) const { return ((m_bits >> unsigned(kind)) & 1u) != 0; }

 private:
  std::uint32_t m_bits = 0;
};

/// Holds the segments of each kind.
class LineSet {
 public:
  std::vector<Segment>& operator[](LineKind kind) { return m_segments[std::size_t(kind)]; }
  const std::vector<Segment>& operator[](LineKind kind) const {
    return m_segments[std::size_t(kind)];
  }

 private:
  std::array<std::vector<Segment>, lineKindCount> m_segments;
};

}  // namespace sline::render
