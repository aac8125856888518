// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/row_states.h"

#include <algorithm>
#include <optional>

namespace sline::widgets {

namespace {

/// What is known of the structures at or below a node.
struct Tally {
  std::size_t structures = 0;
  std::size_t visible = 0;
  std::vector<Colour> colours;
  std::optional<model::GammaRange> ofVisible;
  std::optional<model::GammaRange> ofAll;
};

void widen(std::optional<model::GammaRange>& range, const model::GammaRange& by) {
  range =
      range ? model::GammaRange{std::min(range->low, by.low), std::max(range->high, by.high)} : by;
}

void addColour(std::vector<Colour>& colours, const Colour& colour) {
  constexpr std::size_t most = 3;
  if (colours.size() < most && std::find(colours.begin(), colours.end(), colour) == colours.end())
    colours.push_back(colour);
}

void add(Tally& tally, const model::ResolvedStyle& style) {
  const model::GammaRange gamma{style.gamma, style.gamma};
  ++tally.structures;
  addColour(tally.colours, style.colour);
  widen(tally.ofAll, gamma);
  if (!style.visible)
    return;
  ++tally.visible;
  widen(tally.ofVisible, gamma);
}

model::Shown shownOf(const Tally& tally) {
  if (tally.visible == 0)
    return model::Shown::none;
  return tally.visible == tally.structures ? model::Shown::all : model::Shown::some;
}

}  // namespace

RowStates rowStatesOf(const model::Scene& scene) {
  std::unordered_map<std::uint64_t, model::NodeId> parents;
  std::unordered_map<std::uint64_t, Tally> tallies;
  std::unordered_map<std::uint64_t, model::ResolvedStyle> styles;
  for (const model::Node& node : scene.nodes()) {
    const model::ResolvedStyle& style =
        styles.emplace(node.id.value, scene.resolve(node.id)).first->second;
    parents[node.id.value] = node.parent;
    tallies.try_emplace(node.id.value);
    if (node.isGroup())
      continue;
    for (model::NodeId at = node.id; at != model::rootId; at = parents[at.value])
      add(tallies[at.value], style);
  }
  RowStates states;
  for (const model::Node& node : scene.nodes()) {
    Tally& tally = tallies[node.id.value];
    const Gamma own = styles.at(node.id.value).gamma;
    states[node.id.value] = {.shown = shownOf(tally),
                             .colours = std::move(tally.colours),
                             .gamma = tally.ofVisible
                                          ? *tally.ofVisible
                                          : tally.ofAll.value_or(model::GammaRange{own, own}),
                             .ownGamma = node.style.gamma.has_value(),
                             .structures = tally.structures};
  }
  return states;
}

}  // namespace sline::widgets
