// SPDX-License-Identifier: Apache-2.0
#include "model/edit/look.h"

#include <algorithm>
#include <cstdlib>
#include <unordered_map>

#include "model/base/contrast.h"
#include "model/edit/style_edits.h"
#include "model/scene/gamma_map.h"
#include "model/scene/resolved_styles.h"

namespace sline::model {

namespace {

constexpr Colour blackInk{0, 0, 0};
constexpr Colour whiteInk{255, 255, 255};

bool alike(const Colour& a, const Colour& b) {
  constexpr int rounding = 2;
  return std::abs(a.red - b.red) <= rounding && std::abs(a.green - b.green) <= rounding &&
         std::abs(a.blue - b.blue) <= rounding;
}

/// Returns the ink that goes with `now` as `ink` goes with `before`: that colour itself, or as dark
/// or light as lines need it. An ink that is no such one, as black, stays.
Colour inkFollowing(const Colour& ink, const Colour& before, const Colour& now) {
  // What lines need on paper (WCAG 2.2), where the colour was dark enough by itself.
  constexpr double enough = 4.5;
  if (ink == blackInk || ink == whiteInk)
    return ink;
  if (alike(ink, before))
    return legibleOn(whiteInk, now, std::min(contrastBetween(whiteInk, ink), enough));
  for (const Colour& ground : {whiteInk, blackInk}) {
    const double contrast = contrastBetween(ground, ink);
    if (alike(ink, legibleOn(ground, before, contrast)))
      return legibleOn(ground, now, contrast);
  }
  return ink;
}

/// Gives structures whose colour has changed, and whose ink has not, an ink that follows.
Edited withInksFollowing(const Scene& scene, std::span<const NodeId> ids, const Edited& edited) {
  const std::vector<ResolvedStructure> before = resolvedBelow(scene, ids);
  const std::vector<ResolvedStructure> now = resolvedBelow(edited.scene, ids);
  std::unordered_map<std::uint64_t, Colour> inks;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const std::optional<Colour>& ink = before[i].style.inkColour;
    if (ink && ink == now[i].style.inkColour && before[i].style.colour != now[i].style.colour)
      inks[now[i].node->id.value] = inkFollowing(*ink, before[i].style.colour, now[i].style.colour);
  }
  std::vector<Node> nodes = edited.scene.nodes();
  for (Node& node : nodes)
    if (const auto found = inks.find(node.id.value);
        found != inks.end() && found->second != *edited.scene.resolve(node.id).inkColour)
      node.style.inkColour = found->second;
  Edited inked = withNodesRestyled(edited.scene, std::move(nodes));
  return {std::move(inked.scene), edited.changed || inked.changed};
}

bool recolours(const Style& look) {
  return look.colour && !look.inkColour;
}

}  // namespace

Edited withLook(const Scene& scene, std::span<const NodeId> ids, const Style& look) {
  Edited edited = withStyles(scene, ids, [&look](Style& style, bool named) {
    if (named)
      patch(style, look);
    else
      forget(style, look);
  });
  return recolours(look) ? withInksFollowing(scene, ids, edited) : edited;
}

Edited withLookInherited(const Scene& scene, std::span<const NodeId> ids, const Style& which) {
  Edited edited = withStyles(scene, ids, [&which](Style& style, bool) { forget(style, which); });
  return recolours(which) ? withInksFollowing(scene, ids, edited) : edited;
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

namespace {

/// Holds Γ of a structure within `most` wherever it varies.
GammaMap heldWithin(GammaMap map, Gamma own, Gamma most) {
  for (GammaPoint& point : map.curve)
    point.offset = std::min(point.offset, most.value() - own.value());
  return map;
}

/// Returns the largest Γ that the style has anywhere on its surface.
float mostGamma(const ResolvedStyle& style) {
  float most = style.gamma.value();
  if (style.gammaMap.scalar != GammaScalar::none)
    for (const auto& stop : style.gammaMap.curve)
      most = std::max(most, style.gamma.value() + stop.offset);
  return most;
}

}  // namespace

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
    if (style.gammaMap.scalar != GammaScalar::none)
      node.style.gammaMap = heldWithin(style.gammaMap, std::min(style.gamma, hatched), hatched);
    // Half of a fill would be a tone again: what lets things show through hides nothing.
    if (shaded || style.fill != Fill::none) {
      constexpr float halfway = 3.5f;  // from hatching to shading, METHOD §7
      const bool hides = style.opacity.value() >= 0.5f &&
                         (mostGamma(style) >= halfway || style.fill == Fill::paper);
      node.style.fill = hides ? Fill::paper : Fill::none;
      node.style.opacity = Opacity::clamped(1.0f);
    }
  }
  std::vector<Section> sections = scene.sections();
  for (Section& section : sections)
    section.hatched = true;
  std::vector<Annotation> annotations = scene.annotations();
  for (Annotation& annotation : annotations)
    annotation.colour.reset();
  Edited edited{scene, nodes != scene.nodes() || sections != scene.sections() ||
                           annotations != scene.annotations()};
  if (edited.changed) {
    edited.scene.setAnnotations(std::move(annotations));
    edited.scene.setNodes(std::move(nodes));
    edited.scene.setSections(std::move(sections));
  }
  return edited;
}

}  // namespace sline::model
