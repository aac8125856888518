// SPDX-License-Identifier: Apache-2.0
// Merges corners that lie at the same place into one vertex.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

#include "model/import/source/values.h"

namespace sline::model {

/// Finds the vertex of a position, or makes one: an open-addressing table of vertex numbers.
class Welder {
 public:
  explicit Welder(std::size_t corners) {
    // A closed surface has a sixth as many vertices as its triangles have corners.
    m_slots.assign(std::bit_ceil(std::max<std::size_t>(64, corners / 3)), noVertex);
    m_positions.reserve(corners / 6 + 8);
  }

  std::uint32_t vertex(glm::vec3 p) {
    p += 0.0f;  // −0 becomes +0, so that the two weld
    const std::array<std::uint32_t, 3> key = bits(p);
    for (std::size_t slot = hash(key) & (m_slots.size() - 1);;
         slot = (slot + 1) & (m_slots.size() - 1)) {
      const std::uint32_t found = m_slots[slot];
      if (found == noVertex) {
        m_slots[slot] = std::uint32_t(m_positions.size());
        m_positions.push_back(p);
        if (2 * m_positions.size() > m_slots.size())
          grow();
        return std::uint32_t(m_positions.size() - 1);
      }
      if (bits(m_positions[found]) == key)
        return found;
    }
  }
  std::vector<glm::vec3> take() { return std::move(m_positions); }

 private:
  static std::array<std::uint32_t, 3> bits(const glm::vec3& p) {
    return {std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y),
            std::bit_cast<std::uint32_t>(p.z)};
  }
  static std::size_t hash(const std::array<std::uint32_t, 3>& key) {
    std::uint64_t h = key[0] * 0x9e3779b97f4a7c15ull;
    h = (h ^ (h >> 32) ^ key[1]) * 0xbf58476d1ce4e5b9ull;
    h = (h ^ (h >> 29) ^ key[2]) * 0x94d049bb133111ebull;
    return std::size_t(h ^ (h >> 31));
  }
  void grow() {
    m_slots.assign(2 * m_slots.size(), noVertex);
    for (std::uint32_t i = 0; i < m_positions.size(); ++i) {
      std::size_t slot = hash(bits(m_positions[i])) & (m_slots.size() - 1);
      while (m_slots[slot] != noVertex)
        slot = (slot + 1) & (m_slots.size() - 1);
      m_slots[slot] = i;
    }
  }

  std::vector<std::uint32_t> m_slots;
  std::vector<glm::vec3> m_positions;
};

}  // namespace sline::model
