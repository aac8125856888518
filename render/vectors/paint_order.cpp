// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/paint_order.h"

namespace sline::render {

namespace {

// One pixel in so many, both ways, is looked at.
constexpr int sampleStep = 4;

/// Counts how many samples want one layer painted before another, for each pair of layers.
class Wishes {
 public:
  explicit Wishes(std::size_t layers) : m_layers(layers), m_counts(layers * layers) {}
  std::uint32_t& count(std::size_t first, std::size_t then) {
    return m_counts[first * m_layers + then];
  }

 private:
  std::size_t m_layers;
  std::vector<std::uint32_t> m_counts;
};

Wishes wishes(const LayerStack& stack, std::size_t layers) {
  Wishes found(layers);
  std::vector<SeenFill> fills;
  for (int y = sampleStep / 2; y < stack.height(); y += sampleStep)
    for (int x = sampleStep / 2; x < stack.width(); x += sampleStep) {
      stack.seenAt(x, y, fills);
      for (std::size_t behind = 1; behind < fills.size(); ++behind)
        for (std::size_t before = 0; before < behind; ++before)
          ++found.count(fills[behind].layer, fills[before].layer);
    }
  return found;
}

}  // namespace

std::vector<std::size_t> paintRanks(const LayerStack& stack, std::span<const float> depths) {
  const std::size_t count = depths.size();
  Wishes order = wishes(stack, count);
  // For each layer, counts the wishes for layers before it that are not yet painted.
  std::vector<std::uint64_t> owed(count, 0);
  for (std::size_t then = 0; then < count; ++then)
    for (std::size_t first = 0; first < count; ++first)
      owed[then] += order.count(first, then);
  std::vector<std::size_t> ranks(count);
  std::vector<bool> painted(count);
  for (std::size_t rank = 0; rank < count; ++rank) {
    std::size_t next = count;
    for (std::size_t i = 0; i < count; ++i)
      if (!painted[i] && (next == count || owed[i] < owed[next] ||
                          (owed[i] == owed[next] && depths[i] > depths[next])))
        next = i;
    painted[next] = true;
    ranks[next] = rank;
    for (std::size_t then = 0; then < count; ++then)
      owed[then] -= order.count(next, then);
  }
  return ranks;
}

}  // namespace sline::render
