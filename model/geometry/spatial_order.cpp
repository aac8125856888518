// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/spatial_order.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>

#include "model/base/parallel.h"

namespace sline::model {

namespace {
constexpr int bitsPerAxis = 10;

/// Spreads the lowest ten bits so that two zero bits follow each.
std::uint32_t spread(std::uint32_t x) {
  x &= 0x3ff;
  x = (x | (x << 16)) & 0x030000ff;
  x = (x | (x << 8)) & 0x0300f00f;
  x = (x | (x << 4)) & 0x030c30c3;
  x = (x | (x << 2)) & 0x09249249;
  return x;
}

struct Key {
  std::uint32_t code;
  std::uint32_t triangle;
};

/// Sorts by code with a stable least-significant-digit radix sort.
void sortByCode(std::vector<Key>& keys) {
  constexpr int digitBits = 10;
  std::vector<Key> other(keys.size());
  for (int shift = 0; shift < 3 * bitsPerAxis; shift += digitBits) {
    std::array<std::uint32_t, 1 << digitBits> start{};
    const auto digit = [shift](const Key& k) { return (k.code >> shift) & ((1 << digitBits) - 1); };
    for (const Key& k : keys)
      ++start[digit(k)];
    std::uint32_t sum = 0;
    for (std::uint32_t& s : start) {
      const std::uint32_t count = s;
      s = sum;
      sum += count;
    }
    for (const Key& k : keys)
      other[start[digit(k)]++] = k;
    keys.swap(other);
  }
}
}  // namespace

std::vector<std::uint32_t> spatialOrder(const Mesh& mesh) {
  const auto positions = mesh.positions();
  const auto triangles = mesh.triangles();
  const glm::vec3 size = mesh.bounds().size();
  const float longest = std::max({size.x, size.y, size.z});
  const float scale = longest > 0.0f ? float((1 << bitsPerAxis) - 1) / longest : 0.0f;
  std::vector<Key> keys(triangles.size());
  parallelFor(triangles.size(), 16384, [&](std::size_t f) {
    const auto& [a, b, c] = triangles[f];
    const glm::vec3 centroid = (positions[a] + positions[b] + positions[c]) / 3.0f;
    const glm::vec3 cell = glm::max((centroid - mesh.bounds().low) * scale, glm::vec3(0.0f));
    keys[f] = {.code = spread(std::uint32_t(cell.x)) | spread(std::uint32_t(cell.y)) << 1 |
                       spread(std::uint32_t(cell.z)) << 2,
               .triangle = std::uint32_t(f)};
  });
  sortByCode(keys);
  std::vector<std::uint32_t> order(keys.size());
  std::transform(keys.begin(), keys.end(), order.begin(), [](const Key& k) { return k.triangle; });
  return order;
}

}  // namespace sline::model
