// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "model/geometry/mesh.h"

namespace sline::model {

/// Returns the smallest sphere around the points, to 1e-5 of its radius. Its radius is the feature
/// size F that makes every threshold dimensionless (S §3.1, METHOD §1). Without points the radius
/// is 0.
Sphere smallestBoundingSphere(std::span<const glm::vec3> points);

}  // namespace sline::model
