// SPDX-License-Identifier: Apache-2.0
#include "render/labels/column.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "render/labels/leader_bends.h"
#include "render/labels/span_sharing.h"

namespace sline::render {

namespace {

/// Orders the items so that each box from the top belongs to the place for which no other lies
/// above the line between them: then no later leader crosses that one.
std::vector<ColumnItem> byTangents(const Column& column, std::vector<ColumnItem> items) {
  const std::vector<ColumnPlacement> places = placesIn(column, items);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const glm::vec2 port = places[i].leader[1];
    const auto slope = [&](const ColumnItem& item) {
      return (item.place.y - port.y) / std::max(std::abs(item.place.x - port.x), 1e-3f);
    };
    const auto highest = std::min_element(
        items.begin() + std::ptrdiff_t(i), items.end(),
        [&](const ColumnItem& a, const ColumnItem& b) { return slope(a) < slope(b); });
    std::rotate(items.begin() + std::ptrdiff_t(i), highest, highest + 1);
  }
  return items;
}

/// A box that moves farther than this jumps, millimetres.
constexpr float jump = 2.0f;

/// Returns the cost of moving a box that far: jumps are dear, above all those of items that have
/// just jumped.
float costOf(float way, const ColumnItem& item) {
  constexpr float dear = 10.0f;
  const float far = std::abs(way);
  return far > jump ? far + (item.calm <= restDegrees ? dear * dear : dear) : far;
}

/// Counts the items that are in the way of another, however leaders are bent.
std::size_t stuckIn(const Column& column, const std::vector<ColumnItem>& items) {
  const std::vector<ColumnPlacement> places = placesIn(column, items);
  std::size_t stuck = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      stuck += canPass(column, places[k], places[i]) ? 0 : 1;
  return stuck;
}

/// Exchanges two items whose leaders cannot be bent past each other's dots, as long as fewer are
/// left.
void unstick(const Column& column, std::vector<ColumnItem>& items) {
  const auto stuck = [&](const ColumnPlacement& a, const ColumnPlacement& b) {
    return !canPass(column, a, b);
  };
  for (std::size_t now = stuckIn(column, items); now > 0;) {
    const auto pair = firstPair(placesIn(column, items), stuck);
    std::vector<ColumnItem> tried = items;
    std::swap(tried[pair->first], tried[pair->second]);
    const std::size_t left = stuckIn(column, tried);
    if (left >= now)
      return;
    items = std::move(tried);
    now = left;
  }
}

}  // namespace

std::vector<Span> freeSpans(const Column& column) {
  std::vector<Span> blocked = column.blocked;
  std::sort(blocked.begin(), blocked.end(),
            [](const Span& a, const Span& b) { return a.low < b.low; });
  std::vector<Span> free;
  float from = column.top;
  const auto add = [&](float to) {
    if (to > from)
      free.push_back({from, to});
  };
  for (const Span& span : blocked) {
    add(std::min(span.low, column.bottom));
    from = std::max(from, span.high);
  }
  add(column.bottom);
  if (free.empty())
    free.push_back({column.top, column.top});
  return free;
}

bool fitIn(const Column& column, const std::vector<ColumnItem>& items) {
  std::size_t next = 0;
  for (const Span& span : freeSpans(column)) {
    float at = span.low;
    while (next < items.size() && at + items[next].box.y <= span.high + spanRounding)
      at += items[next++].box.y + column.gap;
  }
  return next == items.size();
}

float heightOf(std::span<const ColumnItem> items, float gap) {
  float height = 0.0f;
  for (const ColumnItem& item : items)
    height += item.box.y + (height > 0.0f ? gap : 0.0f);
  return height;
}

std::vector<ColumnPlacement> placesIn(const Column& column, const std::vector<ColumnItem>& items) {
  const Sharing sharing(column, items);
  Settler settler;
  std::vector<ColumnPlacement> places;
  places.reserve(items.size());
  for (std::size_t s = 0; s < sharing.spans(); ++s) {
    const std::span<const ColumnItem> in = sharing.in(s);
    const std::vector<double>& tops = settler.tops(column, sharing.span(s), in);
    for (std::size_t k = 0; k < in.size(); ++k) {
      const glm::vec2 corner(column.left ? column.edge - in[k].box.x : column.edge, float(tops[k]));
      const LabelBox box{corner, corner + in[k].box};
      places.push_back({box, leaderOf(column, in[k].place, box)});
    }
  }
  return places;
}

void uncross(const Column& column, std::vector<ColumnItem>& items) {
  const std::size_t most = 40 + 10 * items.size();
  for (std::size_t tries = 0; tries < most; ++tries) {
    const auto crossing = firstPair(placesIn(column, items), leadersCross);
    if (!crossing)
      return unstick(column, items);
    std::swap(items[crossing->first], items[crossing->second]);
  }
  for (int tries = 0; tries < 4 && firstPair(placesIn(column, items), leadersCross); ++tries)
    items = byTangents(column, items);
}

std::optional<ColumnPlacement> placeAmong(const Column& column, const ColumnItem& item,
                                          const std::vector<ColumnPlacement>& others, float reach) {
  const float half = 0.5f * item.box.y;
  const std::vector<Span> spans = freeSpans(column);
  std::vector<float> heights{item.wanted};
  for (const Span& span : spans) {
    heights.push_back(span.low + half);
    heights.push_back(span.high - half);
  }
  for (const ColumnPlacement& other : others) {
    heights.push_back(other.box.low.y - column.gap - half);
    heights.push_back(other.box.high.y + column.gap + half);
  }
  std::stable_sort(heights.begin(), heights.end(), [&](float a, float b) {
    return std::abs(a - item.wanted) < std::abs(b - item.wanted);
  });
  const auto free = [&](float height) {
    return std::any_of(spans.begin(), spans.end(), [&](const Span& span) {
      return height - half >= span.low - spanRounding && height + half <= span.high + spanRounding;
    });
  };
  for (const float height : heights) {
    if (std::abs(height - item.wanted) > reach || !free(height))
      continue;
    const glm::vec2 corner(column.left ? column.edge - item.box.x : column.edge, height - half);
    ColumnPlacement place{{corner, corner + item.box}, {}};
    if (std::any_of(others.begin(), others.end(), [&](const ColumnPlacement& other) {
          return place.box.low.y < other.box.high.y + column.gap - spanRounding &&
                 other.box.low.y < place.box.high.y + column.gap - spanRounding;
        }))
      continue;
    for (const LeaderBend& bend : leaderBends) {
      place.leader = leaderOf(column, item.place, place.box, bend);
      if (std::none_of(others.begin(), others.end(),
                       [&](const ColumnPlacement& other) { return inTheWay(place, other); }))
        return place;
    }
  }
  return std::nullopt;
}

bool pushIn(const Column& column, const ColumnItem& item, std::vector<ColumnItem>& items,
            std::vector<ColumnPlacement>& places, Push push) {
  for (std::size_t k = 0; k < items.size(); ++k)
    items[k].wanted = places[k].box.middle().y;
  std::optional<std::vector<ColumnItem>> best;
  std::vector<ColumnPlacement> bestPlaces;
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t at = 0; at <= items.size(); ++at) {
    std::vector<ColumnItem> tried = items;
    tried.insert(tried.begin() + std::ptrdiff_t(at), item);
    if (!fitIn(column, tried))
      continue;
    std::vector<ColumnPlacement> found = placesIn(column, tried);
    float moved = 0.0f;
    bool gentle = true;
    for (std::size_t k = 0; k < tried.size(); ++k) {
      const float way = found[k].box.middle().y - tried[k].wanted;
      moved += costOf(way, tried[k]);
      gentle = gentle && (k == at || std::abs(way) <= jump);
    }
    if ((push == Push::any || gentle) && moved < least && bendApart(column, found)) {
      least = moved;
      best = std::move(tried);
      bestPlaces = std::move(found);
    }
  }
  if (!best)
    return false;
  items = *std::move(best);
  places = std::move(bestPlaces);
  return true;
}

bool makesWay(const Column& column, const ColumnItem& item, std::vector<ColumnItem> others,
              std::size_t without) {
  others.erase(others.begin() + std::ptrdiff_t(without));
  std::vector<ColumnPlacement> places = placesIn(column, others);
  return placeAmong(column, item, places, columnReach) ||
         pushIn(column, item, others, places, Push::any);
}

}  // namespace sline::render
