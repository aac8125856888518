// SPDX-License-Identifier: Apache-2.0
#include "model/scene/resolved_styles.h"

#include <unordered_set>

namespace sline::model {

std::vector<ResolvedStructure> resolvedBelow(const Scene& scene, std::span<const NodeId> ids) {
  std::unordered_set<std::uint64_t> meant;
  for (const NodeId id : ids)
    meant.insert(id.value);
  const bool all = meant.contains(rootId.value);
  const std::vector<ResolvedStyle> styles = resolveAll(scene);
  std::vector<ResolvedStructure> structures;
  for (std::size_t i = 0; i < styles.size(); ++i) {
    const Node& node = scene.nodes()[i];
    if (!all && !meant.contains(node.id.value) && !meant.contains(node.parent.value))
      continue;
    meant.insert(node.id.value);
    if (!node.isGroup())
      structures.push_back({&node, styles[i]});
  }
  return structures;
}

}  // namespace sline::model
