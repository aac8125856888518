// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "model/sculpting/implicit.h"

namespace sline::model {

/// Samples a field on a cubic lattice, exactly only near its surface: blocks whose middle is
/// farther from the surface than the block reaches hold that one value. Where the sign changes,
/// both samples are always exact, however wrong the field's distances are far away, as long as some
/// part of that piece of surface was found.
class FieldGrid {
 public:
  FieldGrid(const Field& field, const Box& box, float cell);

  const glm::ivec3& size() const { return m_size; }
  float cell() const { return m_cell; }
  const glm::vec3& origin() const { return m_origin; }
  /// Returns the samples, x fastest, then y.
  const std::vector<float>& values() const { return m_values; }
  /// Returns how many samples were read from the field itself.
  std::size_t exactCount() const;

 private:
  void fill(const Field& field, const glm::ivec3& first, int edge);
  std::vector<std::size_t> doubtful() const;
  void mend(const Field& field, std::vector<std::size_t> open);
  glm::vec3 place(const glm::vec3& index) const { return m_origin + m_cell * index; }
  std::size_t index(const glm::ivec3& i) const {
    return (std::size_t(i.z) * std::size_t(m_size.y) + std::size_t(i.y)) * std::size_t(m_size.x) +
           std::size_t(i.x);
  }
  glm::ivec3 coordinates(std::size_t index) const;

  glm::ivec3 m_size;
  glm::vec3 m_origin;
  float m_cell;
  std::vector<float> m_values;
  std::vector<std::uint8_t> m_exact;
};

}  // namespace sline::model
