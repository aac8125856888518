// SPDX-License-Identifier: Apache-2.0
#include "model/sculpting/field_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <numeric>

#include "model/base/parallel.h"

namespace sline::model {

namespace {
constexpr int largestBlock = 8;
/// A field may overstate its distance by this factor before a block is skipped by mistake; mending
/// finds the surface that is missed.
constexpr float slack = 1.5f;

bool within(const glm::ivec3& i, const glm::ivec3& size) {
  return i.x >= 0 && i.y >= 0 && i.z >= 0 && i.x < size.x && i.y < size.y && i.z < size.z;
}

constexpr std::array<std::array<int, 3>, 6> neighbours{
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
}  // namespace

FieldGrid::FieldGrid(const Field& field, const Box& box, float cell)
    : m_size(glm::ivec3(glm::ceil(box.size() / cell)) + 1),
      m_origin(box.low),
      m_cell(cell),
      m_values(std::size_t(m_size.x) * std::size_t(m_size.y) * std::size_t(m_size.z)),
      m_exact(m_values.size(), 0) {
  const glm::ivec3 blocks = (m_size + largestBlock - 1) / largestBlock;
  parallelFor(std::size_t(blocks.x) * std::size_t(blocks.y) * std::size_t(blocks.z), 4,
              [&](std::size_t block) {
                const int b = int(block);
                fill(field,
                     largestBlock *
                         glm::ivec3(b % blocks.x, b / blocks.x % blocks.y, b / blocks.x / blocks.y),
                     largestBlock);
              });
  mend(field, doubtful());
}

void FieldGrid::fill(const Field& field, const glm::ivec3& first, int edge) {
  if (!within(first, m_size))
    return;
  const glm::ivec3 end = glm::min(first + edge, m_size);
  if (edge > 1) {
    // The reach is one cell more than the samples span, so that no edge between two blocks is
    // missed.
    const float middle = field(place(glm::vec3(first) + 0.5f * float(edge - 1)));
    const float reach = m_cell * (0.5f * std::sqrt(3.0f) * float(edge - 1) + 1.0f);
    if (std::abs(middle) > slack * reach) {
      for (int z = first.z; z < end.z; ++z)
        for (int y = first.y; y < end.y; ++y)
          std::fill_n(m_values.begin() + std::ptrdiff_t(index({first.x, y, z})), end.x - first.x,
                      middle);
      return;
    }
    const int half = edge / 2;
    for (int octant = 0; octant < 8; ++octant)
      fill(field, first + half * glm::ivec3(octant & 1, octant >> 1 & 1, octant >> 2), half);
    return;
  }
  m_values[index(first)] = field(place(glm::vec3(first)));
  m_exact[index(first)] = 1;
}

glm::ivec3 FieldGrid::coordinates(std::size_t index) const {
  const std::size_t row = std::size_t(m_size.x);
  const std::size_t slice = row * std::size_t(m_size.y);
  return {int(index % row), int(index % slice / row), int(index / slice)};
}

std::vector<std::size_t> FieldGrid::doubtful() const {
  std::vector<std::vector<std::size_t>> ofSlice(std::size_t(m_size.z));
  const std::array<std::size_t, 3> strides{1, std::size_t(m_size.x),
                                           std::size_t(m_size.x) * std::size_t(m_size.y)};
  const auto compare = [&](const glm::ivec3& at, int axis, std::vector<std::size_t>& into) {
    const std::size_t i = index(at);
    const std::size_t j = i + strides[std::size_t(axis)];
    if ((m_values[i] < 0.0f) == (m_values[j] < 0.0f))
      return;
    if (!m_exact[i])
      into.push_back(i);
    if (!m_exact[j])
      into.push_back(j);
  };
  parallelFor(ofSlice.size(), 4, [&](std::size_t z) {
    for (int y = 0; y < m_size.y; ++y)
      for (int x = 0; x < m_size.x; ++x)
        for (int axis = 0; axis < 3; ++axis)
          if (const glm::ivec3 at(x, y, int(z)); at[axis] + 1 < m_size[axis])
            compare(at, axis, ofSlice[z]);
  });
  std::vector<std::size_t> found;
  for (const std::vector<std::size_t>& slice : ofSlice)
    found.insert(found.end(), slice.begin(), slice.end());
  return found;
}

void FieldGrid::mend(const Field& field, std::vector<std::size_t> open) {
  while (!open.empty()) {
    const std::size_t i = open.back();
    open.pop_back();
    if (m_exact[i])
      continue;
    const glm::ivec3 at = coordinates(i);
    m_values[i] = field(place(glm::vec3(at)));
    m_exact[i] = 1;
    for (const auto& [dx, dy, dz] : neighbours) {
      const glm::ivec3 beside = at + glm::ivec3(dx, dy, dz);
      if (!within(beside, m_size))
        continue;
      const std::size_t j = index(beside);
      if (!m_exact[j] && (m_values[i] < 0.0f) != (m_values[j] < 0.0f))
        open.push_back(j);
    }
  }
}

std::size_t FieldGrid::exactCount() const {
  return std::accumulate(m_exact.begin(), m_exact.end(), std::size_t(0));
}

}  // namespace sline::model
