// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/scene/scene.h"

namespace sline::model {

/// `Scene::resolve` of every node, in the order of `Scene::nodes`, in one pass.
std::vector<ResolvedStyle> resolveAll(const Scene& scene);

}  // namespace sline::model
