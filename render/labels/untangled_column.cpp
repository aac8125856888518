// SPDX-License-Identifier: Apache-2.0
#include "render/labels/untangled_column.h"

#include <algorithm>
#include <utility>

#include "render/labels/leader_bends.h"

namespace sline::render {

namespace {

/// Holds a column's boxes in one order, with one bend for each leader.
class Tangle {
 public:
  Tangle(const Column& column, std::vector<ColumnItem> items, std::size_t bend)
      : m_column(&column), m_items(std::move(items)), m_bends(m_items.size(), bend) {
    stand();
  }

  const std::vector<ColumnItem>& items() const { return m_items; }
  const std::vector<ColumnPlacement>& places() const { return m_places; }
  std::size_t left() const { return m_left; }

  /// Bends one leader after the other as long as fewer are in each other's way.
  void bend() {
    for (bool fewer = m_left > 0; fewer;) {
      fewer = false;
      for (std::size_t i = 0; i < m_places.size(); ++i)
        fewer = bend(i) || fewer;
    }
    count();
  }

  /// Exchanges two that are in each other's way, or takes one to the other, as long as fewer are
  /// left.
  void exchange() {
    const std::size_t most = 8 + 2 * m_items.size();
    for (std::size_t tries = 0; m_left > 0 && tries < most; ++tries) {
      std::optional<Tangle> better;
      for (std::size_t i = 0; i < m_places.size() && !better; ++i)
        for (std::size_t k = i + 1; k < m_places.size() && !better; ++k)
          if (inTheWay(m_places[i], m_places[k]))
            better = apart(i, k);
      if (!better)
        return;
      *this = *std::move(better);
    }
  }

 private:
  void stand() {
    m_places = placesIn(*m_column, m_items);
    for (std::size_t i = 0; i < m_places.size(); ++i)
      setBend(i, m_bends[i]);
    count();
  }

  void setBend(std::size_t i, std::size_t bend) {
    m_bends[i] = bend;
    m_places[i].leader = leaderOf(*m_column, m_items[i].place, m_places[i].box, leaderBends[bend]);
  }

  std::size_t waysBarred(std::size_t i) const {
    std::size_t barred = 0;
    for (std::size_t k = 0; k < m_places.size(); ++k)
      barred += k != i && inTheWay(m_places[i], m_places[k]) ? 1 : 0;
    return barred;
  }

  void count() {
    m_left = 0;
    for (std::size_t i = 0; i < m_places.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        m_left += inTheWay(m_places[i], m_places[k]) ? 1 : 0;
  }

  bool bend(std::size_t i) {
    std::size_t least = waysBarred(i);
    if (least == 0)
      return false;
    const std::size_t own = m_bends[i];
    std::size_t best = own;
    for (std::size_t way = 0; way < leaderBends.size() && least > 0; ++way) {
      setBend(i, way);
      if (const std::size_t barred = waysBarred(i); barred < least) {
        least = barred;
        best = way;
      }
    }
    setBend(i, best);
    return best != own;
  }

  /// Returns the column with the two apart, if fewer are in each other's way there.
  std::optional<Tangle> apart(std::size_t i, std::size_t k) const {
    const auto better = [&](const auto& change) -> std::optional<Tangle> {
      Tangle tried = *this;
      change(tried.m_items);
      change(tried.m_bends);
      if (!fitIn(*m_column, tried.m_items))
        return std::nullopt;
      tried.stand();
      tried.bend();
      return tried.m_left < m_left ? std::optional(std::move(tried)) : std::nullopt;
    };
    const auto at = [](auto& list, std::size_t index) {
      return list.begin() + std::ptrdiff_t(index);
    };
    if (auto swapped = better([&](auto& list) { std::swap(list[i], list[k]); }))
      return swapped;
    if (k == i + 1)
      return std::nullopt;
    if (auto after =
            better([&](auto& list) { std::rotate(at(list, i), at(list, i + 1), at(list, k + 1)); }))
      return after;
    return better([&](auto& list) { std::rotate(at(list, i), at(list, k), at(list, k + 1)); });
  }

  const Column* m_column;
  std::vector<ColumnItem> m_items;
  std::vector<std::size_t> m_bends;
  std::vector<ColumnPlacement> m_places;
  std::size_t m_left = 0;  ///< pairs that are in each other's way
};

}  // namespace

std::vector<ColumnPlacement> untangled(const Column& column, std::vector<ColumnItem>& items) {
  Tangle best(column, items, 0);
  best.bend();
  if (best.left() > 0) {
    std::vector<ColumnItem> level = items;
    std::stable_sort(level.begin(), level.end(), [](const ColumnItem& a, const ColumnItem& b) {
      return a.place.y < b.place.y;
    });
    if (fitIn(column, level)) {
      Tangle other(column, std::move(level), leaderBends.size() - 1);
      other.bend();
      other.exchange();
      best.exchange();
      if (other.left() < best.left())
        best = std::move(other);
    } else {
      best.exchange();
    }
  }
  items = best.items();
  return best.places();
}

}  // namespace sline::render
