// SPDX-License-Identifier: Apache-2.0
#include "model/edit/moved_look.h"

#include <algorithm>
#include <cmath>

#include "model/edit/look.h"
#include "model/edit/style_edits.h"
#include "model/scene/resolved_styles.h"

namespace sline::model {

namespace {

struct NumberRange {
  float low;
  float high;
};

void widen(std::optional<NumberRange>& range, float value) {
  range = range ? NumberRange{std::min(range->low, value), std::max(range->high, value)}
                : NumberRange{value, value};
}

struct NumberRanges {
  std::optional<NumberRange> all;
  std::optional<NumberRange> movable;  ///< without those that are locked
  std::optional<NumberRange> shown;    ///< of these
};

NumberRanges rangesOf(const Scene& scene, std::span<const NodeId> ids, const LookNumber& number) {
  const NodeSet meant = withAllBelow(scene, setOf(ids));
  const NodeSet locked = lockedNodes(scene);
  const std::vector<ResolvedStyle> styles = resolveAll(scene);
  NumberRanges ranges;
  for (std::size_t i = 0; i < styles.size(); ++i) {
    const Node& node = scene.nodes()[i];
    if (node.isGroup() || !meant.contains(node.id.value))
      continue;
    widen(ranges.all, number.value(styles[i]));
    if (locked.contains(node.id.value))
      continue;
    widen(ranges.movable, number.value(styles[i]));
    if (styles[i].visible)
      widen(ranges.shown, number.value(styles[i]));
  }
  return ranges;
}

/// Takes out what sums of floats leave, so that equal values stay equal.
float rounded(float value) {
  constexpr float places = 1e4f;
  return std::round(value * places) / places;
}

}  // namespace

float roomToMove(const Scene& scene, std::span<const NodeId> ids, const LookNumber& number,
                 float by) {
  const NumberRanges ranges = rangesOf(scene, ids, number);
  const std::optional<NumberRange>& range = ranges.shown ? ranges.shown : ranges.movable;
  if (!range)
    return by;
  return std::clamp(by, std::min(0.0f, number.limits.low - range->low),
                    std::max(0.0f, number.limits.high - range->high));
}

Edited withLookMoved(const Scene& scene, std::span<const NodeId> ids, const LookNumber& number,
                     float from, float to) {
  const std::optional<NumberRange> all = rangesOf(scene, ids, number).all;
  if (!all || all->low == all->high)
    return withLook(scene, ids, number.look(to));
  const float by = roomToMove(scene, ids, number, to - from);
  const NodeSet named = setOf(ids);
  const std::vector<ResolvedStyle> styles = resolveAll(scene);
  const NodeSet meant = withAllBelow(scene, named);
  std::vector<Node> nodes = scene.nodes();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    Node& node = nodes[i];
    if (!meant.contains(node.id.value))
      continue;
    const bool first = named.contains(node.id.value) && !meant.contains(node.parent.value);
    std::optional<float> value = number.own(node.style);
    if (!value && first)
      value = number.value(styles[i]);
    if (value)
      patch(node.style,
            number.look(std::clamp(rounded(*value + by), number.limits.low, number.limits.high)));
  }
  return withNodesRestyled(scene, std::move(nodes));
}

}  // namespace sline::model
