// SPDX-License-Identifier: Apache-2.0
// Finds lines: (surface, camera, thresholds) → segments. No OpenGL is called here.
#pragma once

#include <array>

#include "model/camera/camera.h"
#include "model/geometry/surface.h"
#include "model/scene/light.h"
#include "render/lines/ground/segments.h"

namespace sline::render {

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

/// Finds the lines of the wanted kinds, as their techniques define them (line_technique.h). It
/// works in parallel; the order of segments depends on the surface alone.
LineSet extractLines(const model::Surface& surface, const model::Camera& camera,
                     const LineRequest& request);

/// Returns whether lines of this surface need both sides: it is open, or the eye is inside its box.
bool needsTwoSides(const model::Surface& surface, const model::Camera& camera);

}  // namespace sline::render
