// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/label_heights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "render/export/motion/film_paths.h"
#include "render/export/motion/label_presence.h"
#include "render/export/motion/rank_stretches.h"
#include "render/labels/column_heights.h"
#include "render/labels/label_room.h"

namespace sline::render {

namespace {

/// Where a label stands in one column.
struct Slot {
  FilmLabel* label = nullptr;
  Presence here;              ///< frames in which it is in the picture, and in this column
  std::vector<float> wanted;  ///< the box's middle, in each frame
  std::vector<float> share;   ///< of its room that it takes, 0 … 1
  float height = 0.0f;        ///< of the box
};

/// Plans one column.
class ColumnPlan {
 public:
  ColumnPlan(std::vector<Slot> given, const Span& room, const Film& film)
      : m_slots(std::move(given)), m_room(room), m_film(film) {}

  void settle() {
    for (Slot& slot : m_slots)
      slot.share.assign(frames(), 1.0f);
    if (!fits())
      shareRoom();
    putInOrder();
    setHeights();
  }

 private:
  std::size_t frames() const { return std::size_t(m_film.frames()); }

  /// Returns the height that all need in that frame, with the space between them.
  float need(std::size_t t) const {
    float need = 0.0f;
    for (const Slot& slot : m_slots)
      need += slot.share[t] * (slot.height + columnGap);
    return need;
  }
  float room() const { return m_room.length() + columnGap; }
  bool fits() const {
    for (std::size_t t = 0; t < frames(); ++t)
      if (need(t) > room())
        return false;
    return true;
  }

  /// Gives room only to those that are in the picture, and where that is not enough, only to those
  /// that one sees, or leaves out what is seen least.
  void shareRoom() {
    for (Slot& slot : m_slots)
      setShare(slot);
    while (!fits()) {
      std::vector<std::size_t> narrow;
      for (std::size_t t = 0; t < frames(); ++t)
        if (need(t) > room())
          narrow.push_back(t);
      const auto seen = [&](const Slot& slot) {
        return std::count_if(narrow.begin(), narrow.end(),
                             [&](std::size_t t) { return slot.here[t] && slot.label->seen(t); });
      };
      const auto taken = [&](const Slot& slot) {
        return std::any_of(narrow.begin(), narrow.end(),
                           [&](std::size_t t) { return slot.share[t] > 0.0f; });
      };
      Slot* least = nullptr;
      for (Slot& slot : m_slots)
        if (taken(slot) && (!least || seen(slot) <= seen(*least)))
          least = &slot;
      takeOut(*least);
    }
  }

  void takeOut(Slot& slot) {
    bool hidden = false;
    for (std::size_t t = 0; t < frames(); ++t)
      if (slot.here[t] && !slot.label->seen(t)) {
        slot.here[t] = false;
        slot.label->there[t] = false;
        hidden = true;
      }
    stayForASecond(slot.here, m_film);
    for (std::size_t t = 0; t < frames(); ++t)
      if (slot.here[t] && !hidden) {
        slot.here[t] = false;
        slot.label->there[t] = false;
      }
    setShare(slot);
  }

  /// The room grows before the label comes, and shrinks after it has gone.
  void setShare(Slot& slot) const {
    slot.share = eased(slot.here, std::size_t(m_film.framesPerSecond()), m_film.loops());
  }

  /// Returns how much it costs that the first stands above the second: by how far their places are
  /// the other way round.
  double costAbove(const Slot& above, const Slot& below) const {
    constexpr double hidden = 0.25;
    constexpr float much = 40.0f;  // millimetres
    double cost = 0.0;
    for (std::size_t t = 0; t < frames(); ++t)
      if (above.here[t] && below.here[t]) {
        const float over = placeOf(*above.label->items[t]).y - placeOf(*below.label->items[t]).y;
        const bool seen = above.label->seen(t) && below.label->seen(t);
        cost += double(std::clamp(over / much, 0.0f, 1.0f)) * (seen ? 1.0 : hidden);
      }
    return cost;
  }

  /// Orders the slots so that this costs little: one after the other goes where it costs least.
  void putInOrder() {
    const auto mean = [](const Slot& slot) {
      return std::accumulate(slot.wanted.begin(), slot.wanted.end(), 0.0f);
    };
    std::stable_sort(m_slots.begin(), m_slots.end(),
                     [&](const Slot& a, const Slot& b) { return mean(a) < mean(b); });
    const std::size_t count = m_slots.size();
    std::vector<std::vector<double>> cost(count, std::vector<double>(count));
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < count; ++k)
        cost[i][k] = i == k ? 0.0 : costAbove(m_slots[i], m_slots[k]);
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t(0));
    for (bool better = true; better;) {
      better = false;
      for (std::size_t i = 0; i < count; ++i)
        better = moved(order, i, cost) || better;
    }
    std::vector<Slot> sorted;
    sorted.reserve(count);
    for (const std::size_t k : order)
      sorted.push_back(std::move(m_slots[k]));
    m_slots = std::move(sorted);
  }

  /// Moves the item to where it costs least; returns false where it stands there.
  static bool moved(std::vector<std::size_t>& order, std::size_t item,
                    const std::vector<std::vector<double>>& cost) {
    constexpr double rounding = 1e-3;
    const auto at = std::size_t(std::find(order.begin(), order.end(), item) - order.begin());
    std::vector<std::size_t> rest = order;
    rest.erase(rest.begin() + std::ptrdiff_t(at));
    std::vector<double> costs(order.size());
    for (const std::size_t other : rest)
      costs[0] += cost[item][other];
    for (std::size_t k = 0; k < rest.size(); ++k)
      costs[k + 1] = costs[k] + cost[rest[k]][item] - cost[item][rest[k]];
    const auto best = std::size_t(std::min_element(costs.begin(), costs.end()) - costs.begin());
    if (costs[best] > costs[at] - rounding)
      return false;
    rest.insert(rest.begin() + std::ptrdiff_t(best), item);
    order = std::move(rest);
    return true;
  }

  void setHeights() {
    std::vector<ColumnShare> shares(m_slots.size());
    for (std::size_t t = 0; t < frames(); ++t) {
      for (std::size_t k = 0; k < m_slots.size(); ++k)
        shares[k] = {m_slots[k].wanted[t], m_slots[k].height, m_slots[k].share[t]};
      const std::vector<float> heights = heightsInOrder(shares, m_room);
      for (std::size_t k = 0; k < m_slots.size(); ++k)
        if (m_slots[k].here[t])
          m_slots[k].label->items[t]->height = heights[k];
    }
  }

  std::vector<Slot> m_slots;
  Span m_room;
  const Film& m_film;
};

/// Returns the path on which the label goes after its place.
std::vector<float> pathOf(const FilmLabel& label, const Presence& here, const Film& film) {
  constexpr float slack = 10.0f;  // millimetres between the heights of a place and its box
  std::vector<std::optional<float>> places(here.size());
  for (std::size_t t = 0; t < here.size(); ++t)
    if (here[t])
      places[t] = placeOf(*label.items[t]).y;
  return steadyPath(places, slack, film);
}

class Planner {
 public:
  Planner(std::vector<FilmLabel>& labels, std::vector<LabelRequest>& frames, const Film& film)
      : m_labels(labels), m_frames(frames), m_film(film) {}

  void plan() {
    setWidths();
    for (FilmLabel& label : m_labels)
      pauseAtChanges(label);
    setRanks();
    for (const std::size_t side : {std::size_t(0), std::size_t(1)}) {
      for (std::size_t k = 0; k < m_labels.size(); ++k)
        addSlots(k, side);
      ColumnPlan(std::move(m_slots[side]), roomOf(side), m_film).settle();
    }
  }

 private:
  static bool inColumn(const LabelItem& item) { return !item.offset && !standsBeside(item); }
  static std::size_t sideOf(const LabelItem& item) { return item.side == LabelPost::left ? 0 : 1; }

  void setWidths() {
    std::array<float, 2> widths{};
    for (const LabelRequest& frame : m_frames)
      for (const LabelItem& item : frame.items)
        if (inColumn(item) && item.box.x <= 0.5f * frameOf(frame.space).size().x)
          widths[sideOf(item)] = std::max(widths[sideOf(item)], item.box.x);
    for (LabelRequest& frame : m_frames)
      frame.widths = widths;
  }

  void pauseAtChanges(FilmLabel& label) const {
    const std::size_t half = (std::size_t(m_film.framesPerSecond()) + 1) / 2;
    const LabelItem* before = nullptr;
    const std::size_t count = m_frames.size();
    for (std::size_t t = 0; t < count; ++t) {
      const LabelItem* now = label.items[t];
      if (before && now && before->side != now->side)
        for (std::size_t k = t - std::min(half, t); k < std::min(t + half, count); ++k)
          label.there[k] = false;
      before = now ? now : before;
    }
  }

  /// Ranks places in their column, in each frame.
  void setRanks() {
    constexpr double hidden = 0.25;
    m_ranks.assign(m_labels.size(), std::vector<std::optional<FrameRank>>(m_frames.size()));
    for (std::size_t t = 0; t < m_frames.size(); ++t)
      for (std::size_t k = 0; k < m_labels.size(); ++k) {
        if (!stands(m_labels[k], t))
          continue;
        const LabelItem& own = *m_labels[k].items[t];
        const auto above = [&](const FilmLabel& other) {
          return stands(other, t) && other.items[t]->side == own.side &&
                 placeOf(*other.items[t]).y < placeOf(own).y;
        };
        m_ranks[k][t] = {std::size_t(std::count_if(m_labels.begin(), m_labels.end(), above)),
                         own.hidden ? hidden : 1.0};
      }
  }

  static bool stands(const FilmLabel& label, std::size_t t) {
    return label.there[t] && label.items[t] && inColumn(*label.items[t]);
  }

  void addSlots(std::size_t k, std::size_t side) {
    FilmLabel& label = m_labels[k];
    std::vector<std::optional<FrameRank>> ranks = m_ranks[k];
    float height = 0.0f;
    for (std::size_t t = 0; t < m_frames.size(); ++t)
      if (!ranks[t] || sideOf(*label.items[t]) != side)
        ranks[t].reset();
      else
        height = std::max(height, label.items[t]->box.y);
    if (!(height > 0.0f))
      return;
    Presence any(m_frames.size());
    for (Presence& here : rankStretches(ranks, m_film)) {
      stayForASecond(here, m_film);
      for (std::size_t t = 0; t < any.size(); ++t)
        any[t] = any[t] || here[t];
      if (std::find(here.begin(), here.end(), true) == here.end())
        continue;
      std::vector<float> wanted = pathOf(label, here, m_film);
      m_slots[side].push_back({&label, std::move(here), std::move(wanted), {}, height});
    }
    for (std::size_t t = 0; t < any.size(); ++t)
      if (ranks[t] && !any[t])
        label.there[t] = false;
  }

  /// Returns the largest part of the column where nothing is reserved in any frame.
  Span roomOf(std::size_t side) const {
    const LabelBox frame = frameOf(m_frames.front().space);
    Column column{.left = side == 0, .top = frame.low.y, .bottom = frame.high.y, .blocked = {}};
    for (const LabelRequest& one : m_frames) {
      const LabelBox whole{glm::vec2(0.0f), one.space.size};
      const float edge =
          edgesOf(edgesBeside(one.obstacles.extent.value_or(whole)), frame, one.widths)[side];
      const float outer = side == 0 ? edge - one.widths[0] : edge + one.widths[1];
      for (const LabelBox& box : one.space.reserved)
        if (box.low.x - clearance < std::max(edge, outer) &&
            box.high.x + clearance > std::min(edge, outer))
          column.blocked.push_back({box.low.y - 2.0f * clearance, box.high.y + 2.0f * clearance});
    }
    const std::vector<Span> spans = freeSpans(column);
    return *std::max_element(spans.begin(), spans.end(),
                             [](const Span& a, const Span& b) { return a.length() < b.length(); });
  }

  std::vector<FilmLabel>& m_labels;
  std::vector<LabelRequest>& m_frames;
  const Film& m_film;
  std::vector<std::vector<std::optional<FrameRank>>> m_ranks;  ///< of each label, in each frame
  std::array<std::vector<Slot>, 2> m_slots;
};

}  // namespace

void planHeights(std::vector<FilmLabel>& labels, std::vector<LabelRequest>& frames,
                 const Film& film) {
  if (!frames.empty())
    Planner(labels, frames, film).plan();
}

}  // namespace sline::render
