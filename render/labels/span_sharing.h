// SPDX-License-Identifier: Apache-2.0
// Shares a column's free spans among its boxes.
#pragma once

#include <span>
#include <vector>

#include "render/labels/column.h"

namespace sline::render {

/// Lengths that differ by less than this are the same, in millimetres.
inline constexpr float spanRounding = 1e-3f;

/// Treats neighbours that stand as close as they may as one.
struct Pool {
  double sum = 0.0;
  std::size_t count = 0;
  double mean() const { return sum / double(count); }
};

/// Finds where items stand within a span; it keeps its memory, as many ways to share spans are
/// tried.
class Settler {
 public:
  /// Returns the upper sides of the items' boxes.
  const std::vector<double>& tops(const Column& column, const Span& span,
                                  std::span<const ColumnItem> items);
  /// Returns the sum of squares of the items' distances from their wanted heights.
  float strain(const Column& column, const Span& span, std::span<const ColumnItem> items);

 private:
  std::vector<double> m_tops;
  std::vector<Pool> m_pools;
};

/// Decides which of the items, in their order, stand in which span.
class Sharing {
 public:
  Sharing(const Column& column, const std::vector<ColumnItem>& items);

  std::size_t spans() const { return m_spans.size(); }
  const Span& span(std::size_t s) const { return m_spans[s]; }
  std::span<const ColumnItem> in(std::size_t s) const {
    return {m_items.data() + begin(s), m_ends[s] - begin(s)};
  }

 private:
  std::size_t begin(std::size_t s) const { return s == 0 ? 0 : m_ends[s - 1]; }
  bool over(std::size_t s) const;
  float strain(std::size_t s);
  /// Moves items next to the border of two spans to the other one while that brings all nearer to
  /// their wanted heights.
  void relax(std::size_t s);

  const Column& m_column;
  std::vector<Span> m_spans;
  const std::vector<ColumnItem>& m_items;
  std::vector<std::size_t> m_ends;  ///< of each span, the index after its last item
  Settler m_settler;
};

}  // namespace sline::render
