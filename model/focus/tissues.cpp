// SPDX-License-Identifier: Apache-2.0
#include "model/focus/tissues.h"

#include "model/anatomy/body_systems.h"

namespace sline::model {

Tissues tissuesOf(const Scene& scene) {
  static const AnatomyTable table;
  Tissues tissues;
  for (const Node& node : scene.nodes()) {
    const auto match = table.match(node.name);
    const auto above = tissues.find(node.parent.value);
    const Tissue inherited = above == tissues.end() ? Tissue::unknown : above->second;
    tissues[node.id.value] = match ? table.systems()[match->system].tissue : inherited;
  }
  return tissues;
}

}  // namespace sline::model
