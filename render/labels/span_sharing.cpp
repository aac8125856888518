// SPDX-License-Identifier: Apache-2.0
#include "render/labels/span_sharing.h"

#include <algorithm>

namespace sline::render {

namespace {

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

}  // namespace

const std::vector<double>& Settler::tops(const Column& column, const Span& span,
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

float Settler::strain(const Column& column, const Span& span, std::span<const ColumnItem> items) {
  const std::vector<double>& tops = this->tops(column, span, items);
  double strain = 0.0;
  for (std::size_t k = 0; k < items.size(); ++k) {
    const double away = tops[k] + 0.5 * items[k].box.y - items[k].wanted;
    strain += away * away;
  }
  return float(strain);
}

Sharing::Sharing(const Column& column, const std::vector<ColumnItem>& items)
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

bool Sharing::over(std::size_t s) const {
  return m_ends[s] > begin(s) && heightOf(in(s), m_column.gap) > m_spans[s].length() + spanRounding;
}

float Sharing::strain(std::size_t s) {
  return m_settler.strain(m_column, m_spans[s], in(s)) +
         m_settler.strain(m_column, m_spans[s + 1], in(s + 1));
}

void Sharing::relax(std::size_t s) {
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

}  // namespace sline::render
