// SPDX-License-Identifier: Apache-2.0
// Measures how steady lines are while the camera turns, and how true curves are.
#pragma once

#include <string>
#include <vector>

#include "model/camera/camera.h"
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

/// Returns for each of these structures, alone, how many suggestive strokes a pen draws and how
/// long they are together: on the surface as it is and at the picture's scale, where it fills the
/// picture from the front and seen by the run's camera.
std::string measureScales(const TurningRun& run, const std::vector<model::NodeId>& structures);

}  // namespace sline::bench
