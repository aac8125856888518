// SPDX-License-Identifier: Apache-2.0
// Hatches surfaces for the tests, and measures their strokes.
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "model/camera/camera.h"
#include "render/lines/hatching/hatching.h"

namespace sline::test {

model::Camera orthographic(const glm::vec3& direction, float heightMm);

inline const glm::vec3 slanted{0.2f, -0.7f, 0.8f};

inline constexpr float longest = render::longestHatchStroke / render::hatchSpacing;

struct Subject {
  model::SurfacePtr surface;
  mutable render::StrokeLayout layout;

  explicit Subject(const model::MeshPtr& mesh, float length = longest)
      : surface(model::prepareSurface(mesh)), layout(surface, length) {}
  render::Hatching hatched(const model::Camera& camera,
                           const render::HatchingRequest& request = {}) const {
    return render::extractHatching(layout, camera, request);
  }
};

Subject torusSubject();

std::span<const render::HatchPoint> pointsOf(const render::Hatching& h,
                                             const render::HatchStroke& s);

/// Returns the ink in λ², overlaps and hidden parts included.
double ink(const render::Hatching& hatching, const model::Camera& camera);

}  // namespace sline::test
