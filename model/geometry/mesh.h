// SPDX-License-Identifier: Apache-2.0
// Defines a triangle mesh that never changes. All code that draws, measures or saves a structure
// holds a `MeshPtr`, so a scene can be copied freely and read from any thread without a lock.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "model/base/result.h"

namespace sline::model {

/// Holds three vertex indices, counter-clockwise when seen from outside.
using Triangle = std::array<std::uint32_t, 3>;

/// An axis-aligned box is `empty()` until a point is added.
struct Box {
  glm::vec3 low{std::numeric_limits<float>::infinity()};
  glm::vec3 high{-std::numeric_limits<float>::infinity()};

  bool empty() const { return !(low.x <= high.x); }
  void add(const glm::vec3& p);
  void add(const Box& other);
  glm::vec3 centre() const { return 0.5f * (low + high); }
  glm::vec3 size() const { return high - low; }
  std::array<glm::vec3, 8> corners() const;
  bool operator==(const Box&) const = default;
};

/// A sphere that encloses points.
struct Sphere {
  glm::vec3 centre{0.0f};
  float radius = 0.0f;
};

/// Holds positions (millimetres, patient frame LPS unless the function that made it says otherwise)
/// and triangles as a structure of arrays. Invariants: every index is in range, every coordinate is
/// finite and within reach (scale_limits.h), and there are fewer than 2^31 of each.
class Mesh {
 public:
  /// Checks the invariants and makes the mesh; the error's reason names the first vertex or
  /// triangle at fault.
  static Result<Mesh> create(std::vector<glm::vec3> positions, std::vector<Triangle> triangles);

  std::span<const glm::vec3> positions() const { return m_positions; }
  std::span<const Triangle> triangles() const { return m_triangles; }
  std::size_t vertexCount() const { return m_positions.size(); }
  std::size_t triangleCount() const { return m_triangles.size(); }
  /// Returns the box around all vertices, used by a triangle or not.
  const Box& bounds() const { return m_bounds; }

  /// Tells whether positions and triangles are equal bit for bit.
  bool operator==(const Mesh& other) const {
    return m_positions == other.m_positions && m_triangles == other.m_triangles;
  }

 private:
  Mesh() = default;
  std::vector<glm::vec3> m_positions;
  std::vector<Triangle> m_triangles;
  Box m_bounds;
};

using MeshPtr = std::shared_ptr<const Mesh>;

}  // namespace sline::model
