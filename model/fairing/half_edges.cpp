// SPDX-License-Identifier: Apache-2.0
#include "model/fairing/half_edges.h"

#include <algorithm>

namespace sline::model {

HalfEdges::HalfEdges(std::size_t vertexCount, std::span<const Triangle> triangles)
    : m_opposite(triangles.size() * 3, open) {
  // Half-edges stand in rows by the smaller of their two vertices; a row is short, so that pairing
  // within it is cheaper than sorting all edges.
  const auto from = [&](std::uint32_t h) { return triangles[h / 3][h % 3]; };
  const auto to = [&](std::uint32_t h) { return triangles[h / 3][(h + 1) % 3]; };
  const auto low = [&](std::uint32_t h) { return std::min(from(h), to(h)); };
  const auto high = [&](std::uint32_t h) { return std::max(from(h), to(h)); };
  const std::uint32_t total = std::uint32_t(triangles.size() * 3);
  std::vector<std::uint32_t> first(vertexCount + 2, 0);
  for (std::uint32_t h = 0; h < total; ++h)
    ++first[low(h) + 2];
  for (std::size_t v = 2; v < first.size(); ++v)
    first[v] += first[v - 1];
  struct Entry {
    std::uint32_t high;
    std::uint32_t halfEdge;
    auto operator<=>(const Entry&) const = default;
  };
  std::vector<Entry> rows(total);
  for (std::uint32_t h = 0; h < total; ++h)
    rows[first[low(h) + 1]++] = {high(h), h};
  for (std::size_t v = 0; v < vertexCount; ++v) {
    const auto begin = rows.begin() + first[v];
    const auto end = rows.begin() + first[v + 1];
    std::sort(begin, end);
    for (auto run = begin; run != end;) {
      auto after = run + 1;
      while (after != end && after->high == run->high)
        ++after;
      const auto length = after - run;
      if (length == 2) {
        m_opposite[run[0].halfEdge] = run[1].halfEdge;
        m_opposite[run[1].halfEdge] = run[0].halfEdge;
      } else if (length == 1) {
        ++m_openCount;
      } else {
        for (auto entry = run; entry != after; ++entry)
          m_opposite[entry->halfEdge] = shared;
        m_sharedCount += std::size_t(length);
      }
      run = after;
    }
  }
}

}  // namespace sline::model
