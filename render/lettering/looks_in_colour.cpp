// SPDX-License-Identifier: Apache-2.0
#include "render/lettering/looks_in_colour.h"

#include <algorithm>
#include <unordered_map>

#include "model/scene/resolved_styles.h"

namespace sline::render {

LooksInColour looksInColour(const model::Scene& scene) {
  const std::vector<model::ResolvedStyle> styles = model::resolveAll(scene);
  auto looks = std::make_shared<std::vector<model::Look>>();
  for (std::size_t i = 0; i < styles.size(); ++i)
    if (const model::Node& node = scene.nodes()[i]; !node.isGroup()) {
      model::Look look{.node = node.id, .style = {}, .unread = {}};
      look.style.gamma = styles[i].gamma;
      look.style.gammaMap = styles[i].gammaMap;
      look.style.fill = styles[i].fill;
      look.style.opacity = styles[i].opacity;
      looks->push_back(std::move(look));
    }
  return looks;
}

model::Scene withLooksInColour(const model::Scene& scene, const LooksInColour& looks) {
  if (!looks)
    return scene;
  std::unordered_map<std::uint64_t, const model::Style*> styles;
  for (const model::Look& look : *looks)
    styles.emplace(look.node.value, &look.style);
  std::vector<model::Node> nodes = scene.nodes();
  for (model::Node& node : nodes)
    if (const auto found = styles.find(node.id.value); found != styles.end()) {
      node.style.gamma = found->second->gamma;
      node.style.gammaMap = found->second->gammaMap;
      node.style.fill = found->second->fill;
      node.style.opacity = found->second->opacity;
    }
  model::Scene shown = scene;
  shown.setNodes(std::move(nodes));
  return shown;
}

}  // namespace sline::render
