// SPDX-License-Identifier: Apache-2.0
// Asks what the selected structures look like, for the rows of the panel.
#pragma once

#include <algorithm>
#include <vector>

#include "model/edit/node_sets.h"
#include "model/scene/resolved_styles.h"
#include "widgets/session/session.h"

namespace sline::widgets {

/// Returns the looks of the selected structures; a group without structures has its own.
inline std::vector<model::ResolvedStyle> looksOf(const model::Scene& scene, const NodeIds& ids) {
  std::vector<model::ResolvedStyle> looks;
  for (const model::ResolvedStructure& structure : model::resolvedBelow(scene, ids))
    looks.push_back(structure.style);
  if (looks.empty() && !ids.empty())
    looks.push_back(scene.resolve(ids.front()));
  return looks;
}

/// Tells whether one of the nodes has a value of its own.
template <class Says>
bool anyOfSays(const model::Scene& scene, const model::NodeSet& asked, const Says& says) {
  const std::vector<model::Node>& nodes = scene.nodes();
  return std::any_of(nodes.begin(), nodes.end(), [&](const model::Node& node) {
    return asked.contains(node.id.value) && says(node.style);
  });
}

/// Tells the same of the nodes and all below them, which a reset makes inherit again.
template <class Says>
bool anyBelowSays(const model::Scene& scene, const NodeIds& ids, const Says& says) {
  return anyOfSays(scene, model::withAllBelow(scene, model::setOf(ids)), says);
}

}  // namespace sline::widgets
