// SPDX-License-Identifier: Apache-2.0
// A column that follows the one before while a camera turns: what can stay stays.
#pragma once

#include "render/labels/column.h"

namespace sline::render {

class SteadyColumn {
 public:
  /// `moving`: as in LabelRequest; who has just jumped then goes out rather than jump again.
  SteadyColumn(const Column& column, bool moving) : m_column(column), m_moving(moving) {}

  /// Those that stood here, from the top, and those that come. False where the column must be made
  /// anew, which never happens while moving.
  bool fill(std::vector<ColumnItem> staying, std::vector<ColumnItem> coming);

  const std::vector<ColumnItem>& items() const { return m_items; }
  const std::vector<ColumnPlace>& places() const { return m_places; }  ///< of the items
  const std::vector<std::size_t>& out() const { return m_out; }        ///< ColumnItem::item

 private:
  bool rests(const ColumnItem& item) const { return m_moving && item.calm <= restDegrees; }
  /// Until no leaders cross: who has not jumped for longer comes anew.
  void loosen(std::vector<ColumnItem>& coming);
  bool letIn(const ColumnItem& item);
  /// Without whom there would be a place for the item: who has not jumped for longest.
  std::optional<std::size_t> whoMakesWay(const ColumnItem& item) const;
  ColumnItem takeOut(std::size_t k);

  Column m_column;
  bool m_moving = false;
  std::vector<ColumnItem> m_items;
  std::vector<ColumnPlace> m_places;
  std::vector<std::size_t> m_out;
  std::vector<std::size_t> m_come;  ///< those that have been let in
};

}  // namespace sline::render
