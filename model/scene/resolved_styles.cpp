// SPDX-License-Identifier: Apache-2.0
#include "model/scene/resolved_styles.h"

#include <unordered_set>

#include "model/scene/style_fields.h"

namespace sline::model {

std::vector<ResolvedStyle> resolveAll(const Scene& scene) {
  std::vector<Style> styles;
  std::vector<ResolvedStyle> resolved;
  styles.reserve(scene.nodes().size());
  resolved.reserve(scene.nodes().size());
  for (const Node& node : scene.nodes()) {
    styles.push_back(node.style);
    resolved.emplace_back();
    resolved.back().visible = node.style.visible.value_or(true);
    // Parents stand before their children.
    if (const Node* parent = scene.find(node.parent)) {
      const auto place = std::size_t(parent - scene.nodes().data());
      inherit(styles.back(), styles[place]);
      resolved.back().visible = resolved.back().visible && resolved[place].visible;
    }
    answer(resolved.back(), styles.back());
  }
  return resolved;
}

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
