// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/film_places.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "render/export/motion/least_costly.h"

namespace sline::render {

namespace {

using PlaceSight = std::optional<PlaceChoice>;

/// Returns what it costs to point there in a frame.
double placeCost(const PlaceSight& sight) {
  constexpr double hidden = 1e3;
  constexpr double nowhere = 1e6;
  return !sight ? nowhere : sight->seen ? 0.0 : hidden;
}

/// Returns what it costs to go from one place to another, in seconds: the more, the farther up or
/// down.
double placeChange(const PlaceSight& was, const PlaceSight& is) {
  constexpr double once = 0.5;
  constexpr double upright = 0.05;  // per millimetre
  constexpr double across = 0.01;
  if (!was || !is)
    return once;
  const glm::vec2 way = is->place - was->place;
  return once + upright * double(std::abs(way.y)) + across * double(std::abs(way.x));
}

void choose(const std::vector<ShownLabel*>& frames, const std::vector<model::Anchor>& pool,
            const Film& film) {
  std::vector<std::vector<PlaceSight>> sights;
  sights.reserve(frames.size());
  for (const ShownLabel* label : frames) {
    std::vector<PlaceSight>& sight = sights.emplace_back(pool.size());
    for (const PlaceChoice& choice : label->choices)
      sight[choice.index] = choice;
  }
  const double second = film.framesPerSecond();
  const std::vector<std::size_t> places = leastCostly(
      frames.size(), pool.size(), film.loops(),
      [&](std::size_t t, std::size_t k) { return placeCost(sights[t][k]); },
      [&](std::size_t t, std::size_t from, std::size_t to) {
        return second * placeChange(sights[t][from], sights[t][to]);
      });
  for (std::size_t t = 0; t < frames.size(); ++t) {
    LabelItem& item = frames[t]->item;
    if (const PlaceSight& sight = sights[t][places[t]]) {
      item.found = pool[sight->index];
      item.places = {sight->place};
      item.hidden = !sight->seen;
    }
  }
}

}  // namespace

void choosePlaces(std::vector<LabelSights>& frames, const PlacePool& pool, const Film& film) {
  std::map<model::AnnotationId, std::vector<ShownLabel*>> all;
  for (LabelSights& frame : frames)
    for (ShownLabel& label : frame.labels.shown)
      if (!label.choices.empty())
        all[label.item.id].push_back(&label);
  for (auto& [id, labels] : all)
    choose(labels, pool.at(id).anchors, film);
}

}  // namespace sline::render
