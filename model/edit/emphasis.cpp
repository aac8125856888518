// SPDX-License-Identifier: Apache-2.0
#include "model/edit/emphasis.h"

#include <algorithm>
#include <unordered_set>

namespace sline::model {

namespace {

using IdSet = std::unordered_set<std::uint64_t>;

IdSet setOf(std::span<const NodeId> ids) {
  IdSet set;
  for (const NodeId id : ids)
    set.insert(id.value);
  return set;
}

/// The nodes and all below them; one pass, because a parent stands before its children.
IdSet withAllBelow(const Scene& scene, IdSet ids) {
  for (const Node& node : scene.nodes())
    if (ids.contains(node.parent.value))
      ids.insert(node.id.value);
  return ids;
}

/// Calls change(style, named) for the named nodes and for all below them.
template <class Change>
Edited withStyles(const Scene& scene, std::span<const NodeId> ids, const Change& change) {
  const IdSet named = setOf(ids);
  const IdSet meant = withAllBelow(scene, named);
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes)
    if (meant.contains(node.id.value))
      change(node.style, named.contains(node.id.value));
  Edited edited{scene, nodes != scene.nodes()};
  if (edited.changed)
    edited.scene.setNodes(std::move(nodes));
  return edited;
}

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

Edited withGammaInherited(const Scene& scene, std::span<const NodeId> ids) {
  return withStyles(scene, ids, [](Style& style, bool) { style.gamma.reset(); });
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
  const IdSet named = setOf(ids);
  const IdSet meant = withAllBelow(scene, named);
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
  Edited edited{scene, nodes != scene.nodes()};
  if (edited.changed)
    edited.scene.setNodes(std::move(nodes));
  return edited;
}

Edited withContext(const Scene& scene, std::span<const NodeId> ids) {
  return withStyles(scene, ids, [](Style& style, bool named) {
    style.gamma.reset();
    style.fill.reset();
    if (named) {
      style.gamma = Gamma::clamped(contextGamma);
      style.fill = Fill::veil;
    }
  });
}

}  // namespace sline::model
