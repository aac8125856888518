// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/row_states.h"

#include <algorithm>
#include <optional>

#include "model/scene/resolved_styles.h"

namespace sline::widgets {

namespace {

/// Collects what is known of the structures at or below a node.
struct Tally {
  std::size_t structures = 0;
  std::size_t visible = 0;
  std::vector<Colour> colours;
  std::optional<model::GammaRange> ofVisible;
  std::optional<model::GammaRange> ofAll;
  Opacity faintest = Opacity::clamped(1.0f);
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
  if (style.opacity.value() < tally.faintest.value())
    tally.faintest = style.opacity;
  if (!style.visible)
    return;
  ++tally.visible;
  widen(tally.ofVisible, gamma);
}

model::Visibility visibilityOf(const Tally& tally) {
  if (tally.visible == 0)
    return model::Visibility::none;
  return tally.visible == tally.structures ? model::Visibility::all : model::Visibility::some;
}

}  // namespace

RowStates rowStatesOf(const model::Scene& scene) {
  const std::vector<model::ResolvedStyle> styles = model::resolveAll(scene);
  const std::vector<model::Node>& nodes = scene.nodes();
  std::unordered_map<std::uint64_t, std::size_t> places;
  places.reserve(nodes.size());
  std::vector<Tally> tallies(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    places.emplace(nodes[i].id.value, i);
    if (nodes[i].isGroup())
      continue;
    for (auto at = places.find(nodes[i].id.value); at != places.end();
         at = places.find(nodes[at->second].parent.value))
      add(tallies[at->second], styles[i]);
  }
  RowStates states;
  states.reserve(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const model::Node& node = nodes[i];
    Tally& tally = tallies[i];
    const auto above = states.find(node.parent.value);
    const bool lockedAbove = above != states.end() && above->second.lock != RowLock::open;
    const Gamma own = styles[i].gamma;
    states[node.id.value] = {.shown = visibilityOf(tally),
                             .colours = std::move(tally.colours),
                             .gamma = tally.ofVisible
                                          ? *tally.ofVisible
                                          : tally.ofAll.value_or(model::GammaRange{own, own}),
                             .opacity = tally.structures == 0 ? styles[i].opacity : tally.faintest,
                             .ownGamma = node.style.gamma.has_value(),
                             .ownColour = node.style.colour.has_value(),
                             .ownOpacity = node.style.opacity.has_value(),
                             .group = node.isGroup(),
                             .lock = node.locked   ? RowLock::own
                                     : lockedAbove ? RowLock::above
                                                   : RowLock::open,
                             .structures = tally.structures};
  }
  return states;
}

}  // namespace sline::widgets
