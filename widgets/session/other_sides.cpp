// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/other_sides.h"

#include <algorithm>

#include "model/import/plan/other_sides.h"

namespace sline::widgets {

void OtherSides::follow(const model::Scene& scene) {
  std::vector<std::pair<std::string, model::MeshPtr>> now;
  for (const model::Node& node : scene.nodes())
    if (!node.isGroup())
      now.emplace_back(node.name, node.mesh);
  if (now == m_comparedOf)
    return;
  m_comparedOf = std::move(now);
  m_structures = model::onOtherSide(scene);
  m_text = model::otherSidesText(scene);
}

bool OtherSides::has(const model::Scene& scene, model::NodeId structure) {
  follow(scene);
  return std::find(m_structures.begin(), m_structures.end(), structure) != m_structures.end();
}

const std::string& OtherSides::text(const model::Scene& scene) {
  follow(scene);
  return m_text;
}

}  // namespace sline::widgets
