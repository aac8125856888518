// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/film_places.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "render/export/motion/least_costly.h"
#include "render/labels/label_room.h"

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

/// A label in a frame that has it in the picture.
struct Appearance {
  const std::vector<PlaceChoice>& choices;
  LabelItem& item;
};

/// Chooses one place for each appearance. `wayCost` is what a place costs besides, in frames.
template <class WayCost>
void choose(const std::vector<Appearance>& frames, const std::vector<model::Anchor>& pool,
            const Film& film, const WayCost& wayCost) {
  std::vector<std::vector<PlaceSight>> sights;
  std::vector<std::vector<double>> costs;
  for (std::size_t t = 0; t < frames.size(); ++t) {
    std::vector<PlaceSight>& sight = sights.emplace_back(pool.size());
    std::vector<double>& cost = costs.emplace_back(pool.size(), placeCost({}));
    for (const PlaceChoice& choice : frames[t].choices) {
      sight[choice.index] = choice;
      cost[choice.index] = placeCost(choice) + wayCost(t, choice.place);
    }
  }
  const double second = film.framesPerSecond();
  const std::vector<std::size_t> places = leastCostly(
      frames.size(), pool.size(), film.loops(),
      [&](std::size_t t, std::size_t k) { return costs[t][k]; },
      [&](std::size_t t, std::size_t from, std::size_t to) {
        return second * placeChange(sights[t][from], sights[t][to]);
      });
  for (std::size_t t = 0; t < frames.size(); ++t)
    if (const PlaceSight& sight = sights[t][places[t]]) {
      LabelItem& item = frames[t].item;
      item.found = pool[sight->index];
      item.places = {sight->place};
      item.hidden = !sight->seen;
    }
}

/// Tells whether the item's leader meets another's wherever it is bent, if it came from there.
bool meetsFrom(const glm::vec2& place, const LabelItem& item, const LabelItem& other) {
  LabelItem there = item;
  there.places = {place};
  return leadersMeet(there, other);
}

}  // namespace

bool leadersMeet(const LabelItem& a, const LabelItem& b) {
  if (!a.height || !b.height || !a.side || a.side != b.side)
    return false;
  const bool first = *a.height < *b.height;
  const LabelItem& upper = first ? a : b;
  const LabelItem& lower = first ? b : a;
  const glm::vec2 above = placeOf(upper);
  const glm::vec2 below = placeOf(lower);
  if (above.y <= below.y)
    return false;
  const float inwards = *a.side == LabelPost::left ? 1.0f : -1.0f;
  return inwards * (above.x - below.x) > 0.0f ? *upper.height > below.y : *lower.height < above.y;
}

void choosePlaces(std::vector<LabelSights>& frames, const PlacePool& pool, const Film& film) {
  std::map<model::AnnotationId, std::vector<Appearance>> all;
  for (LabelSights& frame : frames)
    for (ShownLabel& label : frame.labels.shown)
      if (!label.choices.empty())
        all[label.item.id].push_back({label.choices, label.item});
  for (const auto& [id, labels] : all)
    choose(labels, pool.at(id).anchors, film, [](std::size_t, const glm::vec2&) { return 0.0; });
}

void uncrossPlaces(std::vector<LabelRequest>& requests, const std::vector<LabelSights>& frames,
                   const PlacePool& pool, const Film& film) {
  constexpr double meeting = 3.0;  // frames of one label that a meeting costs
  constexpr int rounds = 2;
  struct Label {
    std::vector<Appearance> frames;
    std::vector<const LabelRequest*> requests;
  };
  std::map<model::AnnotationId, Label> all;
  for (std::size_t t = 0; t < frames.size(); ++t)
    for (std::size_t k = 0; k < requests[t].items.size(); ++k)
      if (const ShownLabel& shown = frames[t].labels.shown[k]; !shown.choices.empty()) {
        Label& label = all[shown.item.id];
        label.frames.push_back({shown.choices, requests[t].items[k]});
        label.requests.push_back(&requests[t]);
      }
  for (int round = 0; round < rounds; ++round)
    for (const auto& [id, shown] : all) {
      const Label& label = shown;  // lambdas take no structured bindings in clang
      choose(label.frames, pool.at(id).anchors, film, [&](std::size_t t, const glm::vec2& place) {
        const LabelItem& own = label.frames[t].item;
        const std::vector<LabelItem>& items = label.requests[t]->items;
        return meeting *
               double(std::count_if(items.begin(), items.end(), [&](const LabelItem& other) {
                 return other.id != own.id && meetsFrom(place, own, other);
               }));
      });
    }
}

}  // namespace sline::render
