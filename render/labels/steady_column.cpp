// SPDX-License-Identifier: Apache-2.0
#include "render/labels/steady_column.h"

#include <algorithm>

#include "render/labels/leader_bends.h"

namespace sline::render {

namespace {
constexpr float nearGap = 25.0f;  // how far a box looks for a gap before it pushes others
}

bool SteadyColumn::fill(std::vector<ColumnItem> staying, std::vector<ColumnItem> coming) {
  m_items = std::move(staying);
  m_places = placesIn(m_column, m_items);
  loosen(coming);
  while (!coming.empty()) {
    const ColumnItem one = coming.front();
    if (letIn(one)) {
      coming.erase(coming.begin());
    } else if (const auto goes = whoMakesWay(one)) {
      coming.push_back(takeOut(*goes));
      coming.back().wanted = coming.back().place.y;
    } else if (m_moving) {
      m_out.push_back(one.item);
      coming.erase(coming.begin());
    } else {
      return false;
    }
  }
  return true;
}

void SteadyColumn::loosen(std::vector<ColumnItem>& coming) {
  while (!bendApart(m_column, m_places)) {
    const auto crossing = firstCrossing(m_places);
    const bool first = m_items[crossing->first].calm > m_items[crossing->second].calm;
    const ColumnItem goes = takeOut(first ? crossing->first : crossing->second);
    if (rests(goes)) {
      m_out.push_back(goes.item);
    } else {
      coming.push_back(goes);
      coming.back().wanted = goes.place.y;
    }
  }
}

bool SteadyColumn::letIn(const ColumnItem& item) {
  m_come.push_back(item.item);
  auto place = placeAmong(m_column, item, m_places, nearGap);
  if (!place && pushIn(m_column, item, m_items, m_places, m_moving ? Push::gentle : Push::any))
    return true;
  if (!place)
    place = placeAmong(m_column, item, m_places, columnReach);
  if (!place)
    return m_moving && pushIn(m_column, item, m_items, m_places, Push::any);
  const auto above = std::count_if(
      m_places.begin(), m_places.end(),
      [&](const ColumnPlacement& other) { return other.box.low.y < place->box.low.y; });
  m_items.insert(m_items.begin() + above, item);
  m_places.insert(m_places.begin() + above, *place);
  return true;
}

std::optional<std::size_t> SteadyColumn::whoMakesWay(const ColumnItem& item) const {
  std::optional<std::size_t> goes;
  for (std::size_t k = 0; k < m_items.size(); ++k)
    if (std::find(m_come.begin(), m_come.end(), m_items[k].item) == m_come.end() &&
        !rests(m_items[k]) && (!goes || m_items[k].calm > m_items[*goes].calm) &&
        makesWay(m_column, item, m_items, k))
      goes = k;
  return goes;
}

ColumnItem SteadyColumn::takeOut(std::size_t k) {
  const ColumnItem item = m_items[k];
  m_items.erase(m_items.begin() + std::ptrdiff_t(k));
  m_places.erase(m_places.begin() + std::ptrdiff_t(k));
  return item;
}

}  // namespace sline::render
