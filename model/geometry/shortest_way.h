// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "model/geometry/nearest_point.h"

namespace sline::model {

/// Holds the two points, one on either surface, between which two surfaces are nearest.
struct ShortestWay {
  PointOnMesh from;
  PointOnMesh to;
};

/// Returns the shortest way between the surfaces; none where one has no triangle. It is found from
/// the corner nearest to the other surface, by going from each point to the nearest of the other
/// surface until that changes nothing (von Neumann's alternating projections).
std::optional<ShortestWay> shortestWay(const MeshPtr& a, const MeshPtr& b);

}  // namespace sline::model
