// SPDX-License-Identifier: Apache-2.0
#include "model/edit/emphasis.h"

#include <algorithm>

#include "model/edit/styled_nodes.h"

namespace sline::model {

namespace {

template <class T>
Edited withField(const Scene& scene, std::span<const NodeId> ids, std::optional<T> Style::*field,
                 const T& value) {
  return withStyles(scene, ids, [&](Style& style, bool named) {
    if (named)
      style.*field = value;
    else
      (style.*field).reset();
  });
}

constexpr float focusGamma = 4.5f;
constexpr float contextGamma = 1.0f;
constexpr float ghostGamma = 0.0f;

Edited withLinesUnderVeil(const Scene& scene, std::span<const NodeId> ids, float gamma) {
  return withStyles(scene, ids, [gamma](Style& style, bool named) {
    style.gamma.reset();
    style.fill.reset();
    if (named) {
      style.gamma = Gamma::clamped(gamma);
      style.fill = Fill::veil;
    }
  });
}

void forget(Style& style, Inherited what) {
  const bool all = what == Inherited::all;
  if (all) {
    const std::optional<bool> visible = style.visible;
    style = Style{};
    style.visible = visible;
  }
  if (what == Inherited::gamma)
    style.gamma.reset();
  if (what == Inherited::colour)
    style.colour.reset();
  if (what == Inherited::opacity)
    style.opacity.reset();
}

}  // namespace

Edited withGamma(const Scene& scene, std::span<const NodeId> ids, Gamma gamma) {
  return withField(scene, ids, &Style::gamma, gamma);
}

Edited withColour(const Scene& scene, std::span<const NodeId> ids, Colour colour) {
  return withField(scene, ids, &Style::colour, colour);
}

Edited withFill(const Scene& scene, std::span<const NodeId> ids, Fill fill) {
  return withField(scene, ids, &Style::fill, fill);
}

Edited withInherited(const Scene& scene, std::span<const NodeId> ids, Inherited what) {
  return withStyles(scene, ids, [what](Style& style, bool) { forget(style, what); });
}

Edited withGammaInherited(const Scene& scene, std::span<const NodeId> ids) {
  return withInherited(scene, ids, Inherited::gamma);
}

GammaRange gammaRangeOf(const Scene& scene, NodeId id) {
  std::optional<GammaRange> visible;
  std::optional<GammaRange> any;
  const auto add = [](std::optional<GammaRange>& range, Gamma gamma) {
    range = range ? GammaRange{std::min(range->low, gamma), std::max(range->high, gamma)}
                  : GammaRange{gamma, gamma};
  };
  for (const NodeId structure : scene.structuresBelow(id)) {
    const ResolvedStyle style = scene.resolve(structure);
    add(any, style.gamma);
    if (style.visible)
      add(visible, style.gamma);
  }
  const Gamma own = scene.resolve(id).gamma;
  return visible ? *visible : any.value_or(GammaRange{own, own});
}

Edited withFocus(const Scene& scene, std::span<const NodeId> ids) {
  if (ids.empty())
    return {scene, false};
  const NodeSet named = setOf(ids);
  const NodeSet meant = withAllBelow(scene, named);
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes) {
    const bool focus = meant.contains(node.id.value);
    const bool speaks = node.parent == rootId || named.contains(node.id.value);
    node.style.gamma.reset();
    node.style.fill.reset();
    if (speaks) {
      node.style.gamma = Gamma::clamped(focus ? focusGamma : contextGamma);
      node.style.fill = focus ? Fill::paper : Fill::veil;
    }
  }
  return withNodesRestyled(scene, std::move(nodes));
}

Edited withContext(const Scene& scene, std::span<const NodeId> ids) {
  return withLinesUnderVeil(scene, ids, contextGamma);
}

Edited withGhost(const Scene& scene, std::span<const NodeId> ids) {
  return withLinesUnderVeil(scene, ids, ghostGamma);
}

}  // namespace sline::model
