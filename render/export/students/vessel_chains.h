// SPDX-License-Identifier: Apache-2.0
// Finds groups whose structures are a chain of vessels, each of which touches the next alone.
#pragma once

#include <vector>

#include "model/scene/scene.h"

namespace sline::render {

struct VesselChain {
  model::NodeId group;
  std::vector<model::NodeId> vessels;  ///< in the direction in which blood flows
};

/// Returns the chains of at least three and at most twelve visible vessels, in tree order. Blood
/// comes from the wider end, in veins it flows there.
std::vector<VesselChain> vesselChains(const model::Scene& scene);

}  // namespace sline::render
