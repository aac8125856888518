// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/other_sides.h"

#include <algorithm>
#include <utility>

#include "model/import/naming/other_sides.h"

namespace sline::widgets {

bool OtherSides::Compared::of(const model::Node& node) const {
  return node.mesh == mesh && node.name == name && node.provenance.frame == frame &&
         node.provenance.evidence.sides == sides && node.provenance.nameEvidence == ofName;
}

bool OtherSides::holdsFor(const model::Scene& scene) const {
  auto at = m_comparedOf.begin();
  for (const model::Node& node : scene.nodes())
    if (!node.isGroup() && (at == m_comparedOf.end() || !(at++)->of(node)))
      return false;
  return at == m_comparedOf.end();
}

void OtherSides::follow(const model::Scene& scene, int opening) {
  const bool another = std::exchange(m_opening, opening) != opening;
  if (!another && holdsFor(scene))
    return;
  if (another)
    take({}, {});
  m_comparedOf.clear();
  for (const model::Node& node : scene.nodes())
    if (!node.isGroup())
      m_comparedOf.push_back({node.name, node.provenance.frame, node.provenance.evidence.sides,
                              node.provenance.nameEvidence, node.mesh});
  m_queue.drop();
  m_queue.add([this, scene](const std::stop_token& stop) -> BackgroundQueue::Sequel {
    if (stop.stop_requested())
      return {};
    return
        [this, stop, structures = model::onOtherSide(scene), text = model::otherSidesText(scene)] {
          if (!stop.stop_requested())  // else another scene is being compared
            take(structures, text);
        };
  });
}

void OtherSides::take(std::vector<model::NodeId> structures, std::string text) {
  if (structures == m_structures && text == m_text)
    return;
  m_structures = std::move(structures);
  m_text = std::move(text);
  emit changed();
}

bool OtherSides::has(model::NodeId structure) const {
  return std::find(m_structures.begin(), m_structures.end(), structure) != m_structures.end();
}

}  // namespace sline::widgets

#include "moc_other_sides.cpp"
