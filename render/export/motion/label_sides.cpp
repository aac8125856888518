// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/label_sides.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace sline::render {

namespace {

using Presence = std::vector<bool>;

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

/// Removes what is there or gone for less than `least` frames; in a film that loops, its end and
/// its beginning are neighbours.
class Blinks {
 public:
  Blinks(Presence& there, std::size_t least, bool loops)
      : m_there(there), m_least(least), m_loops(loops) {}

  void remove() {
    while (removeOne())
      continue;
  }

 private:
  /// Returns how many frames from that one on are alike.
  std::size_t run(std::size_t from) const {
    std::size_t length = 1;
    while (length < m_there.size() && (m_loops || from + length < m_there.size()) &&
           m_there[(from + length) % m_there.size()] == m_there[from])
      ++length;
    return length;
  }

  bool removeOne() {
    const std::size_t count = m_there.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t before = (i + count - 1) % count;
      const bool begins = i == 0 && !m_loops ? true : m_there[before] != m_there[i];
      const std::size_t length = run(i);
      if (!begins || length >= m_least || length == count)
        continue;
      if (m_there[i]) {
        for (std::size_t k = 0; k < length; ++k)
          m_there[(i + k) % count] = false;
        return true;
      }
      const bool inside = m_loops || (i > 0 && i + length < count);
      if (inside) {
        for (std::size_t k = length; k < m_least && (m_loops || i + k < count); ++k)
          m_there[(i + k) % count] = false;
        return true;
      }
    }
    return false;
  }

  Presence& m_there;
  std::size_t m_least;
  bool m_loops;
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

void stayForASecond(std::vector<LabelPlate>& frames, const Film& film) {
  const std::size_t count = frames.size();
  const auto second = std::size_t(film.framesPerSecond());
  if (count < second)
    return;
  std::map<model::AnnotationId, Presence> all;
  for (std::size_t i = 0; i < count; ++i)
    for (const PlacedLabel& label : frames[i].layout.labels) {
      Presence& there = all[label.id];
      there.resize(count, false);
      there[i] = true;
    }
  for (auto& [id, there] : all)
    Blinks(there, second, film.loops()).remove();
  for (std::size_t i = 0; i < count; ++i)
    std::erase_if(frames[i].layout.labels, [&](const PlacedLabel& label) {
      if (all[label.id][i])
        return false;
      frames[i].layout.leftOut.push_back(label.id);
      return true;
    });
}

}  // namespace sline::render
