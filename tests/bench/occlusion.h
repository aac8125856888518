// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "model/scene/scene.h"

namespace sline::bench {

/// Returns a row for each structure: its triangles, the time of its ambient occlusion, and that
/// time for a million such triangles; rays' trees are made anew.
std::string measureOcclusion(const model::Scene& scene);

}  // namespace sline::bench
