// SPDX-License-Identifier: Apache-2.0
// Lines are geometry first: (surface, camera, thresholds) → segments. The picture, the vector
// export, the tests and the web page all use these same segments. No OpenGL is called here.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <vector>

#include "model/geometry/surface.h"
#include "model/scene/camera.h"
#include "model/scene/light.h"

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

/// Holds a value for each threshold of each kind of line (see `LineTechnique::thresholds`).
class LineThresholds {
 public:
  static constexpr std::size_t most = 4;  ///< of one kind

  /// Takes the usual values.
  LineThresholds();
  float of(LineKind kind, std::size_t which) const { return m_values[std::size_t(kind)][which]; }
  void set(LineKind kind, std::size_t which, float value) {
    m_values[std::size_t(kind)][which] = value;
  }

 private:
  std::array<std::array<float, most>, lineKindCount> m_values{};
};

class LinePreparations;

struct LineRequest {
  LineKinds kinds{LineKind::contour, LineKind::suggestive};
  LineThresholds thresholds;
  /// Treats the inner side as a surface too (METHOD §1 "seen from behind"): open shells, or a
  /// camera inside a closed one.
  bool twoSided = false;
  /// Also finds contours that a surface with an outside only always hides (see Segment::concave).
  bool hiddenContours = true;
  /// The picture's width over its height: kinds that are many lines leave out what lies outside. 0:
  /// nothing does.
  float aspect = 0.0f;
  /// Keeps what techniques compute once for the surface. Null: it is computed for this request.
  LinePreparations* preparations = nullptr;
  /// Towards the light of kinds that tell tone, in the camera's frame.
  glm::vec3 light = model::upperLeftLight;
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

/// Finds the lines of the wanted kinds, as their techniques define them (line_technique.h). It
/// works in parallel; the order of segments depends on the surface alone.
LineSet extractLines(const model::Surface& surface, const model::Camera& camera,
                     const LineRequest& request);

/// Returns whether lines of this surface need both sides: it is open, or the eye is inside its box.
bool needsTwoSides(const model::Surface& surface, const model::Camera& camera);

}  // namespace sline::render
