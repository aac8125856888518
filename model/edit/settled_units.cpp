// SPDX-License-Identifier: Apache-2.0
#include "model/edit/settled_units.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "model/scene/known_frame.h"

namespace sline::model {

bool hasDoubtedUnits(const Scene& scene) {
  return std::any_of(scene.nodes().begin(), scene.nodes().end(),
                     [](const Node& node) { return isUnitDoubted(node.provenance); });
}

Edited withUnitsSettled(const Scene& scene) {
  if (!hasDoubtedUnits(scene))
    return {scene, false};
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes)
    if (isUnitDoubted(node.provenance)) {
      node.provenance.unitReason = chosenReason;
      node.provenance.unitEvidence = Evidence::settled;
    }
  Scene settled = scene;
  settled.setNodes(std::move(nodes));
  return {std::move(settled), true};
}

}  // namespace sline::model
