// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "model/scene/camera.h"
#include "model/scene/scene.h"

namespace sline::bench {

/// Sets Γ for all, or from 0 to 5 over the structures sorted by name.
model::Scene withGamma(const model::Scene& scene, std::optional<float> gamma);

/// Returns the anterior camera turned about the vertical through the middle of the scene; 1 is a
/// whole turn.
model::Camera turned(const model::Camera& start, float share);

}  // namespace sline::bench
