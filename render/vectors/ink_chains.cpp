// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/ink_chains.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>

namespace sline::render {

namespace {

constexpr std::uint32_t none = ~0u;

/// Returns an end of a segment: end 2i is segment i's a, end 2i + 1 its b.
std::tuple<float, float, float> endOf(std::span<const Stroke> segments, std::uint32_t end) {
  const Stroke& s = segments[end / 2];
  return end % 2 == 0 ? std::tuple(s.a.x, s.a.y, s.depthA) : std::tuple(s.b.x, s.b.y, s.depthB);
}

/// Returns for each end the only other end at the same point, or else `none`.
std::vector<std::uint32_t> partners(std::span<const Stroke> segments) {
  std::vector<std::uint32_t> order(2 * segments.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t x, std::uint32_t y) {
    return std::pair(endOf(segments, x), x) < std::pair(endOf(segments, y), y);
  });
  std::vector<std::uint32_t> partner(order.size(), none);
  for (std::size_t from = 0; from < order.size();) {
    std::size_t to = from + 1;
    while (to < order.size() && endOf(segments, order[to]) == endOf(segments, order[from]))
      ++to;
    if (to - from == 2) {
      partner[order[from]] = order[from + 1];
      partner[order[from + 1]] = order[from];
    }
    from = to;
  }
  return partner;
}

Stroke turned(const Stroke& s) {
  Stroke t = s;
  std::swap(t.a, t.b);
  std::swap(t.depthA, t.depthB);
  std::swap(t.moveA, t.moveB);
  std::swap(t.outwardA, t.outwardB);
  std::swap(t.halfWidthA, t.halfWidthB);
  std::swap(t.opacityA, t.opacityB);
  return t;
}

}  // namespace

std::vector<InkChain> inkChains(std::span<const Stroke> segments) {
  const std::vector<std::uint32_t> partner = partners(segments);
  std::vector<InkChain> chains;
  std::vector<bool> taken(segments.size());
  // Follows the line that leaves segment start / 2 at its other end.
  const auto walk = [&](std::uint32_t start) {
    InkChain& chain = chains.emplace_back();
    for (std::uint32_t end = start; end != none && !taken[end / 2]; end = partner[end ^ 1u]) {
      taken[end / 2] = true;
      chain.push_back(end % 2 == 0 ? segments[end / 2] : turned(segments[end / 2]));
    }
  };
  for (std::uint32_t end = 0; end < partner.size(); ++end)
    if (partner[end] == none && !taken[end / 2])
      walk(end);
  for (std::uint32_t i = 0; i < segments.size(); ++i)
    if (!taken[i])
      walk(2 * i);  // a closed line
  return chains;
}

}  // namespace sline::render
