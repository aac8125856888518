// SPDX-License-Identifier: Apache-2.0
// Lines are geometry first: (surface, camera, thresholds) → segments. The picture, the vector
// export, the tests and the web page all use these same segments. No OpenGL in here.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "model/base/units.h"
#include "model/geometry/surface.h"
#include "model/scene/camera.h"

namespace sline::render {

/// A piece of a line within one triangle; a and b lie on the triangle, patient frame, mm.
struct Segment {
  glm::vec3 a{0.0f};
  glm::vec3 b{0.0f};
  glm::vec3 normalA{0.0f};  ///< interpolated unit normals, on the side that faces the eye
  glm::vec3 normalB{0.0f};
  float opacityA = 1.0f;  ///< 0 … 1: lines fade towards their thresholds
  float opacityB = 1.0f;
  float entryA = 0.0f;  ///< suggestive contours: the T_SC at which S eq. 9 lets the point in, 0 … 1
  float entryB = 0.0f;
  std::uint32_t triangle = 0;
  bool concave = false;  ///< contours only: radial curvature < 0, hidden on any closed surface
};

/// Where a line may be (METHOD §5), made dimensionless with F.
struct LineThresholds {
  float minimumDerivative = 1.0f;  ///< t_d: Dκr·F² must be above
  float minimumAngle = 0.05f;      ///< θ_c in radians: acos(nv) must be above
};
inline constexpr float defaultMinimumDerivative = 1.0f;  ///< t_dmin
inline constexpr float defaultMinimumAngle = 0.05f;      ///< θ_cmin

/// T_SC of METHOD §7 and the thresholds it gives (S eq. 9).
LineThresholds suggestiveThresholds(Gamma gamma);

struct LineRequest {
  bool contours = true;
  bool suggestive = true;
  LineThresholds thresholds;
  /// Treats the inner side as a surface too (METHOD §1 "seen from behind"): open shells, or a
  /// camera inside a closed one.
  bool twoSided = false;
};

struct LineSet {
  std::vector<Segment> contours;
  std::vector<Segment> suggestive;
  std::vector<Segment> section;  ///< outlines of cut faces (cut_faces.h), no matter from where seen
};

/// Contours: zero crossings of nv (METHOD §4). Suggestive contours: zero crossings of κr with
/// Dκr·F² > t_d and acos(nv) > θ_c (METHOD §5, DeCarlo et al. 2003). Parallel; the order of
/// segments depends on the surface alone.
LineSet extractLines(const model::Surface& surface, const model::Camera& camera,
                     const LineRequest& request);

/// True where lines of this surface need both sides: it is open, or the eye is inside its box.
bool needsTwoSides(const model::Surface& surface, const model::Camera& camera);

}  // namespace sline::render
