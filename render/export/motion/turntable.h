// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>

#include "model/scene/scene.h"

namespace sline::render {

/// A turntable moves a camera once around what it looks at, or around everything, about the
/// patient's long axis: from the front to the patient's left, the back, the right. A camera that
/// looks along that axis turns about its own upward direction instead.
class Turntable {
 public:
  /// Prepares the turn. Where everything visible is within the picture and would leave it on the
  /// way, the camera is moved so that it turns about the middle of it all and nothing leaves; a
  /// camera that is close up stays, and so does one that has room. `aspect` is width / height,
  /// `share` is the part of the width and the height that the anatomy may take.
  Turntable(const model::Scene& scene, const model::Camera& camera, float aspect,
            const glm::vec2& share = glm::vec2(1.0f));

  /// Returns the camera at `part` of the turn, 0 … 1.
  model::Camera at(double part) const;

 private:
  model::Camera m_camera;
  glm::vec3 m_axis{0.0f, 0.0f, 1.0f};
  glm::vec3 m_middle{0.0f};  ///< on the axis
};

}  // namespace sline::render
