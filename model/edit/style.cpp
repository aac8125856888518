// SPDX-License-Identifier: Apache-2.0
#include "model/edit/style.h"

#include <algorithm>
#include <unordered_set>

#include "model/edit/styled_nodes.h"

namespace sline::model {

namespace {

template <class T>
void patchField(std::optional<T>& field, const std::optional<T>& patch) {
  if (patch)
    field = patch;
}

/// A copy of the scene with change(node) called for the named nodes.
template <class Change>
Edited withNodes(const Scene& scene, std::span<const NodeId> ids, const Change& change) {
  const NodeSet meant = setOf(ids);
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes)
    if (meant.contains(node.id.value))
      change(node);
  return withNodesRestyled(scene, std::move(nodes));
}

}  // namespace

void patch(Style& style, const Style& patch) {
  patchField(style.colour, patch.colour);
  patchField(style.inkColour, patch.inkColour);
  patchField(style.gamma, patch.gamma);
  patchField(style.opacity, patch.opacity);
  patchField(style.fill, patch.fill);
  patchField(style.visible, patch.visible);
  patchField(style.penWeight, patch.penWeight);
  patchField(style.hatchDensity, patch.hatchDensity);
  patchField(style.hatchTone, patch.hatchTone);
}

Edited withStyle(const Scene& scene, std::span<const NodeId> ids, const Style& given) {
  return withNodes(scene, ids, [&given](Node& node) { patch(node.style, given); });
}

Edited withStyleReset(const Scene& scene, std::span<const NodeId> ids) {
  return withNodes(scene, editable(scene, ids), [](Node& node) { node.style = Style{}; });
}

Edited withOnlyVisible(const Scene& scene, std::span<const NodeId> ids) {
  std::unordered_set<std::uint64_t> shown;  // the structures, and all that stands above them
  for (const NodeId id : ids)
    for (const NodeId structure : scene.structuresBelow(id))
      for (const Node* node = scene.find(structure); node && shown.insert(node->id.value).second;
           node = scene.find(node->parent)) {
      }
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes) {
    const bool show = shown.contains(node.id.value);
    if (show && node.style.visible == false)
      node.style.visible = true;
    // Below a hidden group nothing needs hiding, and all comes back with the group.
    const bool parentShown = node.parent == rootId || shown.contains(node.parent.value);
    if (!show && parentShown)
      node.style.visible = false;
  }
  Edited edited{scene, nodes != scene.nodes()};
  if (edited.changed)
    edited.scene.setNodes(std::move(nodes));
  return edited;
}

Edited withInkAlone(const Scene& scene) {
  const Gamma hatched = Gamma::clamped(3.0f);
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes) {
    node.style.inkColour = Colour{0, 0, 0};
    if (node.isGroup())
      continue;
    node.style.colour = Colour{255, 255, 255};  // of cut faces
    const ResolvedStyle style = scene.resolve(node.id);
    const bool shaded = style.gamma.value() > hatched.value();
    if (shaded) {
      // As much darker as it was further on the way to its surface: what stood out still does.
      constexpr float darker = 0.4f;
      node.style.hatchTone = HatchTone::clamped(
          style.hatchTone.value() * (1.0f + darker * (style.gamma.value() - hatched.value())));
      node.style.gamma = hatched;
    }
    // Half of a fill would be a tone again.
    if (shaded || style.fill != Fill::none) {
      node.style.fill = style.opacity.value() >= 0.5f ? Fill::paper : Fill::none;
      node.style.opacity = Opacity::clamped(1.0f);
    }
  }
  std::vector<Section> sections = scene.sections();
  for (Section& section : sections)
    section.hatched = true;
  Edited edited{scene, nodes != scene.nodes() || sections != scene.sections()};
  if (edited.changed) {
    edited.scene.setNodes(std::move(nodes));
    edited.scene.setSections(std::move(sections));
  }
  return edited;
}

}  // namespace sline::model
