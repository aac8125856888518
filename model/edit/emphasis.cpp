// SPDX-License-Identifier: Apache-2.0
#include "model/edit/emphasis.h"

#include <algorithm>

#include "model/edit/look.h"

namespace sline::model {

namespace {

constexpr float contextGamma = 1.0f;
constexpr float ghostGamma = 0.0f;

Edited withLinesUnderVeil(const Scene& scene, std::span<const NodeId> ids, float gamma) {
  return withLook(scene, ids, {.gamma = Gamma::clamped(gamma), .fill = Fill::veil});
}

}  // namespace

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

Edited withContext(const Scene& scene, std::span<const NodeId> ids) {
  return withLinesUnderVeil(scene, ids, contextGamma);
}

Edited withGhost(const Scene& scene, std::span<const NodeId> ids) {
  return withLinesUnderVeil(scene, ids, ghostGamma);
}

}  // namespace sline::model
