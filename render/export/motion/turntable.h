// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/scene/scene.h"

namespace sline::render {

/// A camera's way once around what it looks at, about the patient's long axis: from the front to
/// the patient's left, the back, the right. A camera that looks along that axis goes about its own
/// upward direction instead.
class Turntable {
 public:
  /// Where all that is visible is within the picture, the camera steps back as far as it must so
  /// that nothing leaves it on the way; one that is close up stays. `aspect` is width / height,
  /// `share` what of the width the anatomy may have.
  Turntable(const model::Scene& scene, const model::Camera& camera, float aspect,
            float share = 1.0f);

  /// `part` of the turn, 0 … 1.
  model::Camera at(double part) const;

 private:
  model::Camera m_camera;
  glm::vec3 m_axis{0.0f, 0.0f, 1.0f};
};

}  // namespace sline::render
