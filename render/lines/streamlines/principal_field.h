// SPDX-License-Identifier: Apache-2.0
// Gives every triangle the field that ConFIS follows (METHOD §8; Lawonn, Mönch, Preim, "Streamlines
// for Illustrative Real-Time Rendering", 2013): at each corner that of its principal directions,
// with either sign, which lies nearest to a common reference, interpolated in between.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "model/geometry/surface.h"
#include "render/lines/streamlines/linear_flow.h"

namespace sline::render {

/// A corner is an umbilic where |κ1 − κ2| is no more than this share of the larger |κ|: there the
/// directions are noise.
inline constexpr float umbilicShare = 0.05f;
/// So it is where the larger |κ|·F_c is no more than this.
inline constexpr float flatCurvature = 0.02f;

class PrincipalField {
 public:
  explicit PrincipalField(const model::Surface& surface);

  const model::Surface& surface() const { return m_surface; }

  /// Returns the unit direction, of either sign, of the curvature of larger magnitude of the
  /// triangle's own tensor, the mean of its corners'. ▲ The paper says "maximum"; by the signed one
  /// a trachea would be ringed from outside and lined along from inside. It is zero where a corner
  /// is an umbilic, so that no line starts there.
  glm::dvec3 direction(std::uint32_t triangle) const { return m_directions[triangle]; }
  /// Returns the larger |κ| of the triangle's tensor, 1/mm.
  float curvature(std::uint32_t triangle) const { return m_curvatures[triangle]; }

  /// Places within a triangle, and directions along it.
  struct Frame {
    glm::dvec3 origin;
    glm::dvec3 u;  ///< from corner 0 to corner 1, mm
    glm::dvec3 v;  ///< from corner 0 to corner 2
    double inradius = 0.0;

    glm::dvec3 place(const glm::dvec2& at) const { return origin + at.x * u + at.y * v; }
    glm::dvec3 along(const glm::dvec2& direction) const {
      return direction.x * u + direction.y * v;
    }
    /// Returns the components of u and v of a direction's part in the plane.
    glm::dvec2 components(const glm::dvec3& direction) const;
  };
  Frame frame(std::uint32_t triangle) const;
  /// Returns the field that lies nearest to the reference; its vectors have a length of 1 mm at the
  /// corners, but at an umbilic, where they are zero.
  LinearFlow flow(std::uint32_t triangle, const Frame& frame, const glm::dvec3& reference) const;

 private:
  bool isUmbilic(std::uint32_t vertex) const;

  const model::Surface& m_surface;
  std::vector<glm::vec3> m_directions;
  std::vector<float> m_curvatures;
};

}  // namespace sline::render
