// SPDX-License-Identifier: Apache-2.0
#include "model/edit/look.h"

#include "model/edit/style_edits.h"

namespace sline::model {

Edited withLook(const Scene& scene, std::span<const NodeId> ids, const Style& look) {
  return withStyles(scene, ids, [&look](Style& style, bool named) {
    if (named)
      patch(style, look);
    else
      forget(style, look);
  });
}

Edited withLookInherited(const Scene& scene, std::span<const NodeId> ids, const Style& which) {
  return withStyles(scene, ids, [&which](Style& style, bool) { forget(style, which); });
}

Style lookOf(const Scene& scene, NodeId id) {
  return answersOf(scene.resolve(id));
}

bool hasNoLook(const Scene& scene) {
  const auto says = [](const Style& style) { return style.gamma || style.fill; };
  const bool nodes = std::any_of(scene.nodes().begin(), scene.nodes().end(),
                                 [&](const Node& node) { return says(node.style); });
  const bool views = std::any_of(scene.views().begin(), scene.views().end(), [&](const View& view) {
    return view.looks && std::any_of(view.looks->begin(), view.looks->end(),
                                     [&](const Look& look) { return says(look.style); });
  });
  return !nodes && !views;
}

Edited withInkAlone(const Scene& scene) {
  const Gamma hatched = Gamma::clamped(3.0f);
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes) {
    node.style.inkColour = Colour{0, 0, 0};
    if (node.isGroup())
      continue;
    node.style.colour = Colour{255, 255, 255};  // colour of the cut faces
    const ResolvedStyle style = scene.resolve(node.id);
    const bool shaded = style.gamma.value() > hatched.value();
    if (shaded) {
      // The tone is darkened by how far Γ was on the way to a shaded surface, so structures that
      // stood out still do.
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
