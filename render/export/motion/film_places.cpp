// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/film_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace sline::render {

namespace {

/// Chooses one label's places so that the sum of what frames and changes cost is least (after
/// Viterbi).
class PlaceWalk {
 public:
  using Sight = std::optional<PlaceChoice>;

  /// `frames` are the label's places in each frame, by their index in the pool.
  PlaceWalk(const std::vector<std::vector<Sight>>& frames, std::size_t places, double second)
      : m_frames(frames), m_second(second), m_costs(places, 0.0) {}

  /// Returns the place in each frame.
  std::vector<std::size_t> walk() {
    for (std::size_t t = 0; t < m_frames.size(); ++t)
      step(t);
    auto place = std::size_t(std::min_element(m_costs.begin(), m_costs.end()) - m_costs.begin());
    std::vector<std::size_t> places(m_frames.size());
    for (std::size_t t = m_frames.size(); t-- > 0;) {
      places[t] = place;
      place = m_from[t][place];
    }
    return places;
  }

 private:
  /// Returns what it costs to point there in that frame.
  double costAt(std::size_t t, std::size_t k) const {
    constexpr double hidden = 1e3;
    constexpr double nowhere = 1e6;
    const Sight& sight = m_frames[t][k];
    return !sight ? nowhere : sight->seen ? 0.0 : hidden;
  }

  /// Returns what it costs to go from one place to another: the more, the farther up or down.
  double changeAt(std::size_t t, std::size_t from, std::size_t to) const {
    constexpr double once = 0.5;      // seconds
    constexpr double upright = 0.05;  // seconds per millimetre
    constexpr double across = 0.01;
    const Sight& was = m_frames[t][from];
    const Sight& is = m_frames[t][to];
    if (from == to || !was || !is)
      return from == to ? 0.0 : once * m_second;
    const glm::vec2 way = is->place - was->place;
    return m_second * (once + upright * double(std::abs(way.y)) + across * double(std::abs(way.x)));
  }

  void step(std::size_t t) {
    const std::size_t count = m_costs.size();
    std::vector<double> costs(count, std::numeric_limits<double>::infinity());
    std::vector<std::size_t>& from = m_from.emplace_back(count);
    for (std::size_t to = 0; to < count; ++to) {
      for (std::size_t was = 0; was < count; ++was)
        if (const double cost = m_costs[was] + changeAt(t, was, to); cost < costs[to]) {
          costs[to] = cost;
          from[to] = was;
        }
      costs[to] += costAt(t, to);
    }
    m_costs = std::move(costs);
  }

  const std::vector<std::vector<Sight>>& m_frames;
  double m_second;
  std::vector<double> m_costs;
  std::vector<std::vector<std::size_t>> m_from;
};

void choose(std::vector<ShownLabel*> frames, const std::vector<model::Anchor>& pool,
            const Film& film) {
  const std::size_t count = frames.size();
  std::vector<std::vector<PlaceWalk::Sight>> sights;
  // A film that loops is passed three times, so that the second has others before and after it.
  for (int pass = 0; pass < (film.loops() ? 3 : 1); ++pass)
    for (const ShownLabel* label : frames) {
      std::vector<PlaceWalk::Sight>& sight = sights.emplace_back(pool.size());
      for (const PlaceChoice& choice : label->choices)
        sight[choice.index] = choice;
    }
  const std::vector<std::size_t> places =
      PlaceWalk(sights, pool.size(), double(film.framesPerSecond())).walk();
  for (std::size_t t = 0; t < count; ++t) {
    const std::size_t at = film.loops() ? count + t : t;
    LabelItem& item = frames[t]->item;
    if (const PlaceWalk::Sight& sight = sights[at][places[at]]) {
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
