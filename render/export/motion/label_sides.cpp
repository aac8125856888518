// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/label_sides.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace sline::render {

namespace {

/// Where a label's place is in each frame, in widths of the anatomy to the right of its middle; 0
/// where the label is not in the picture.
using Places = std::vector<float>;

std::map<model::AnnotationId, Places> placesIn(const std::vector<LabelSights>& frames) {
  std::map<model::AnnotationId, Places> all;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const LabelBox whole{glm::vec2(0.0f), frames[i].size};
    const LabelBox anatomy = frames[i].obstacles.extent.value_or(whole);
    for (const ShownLabel& label : frames[i].labels.shown) {
      Places& places = all[label.item.id];
      places.resize(frames.size(), 0.0f);
      float x = 0.0f;
      for (const glm::vec2& place : label.item.places)
        x += place.x / float(label.item.places.size());
      places[i] = (x - anatomy.middle().x) / std::max(anatomy.size().x, 1e-3f);
    }
  }
  return all;
}

/// Returns one side for each label: the nearer to the middle, the more it matters where there is
/// room.
std::map<model::AnnotationId, LabelPost> sidesForGood(
    const std::map<model::AnnotationId, Places>& all, std::size_t most) {
  constexpr float nearMiddle = 0.03f;
  constexpr float rest = 0.5f;  // what the other frames count, compared with the first
  std::vector<std::pair<float, model::AnnotationId>> wishes;
  for (const auto& [id, places] : all) {
    float sum = 0.0f;
    for (const float x : places)
      sum += x;
    wishes.emplace_back(places.front() + rest * sum / float(places.size()), id);
  }
  std::stable_sort(wishes.begin(), wishes.end(), [](const auto& a, const auto& b) {
    return std::abs(a.first) > std::abs(b.first);
  });
  std::map<model::AnnotationId, LabelPost> sides;
  std::array<std::size_t, 2> count{};
  for (const auto& [wish, id] : wishes) {
    std::size_t side = wish < 0.0f ? 0 : 1;
    if (count[side] >= most || std::abs(wish) < nearMiddle)
      side = count[0] <= count[1] ? 0 : 1;
    ++count[side];
    sides[id] = side == 0 ? LabelPost::left : LabelPost::right;
  }
  return sides;
}

/// Finds when a label changes sides so that its leader is short, with at least `dwell` frames
/// between two changes. Dynamic programming over the frames, for either side.
class SideChanges {
 public:
  SideChanges(const Places& places, std::size_t dwell, double price) {
    for (std::size_t side = 0; side < 2; ++side) {
      m_costs[side].push_back(0.0);
      for (const float x : places)
        m_costs[side].push_back(m_costs[side].back() + double(std::max(side == 0 ? x : -x, 0.0f)));
      // No change at all is one before the first frame.
      m_changes[side].push_back({});
    }
    std::array<std::size_t, 2> best{};  // for each side, the best change long enough ago
    for (std::size_t t = 1; t < places.size(); ++t)
      for (std::size_t side = 0; side < 2; ++side) {
        const std::size_t other = 1 - side;
        if (t > dwell && until(other, t - dwell, t) < until(other, best[other], t))
          best[other] = t - dwell;
        m_changes[side].push_back({until(other, best[other], t) + price, best[other]});
      }
  }

  /// Returns the side in each frame.
  std::vector<LabelPost> sides() const {
    const std::size_t count = m_changes[0].size();
    std::size_t side = 0;
    std::size_t from = 0;
    for (std::size_t s = 0; s < 2; ++s)
      for (std::size_t t = 0; t < count; ++t)
        if (until(s, t, count) < until(side, from, count)) {
          side = s;
          from = t;
        }
    std::vector<LabelPost> sides(count);
    for (std::size_t i = count; i-- > 0;) {
      sides[i] = side == 0 ? LabelPost::left : LabelPost::right;
      if (i == from && i > 0) {
        from = m_changes[side][i].before;
        side = 1 - side;
      }
    }
    return sides;
  }

 private:
  struct Change {
    double cost = 0.0;       ///< of all frames before it, and its own
    std::size_t before = 0;  ///< the frame of the change before it
  };

  /// Returns what all frames before `to` cost where the last change before is that.
  double until(std::size_t side, std::size_t change, std::size_t to) const {
    return m_changes[side][change].cost + m_costs[side][to] - m_costs[side][change];
  }

  std::array<std::vector<double>, 2> m_costs;    ///< of standing on a side until each frame
  std::array<std::vector<Change>, 2> m_changes;  ///< to a side, at each frame
};

}  // namespace

void keepSides(std::vector<LabelSights>& frames, const Film& film, std::size_t most) {
  constexpr double dwell = 8.0;  // seconds
  constexpr double price = 0.1;  // a change costs as much as a second so far past the middle
  const double rate = double(film.framesPerSecond());
  const std::map<model::AnnotationId, Places> all = placesIn(frames);
  std::map<model::AnnotationId, std::vector<LabelPost>> sides;
  if (film.loops())
    for (const auto& [id, side] : sidesForGood(all, most))
      sides[id].assign(frames.size(), side);
  else
    for (const auto& [id, places] : all)
      sides[id] = SideChanges(places, std::size_t(std::lround(dwell * rate)), price * rate).sides();
  for (std::size_t i = 0; i < frames.size(); ++i)
    for (ShownLabel& label : frames[i].labels.shown)
      label.item.side = sides[label.item.id][i];
}

}  // namespace sline::render
