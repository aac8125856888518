// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/other_sides.h"

#include "model/scene/known_frame.h"

namespace sline::model {

SidedPlaces sidedPlaces(const Scene& scene) {
  SidedPlaces sided;
  for (const Node& node : scene.nodes()) {
    if (node.isGroup() || node.provenance.frame == fileFrame || node.mesh->bounds().empty())
      continue;
    const Box box = node.mesh->bounds();
    sided.ids.push_back(node.id);
    sided.places.push_back({node.name, box.centre().x, box.centre().y, 0.5f * box.size().x});
  }
  return sided;
}

std::vector<NodeId> onOtherSide(const Scene& scene) {
  const SidedPlaces sided = sidedPlaces(scene);
  std::vector<NodeId> found;
  for (const std::size_t i : namedForOtherSide(sided.places))
    found.push_back(sided.ids[i]);
  return found;
}

std::string otherSidesText(const Scene& scene) {
  constexpr std::size_t shown = 4;
  std::string names;
  std::size_t count = 0;
  for (const NodeId id : onOtherSide(scene)) {
    const Node& node = *scene.find(id);
    if (node.provenance.evidence.sides == Evidence::conflict)
      continue;
    if (++count <= shown)
      names += (names.empty() ? "\"" : ", \"") + node.name + '"';
  }
  if (count == 0)
    return {};
  if (count > shown)
    names += ", …";
  return names + (count == 1 ? " lies on the other side than its name says"
                             : " lie on the other side than their names say");
}

}  // namespace sline::model
