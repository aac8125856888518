// SPDX-License-Identifier: Apache-2.0
// Measures what the lines of a technique cost: once for each surface, and in each view.
#pragma once

#include <string>
#include <vector>

#include "model/camera/camera.h"
#include "model/scene/scene.h"
#include "model/scene/style.h"

namespace sline::bench {

struct TechniqueRun {
  const model::Scene& scene;
  model::Technique technique;
  std::vector<model::Camera> cameras;
  float aspect = 16.0f / 9.0f;
};

/// Returns the figures of every surface and of all together: the time that preparation takes, how
/// much it keeps, and the time that finding the lines takes from the cameras.
std::string measureTechnique(const TechniqueRun& run);

/// Returns the scene as the technique draws it, at the Γ at which all of its lines have entered.
model::Scene drawnBy(const model::Scene& scene, model::Technique technique);

}  // namespace sline::bench
