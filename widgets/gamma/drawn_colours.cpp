// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/drawn_colours.h"

#include <algorithm>

namespace sline::widgets {

void DrawnColours::note(int opening, const model::Scene& before, const model::Scene& after) {
  Changes& changes = m_changes[opening];
  for (const model::Node& node : after.nodes()) {
    const model::Node* was = before.find(node.id);
    if (!was || was->style.colour == node.style.colour)
      continue;
    std::vector<Change>& own = changes[node.id];
    // Of one colour that came twice, what was there the last time counts.
    std::erase_if(own, [&node](const Change& each) { return each.given == node.style.colour; });
    own.push_back({was->style.colour, node.style.colour});
  }
}

model::Scene DrawnColours::givenBack(int opening, const model::Scene& scene) const {
  const auto changes = m_changes.find(opening);
  if (changes == m_changes.end())
    return scene;
  std::vector<model::Node> nodes = scene.nodes();
  for (model::Node& node : nodes) {
    const auto own = changes->second.find(node.id);
    if (own == changes->second.end() || scene.isLocked(node.id))
      continue;
    const auto change =
        std::find_if(own->second.rbegin(), own->second.rend(),
                     [&node](const Change& each) { return each.given == node.style.colour; });
    if (change != own->second.rend())
      node.style.colour = change->had;
  }
  model::Scene back = scene;
  back.setNodes(std::move(nodes));
  return back;
}

}  // namespace sline::widgets
