// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "model/scene/scene.h"

namespace sline::model {

/// Returns `Scene::resolve` of every node, in the order of `Scene::nodes`, in one pass.
std::vector<ResolvedStyle> resolveAll(const Scene& scene);

struct ResolvedStructure {
  const Node* node = nullptr;  ///< a node of the scene that was passed in
  ResolvedStyle style;
};
/// Returns the structures at or below any of the nodes (the root: all), each once, in tree order,
/// in one pass for any number of nodes.
std::vector<ResolvedStructure> resolvedBelow(const Scene& scene, std::span<const NodeId> ids);

}  // namespace sline::model
