// SPDX-License-Identifier: Apache-2.0
#include "render/labels/column.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace sline::render {

namespace {

/// Treats neighbours that stand as close as they may as one.
struct Pool {
  double sum = 0.0;
  std::size_t count = 0;
  double mean() const { return sum / double(count); }
};

/// Tells how a leader is bent between its place and its box. `boxLevel`: it leaves the place aslant
/// and runs level in front of the box, from a point that is nearer to the box the smaller `far` is.
/// `placeLevel`: it leaves the place level and goes aslant after `far` of the way; as long as
/// places have the same order as boxes, such leaders never cross.
struct Bend {
  enum class Way { boxLevel, placeLevel } way = Way::boxLevel;
  float far = 0.0f;  ///< 0 … 1
};
/// The straighter a bend, the earlier it stands.
constexpr std::array<Bend, 9> bends{{{Bend::Way::boxLevel, 0.0f},
                                     {Bend::Way::boxLevel, 0.25f},
                                     {Bend::Way::placeLevel, 0.25f},
                                     {Bend::Way::boxLevel, 0.5f},
                                     {Bend::Way::placeLevel, 0.5f},
                                     {Bend::Way::boxLevel, 0.75f},
                                     {Bend::Way::placeLevel, 0.75f},
                                     {Bend::Way::boxLevel, 1.0f},
                                     {Bend::Way::placeLevel, 1.0f}}};

Leader leaderOf(const Column& column, const glm::vec2& place, const LabelBox& box,
                const Bend& bend = {}) {
  const float height = box.middle().y;
  const float inwards = column.left ? 1.0f : -1.0f;
  const float knee = column.edge + inwards * levelPiece;
  if (inwards * (place.x - column.edge) <= dotRoom)
    return {place, portOf(box, place)};
  // From a place beside the knee the leader would turn back at an acute angle.
  if (inwards * (place.x - knee) <= 0.0f)
    return {place, {column.edge, height}};
  if (bend.way == Bend::Way::boxLevel)
    return {place, {knee + bend.far * (place.x - knee), height}, {column.edge, height}};
  constexpr float channel = 3.0f;
  const float last = inwards * std::min(inwards * place.x, inwards * knee + channel);
  return {place,
          {place.x + bend.far * (last - place.x), place.y},
          {knee, height},
          {column.edge, height}};
}

/// Tells whether the leaders cross or one runs through the other's box, from a place behind the
/// column.
bool inTheWay(const ColumnPlacement& a, const ColumnPlacement& b) {
  const auto through = [](const ColumnPlacement& one, const ColumnPlacement& other) {
    return one.leader.size() == 2 && runsThrough(one.leader, other.box.grown(clearance));
  };
  return cross(a.leader, b.leader) || through(a, b) || through(b, a);
}

bool leadersCross(const ColumnPlacement& a, const ColumnPlacement& b) {
  return cross(a.leader, b.leader);
}

/// Returns the first two places for which `stand` is true, neighbours first.
template <typename Stand>
std::optional<std::pair<std::size_t, std::size_t>> firstPair(
    const std::vector<ColumnPlacement>& places, Stand&& stand) {
  for (std::size_t apart = 1; apart < places.size(); ++apart)
    for (std::size_t i = 0; i + apart < places.size(); ++i)
      if (stand(places[i], places[i + apart]))
        return std::pair(i, i + apart);
  return std::nullopt;
}

/// Returns the leader of that place with that bend.
Leader bent(const Column& column, const ColumnPlacement& place, const Bend& bend) {
  return leaderOf(column, place.leader.front(), place.box, bend);
}

/// Bends either of two leaders that cross, so that they cross neither each other nor any other.
bool bendPair(const Column& column, std::vector<ColumnPlacement>& places, std::size_t i,
              std::size_t j) {
  const auto free = [&](const Leader& leader, std::size_t self, std::size_t other) {
    for (std::size_t k = 0; k < places.size(); ++k)
      if (k != self && k != other && cross(leader, places[k].leader))
        return false;
    return true;
  };
  // Straight leaders from behind the column or close in front of it are never bent.
  const auto ways = [&](std::size_t k) { return places[k].leader.size() > 2 ? bends.size() : 1; };
  std::optional<std::pair<std::size_t, std::size_t>> best;
  for (std::size_t one = 0; one < ways(i); ++one)
    for (std::size_t two = 0; two < ways(j); ++two) {
      if (best && one + two >= best->first + best->second)
        break;
      const Leader first = bent(column, places[i], bends[one]);
      const Leader second = bent(column, places[j], bends[two]);
      if (!cross(first, second) && free(first, i, j) && free(second, j, i))
        best = {one, two};
    }
  if (!best)
    return false;
  places[i].leader = bent(column, places[i], bends[best->first]);
  places[j].leader = bent(column, places[j], bends[best->second]);
  return true;
}

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

float heightWith(std::span<const ColumnItem> items, float gap) {
  float height = 0.0f;
  for (const ColumnItem& item : items)
    height += item.box.y + (height > 0.0f ? gap : 0.0f);
  return height;
}

constexpr float rounding = 1e-3f;

/// Returns the span in which a box of that middle and half height stands, or else the nearest to
/// it.
std::size_t spanOf(const std::vector<Span>& spans, float middle, float half) {
  const auto away = [&](const Span& span) {
    return std::max({span.low + half - middle, middle - span.high + half, 0.0f});
  };
  return std::size_t(
      std::min_element(spans.begin(), spans.end(),
                       [&](const Span& a, const Span& b) { return away(a) < away(b); }) -
      spans.begin());
}

/// Finds where items stand within a span; it keeps its memory, as many ways to share spans are
/// tried.
class Settler {
 public:
  /// Returns the upper sides of the items' boxes.
  const std::vector<double>& tops(const Column& column, const Span& span,
                                  std::span<const ColumnItem> items) {
    m_tops.clear();
    m_pools.clear();
    // Less the height of the boxes above, wanted heights only have to be non-decreasing.
    double height = 0.0;
    for (const ColumnItem& item : items) {
      m_tops.push_back(height);
      m_pools.push_back({item.wanted - 0.5 * item.box.y - height, 1});
      height += item.box.y + column.gap;
      while (m_pools.size() > 1 && m_pools[m_pools.size() - 2].mean() > m_pools.back().mean()) {
        const Pool last = m_pools.back();
        m_pools.pop_back();
        m_pools.back().sum += last.sum;
        m_pools.back().count += last.count;
      }
    }
    const double lowest = std::max(double(span.low), span.high - (height - column.gap));
    std::size_t k = 0;
    for (const Pool& pool : m_pools)
      for (std::size_t i = 0; i < pool.count; ++i, ++k)
        m_tops[k] += std::clamp(pool.mean(), double(span.low), lowest);
    return m_tops;
  }

  /// Returns the sum of squares of the items' distances from their wanted heights.
  float strain(const Column& column, const Span& span, std::span<const ColumnItem> items) {
    const std::vector<double>& tops = this->tops(column, span, items);
    double strain = 0.0;
    for (std::size_t k = 0; k < items.size(); ++k) {
      const double away = tops[k] + 0.5 * items[k].box.y - items[k].wanted;
      strain += away * away;
    }
    return float(strain);
  }

 private:
  std::vector<double> m_tops;
  std::vector<Pool> m_pools;
};

/// Decides which of the items, in their order, stand in which span.
class Sharing {
 public:
  Sharing(const Column& column, const std::vector<ColumnItem>& items)
      : m_column(column), m_spans(freeSpans(column)), m_items(items), m_ends(m_spans.size(), 0) {
    // Items start where they want to be, as far as there is room.
    std::size_t at = 0;
    for (const ColumnItem& item : items) {
      at = std::max(at, spanOf(m_spans, item.wanted, 0.5f * item.box.y));
      for (std::size_t s = at; s < m_ends.size(); ++s)
        ++m_ends[s];
    }
    for (std::size_t s = 0; s + 1 < m_ends.size(); ++s)
      while (over(s))
        --m_ends[s];
    for (std::size_t s = m_ends.size(); s-- > 1;)
      while (over(s))
        ++m_ends[s - 1];
    for (std::size_t s = 0; s + 1 < m_ends.size(); ++s)
      relax(s);
  }

  std::size_t spans() const { return m_spans.size(); }
  const Span& span(std::size_t s) const { return m_spans[s]; }
  std::span<const ColumnItem> in(std::size_t s) const {
    return {m_items.data() + begin(s), m_ends[s] - begin(s)};
  }

 private:
  std::size_t begin(std::size_t s) const { return s == 0 ? 0 : m_ends[s - 1]; }
  bool over(std::size_t s) const {
    return m_ends[s] > begin(s) && heightWith(in(s), m_column.gap) > m_spans[s].length() + rounding;
  }
  float strain(std::size_t s) {
    return m_settler.strain(m_column, m_spans[s], in(s)) +
           m_settler.strain(m_column, m_spans[s + 1], in(s + 1));
  }
  /// Moves items next to the border of two spans to the other one while that brings all nearer to
  /// their wanted heights.
  void relax(std::size_t s) {
    for (const int way : {-1, 1})
      while (way < 0 ? m_ends[s] > begin(s) : m_ends[s] < m_ends[s + 1]) {
        const float before = strain(s);
        m_ends[s] += std::size_t(way);
        if (!over(s) && !over(s + 1) && strain(s) < before)
          continue;
        m_ends[s] -= std::size_t(way);
        break;
      }
  }

  const Column& m_column;
  std::vector<Span> m_spans;
  const std::vector<ColumnItem>& m_items;
  std::vector<std::size_t> m_ends;  ///< of each span, the index after its last item
  Settler m_settler;
};

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
    while (next < items.size() && at + items[next].box.y <= span.high + rounding)
      at += items[next++].box.y + column.gap;
  }
  return next == items.size();
}

std::optional<std::pair<std::size_t, std::size_t>> firstCrossing(
    const std::vector<ColumnPlacement>& places) {
  return firstPair(places, inTheWay);
}

bool bendApart(const Column& column, std::vector<ColumnPlacement>& places) {
  std::vector<ColumnPlacement> tried = places;
  for (std::size_t rounds = 0; rounds <= tried.size(); ++rounds) {
    const auto crossing = firstCrossing(tried);
    if (!crossing) {
      places = std::move(tried);
      return true;
    }
    if (!bendPair(column, tried, crossing->first, crossing->second))
      return false;
  }
  return false;
}

float heightOf(const std::vector<ColumnItem>& items, float gap) {
  return heightWith(items, gap);
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
      return;
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
      return height - half >= span.low - rounding && height + half <= span.high + rounding;
    });
  };
  for (const float height : heights) {
    if (std::abs(height - item.wanted) > reach || !free(height))
      continue;
    const glm::vec2 corner(column.left ? column.edge - item.box.x : column.edge, height - half);
    ColumnPlacement place{{corner, corner + item.box}, {}};
    if (std::any_of(others.begin(), others.end(), [&](const ColumnPlacement& other) {
          return place.box.low.y < other.box.high.y + column.gap - rounding &&
                 other.box.low.y < place.box.high.y + column.gap - rounding;
        }))
      continue;
    for (const Bend& bend : bends) {
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
