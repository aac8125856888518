// SPDX-License-Identifier: Apache-2.0
#include "model/scene/visible_structures.h"

#include "model/scene/resolved_styles.h"

namespace sline::model {

std::vector<VisibleStructure> visibleStructures(const Scene& scene) {
  const std::vector<ResolvedStyle> styles = resolveAll(scene);
  std::vector<VisibleStructure> visible;
  for (std::size_t i = 0; i < styles.size(); ++i) {
    const Node& node = scene.nodes()[i];
    if (!node.isGroup() && styles[i].visible && node.mesh->triangleCount() > 0)
      visible.push_back({&node, styles[i]});
  }
  return visible;
}

}  // namespace sline::model
