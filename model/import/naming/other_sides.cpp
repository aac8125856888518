// SPDX-License-Identifier: Apache-2.0
#include "model/import/naming/other_sides.h"

#include <algorithm>
#include <utility>

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

std::vector<NodeId> withNameInDoubt(const Scene& scene) {
  std::vector<NodeId> doubted = onOtherSide(scene);
  std::erase_if(doubted, [&scene](NodeId id) {
    const Provenance& from = scene.find(id)->provenance;
    return from.evidence.sides == Evidence::conflict || from.nameEvidence == Evidence::settled;
  });
  return doubted;
}

void markNamesInDoubt(Scene& imported, const Scene& whole) {
  const std::vector<NodeId> doubted = withNameInDoubt(whole);
  if (doubted.empty())
    return;
  std::vector<Node> nodes = imported.nodes();
  const std::size_t before = whole.nodes().size() - nodes.size();
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (std::find(doubted.begin(), doubted.end(), whole.nodes()[before + i].id) != doubted.end())
      nodes[i].provenance.nameEvidence = Evidence::conflict;
  imported.setNodes(std::move(nodes));
}

std::string otherSidesText(const Scene& scene) {
  constexpr std::size_t shown = 4;
  std::string names;
  std::size_t count = 0;
  for (const NodeId id : withNameInDoubt(scene))
    if (++count <= shown)
      names += (names.empty() ? "\"" : ", \"") + scene.find(id)->name + '"';
  if (count == 0)
    return {};
  if (count > shown)
    names += ", …";
  return names + (count == 1 ? " lies on the other side than its name says"
                             : " lie on the other side than their names say");
}

}  // namespace sline::model
