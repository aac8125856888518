// SPDX-License-Identifier: Apache-2.0
// Measures how steady lines are while the camera turns, and how true curves are.
#pragma once

#include <string>

#include "model/scene/camera.h"
#include "model/scene/scene.h"

namespace sline::bench {

struct TurningRun {
  const model::Scene& scene;
  const model::Camera& camera;
  int width;
  int height;
  int steps;
};

/// Returns the figures of that many steps of half a degree.
std::string measureTurning(const TurningRun& run);

/// Returns how far curves lie from their lines, seen from eight sides, and what thin structures
/// lose.
std::string measureCurves(const TurningRun& run);

}  // namespace sline::bench
