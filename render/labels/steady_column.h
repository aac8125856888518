// SPDX-License-Identifier: Apache-2.0
// Lays out a column that follows the one before while a camera turns: whatever can stay stays.
#pragma once

#include "render/labels/column.h"

namespace sline::render {

class SteadyColumn {
 public:
  /// Starts an empty column. `moving` is as in LabelRequest; an item that has just jumped is then
  /// left out rather than made to jump again.
  SteadyColumn(const Column& column, bool moving) : m_column(column), m_moving(moving) {}

  /// Fills the column with the items that stood in it, from the top, and those that come. Returns
  /// false where the column must be laid out anew, which never happens while moving.
  bool fill(std::vector<ColumnItem> staying, std::vector<ColumnItem> coming);

  const std::vector<ColumnItem>& items() const { return m_items; }
  const std::vector<ColumnPlacement>& places() const { return m_places; }  ///< those of the items
  const std::vector<std::size_t>& out() const { return m_out; }            ///< ColumnItem::item

 private:
  bool rests(const ColumnItem& item) const { return m_moving && item.calm <= restDegrees; }
  /// Takes items out until no leaders cross; of two, the one that has not jumped for longer comes
  /// in again.
  void loosen(std::vector<ColumnItem>& coming);
  bool letIn(const ColumnItem& item);
  /// Returns the item without which there would be a place for this one: of all such items, the one
  /// that has not jumped for longest.
  std::optional<std::size_t> whoMakesWay(const ColumnItem& item) const;
  ColumnItem takeOut(std::size_t k);

  Column m_column;
  bool m_moving = false;
  std::vector<ColumnItem> m_items;
  std::vector<ColumnPlacement> m_places;
  std::vector<std::size_t> m_out;
  std::vector<std::size_t> m_come;  ///< those that have been let in
};

}  // namespace sline::render
