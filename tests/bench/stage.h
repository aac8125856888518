// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "model/base/result.h"
#include "model/camera/camera.h"
#include "model/scene/scene.h"
#include "render/picture/picture.h"
#include "tests/bench/measure.h"

namespace sline::bench {

/// Sets Γ for all, or from 0 to 5 over the structures sorted by name.
model::Scene withGamma(const model::Scene& scene, std::optional<float> gamma);

/// Returns the scene with each of its surfaces subdivided once.
model::Scene subdivided(const model::Scene& scene);

/// Returns the anterior camera turned about the vertical through the middle of the scene; 1 is a
/// whole turn.
model::Camera turned(const model::Camera& start, float share);

/// What is drawn, from where, how large and how often.
struct Stage {
  model::Scene scene;
  model::Camera camera;
  render::PictureSettings settings;
  int frames;
};

/// Calls draw for every step of the turn, after one frame to warm up; returns the times in
/// milliseconds.
template <class Draw>
Result<std::vector<double>> timed(int frames, const model::Camera& start, const Draw& draw) {
  if (const Status status = draw(turned(start, 0.5f / float(frames))); !status)
    return status.error();
  std::vector<double> times;
  for (int i = 0; i < frames; ++i) {
    const model::Camera camera = turned(start, float(i) / float(frames));
    const Stopwatch watch;
    if (const Status status = draw(camera); !status)
      return status.error();
    times.push_back(watch.milliseconds());
  }
  return times;
}

}  // namespace sline::bench
