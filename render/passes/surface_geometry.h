// SPDX-License-Identifier: Apache-2.0
// Holds a surface as the passes draw it: 16 bytes a vertex, on demand its curvature, and the
// triangles that a view shows, or on demand all of them.
#pragma once

#include <glm/mat3x3.hpp>
#include <memory>
#include <optional>

#include "render/gpu/geometry.h"

namespace sline::render::passes {

struct SurfaceVertex {
  glm::vec3 position;
  std::uint32_t normal;  ///< see packedNormal
};
/// Returns a unit vector in three signed 10-bit numbers.
std::uint32_t packedNormal(const glm::vec3& normal);

/// Holds a shape operator times F_c as six signed 16-bit numbers: xx, yy, zz, xy, xz, yz.
struct PackedShape {
  std::int16_t entries[6];
};
/// The value that a stored 32767 stands for. Larger entries are cut off: where |κ|·F_c > 1 the
/// fill's weight is at its end anyway.
inline constexpr float shapeScale = 8.0f;
PackedShape packedShape(const glm::mat3& scaledShape);

class SurfaceGeometry {
 public:
  SurfaceGeometry(std::span<const SurfaceVertex> vertices, std::string_view name);

  /// Adds one entry per vertex; only fills at 3 < Γ < 4 read it.
  void addShape(std::span<const PackedShape> shape);
  bool hasShape() const { return m_shape.has_value(); }
  /// Sets by how much Γ differs at each vertex; only fills over which it varies read it.
  void setGammaOffsets(std::span<const float> offsets);
  /// Sets the triangles that the geometry has until the next call.
  void setTriangles(std::span<const std::uint32_t> indices);
  const gpu::Geometry& geometry() const { return *m_geometry; }
  /// Keeps all triangles besides, for graphics cards.
  void keepWhole(std::span<const std::uint32_t> indices);
  std::size_t wholeCount() const { return m_wholeCount; }
  /// Returns the geometry that has all triangles; they must be kept.
  const gpu::Geometry& whole() const { return *m_whole; }
  std::size_t indexCount() const { return m_indexCount; }

 private:
  void rebuild();
  std::unique_ptr<gpu::Geometry> geometryOf(const gpu::Buffer& indices) const;

  gpu::Buffer m_vertices;
  gpu::Buffer m_indices;
  std::optional<gpu::Buffer> m_shape;
  std::optional<gpu::Buffer> m_gammaOffsets;
  std::optional<gpu::Buffer> m_wholeIndices;
  std::unique_ptr<gpu::Geometry> m_geometry;
  std::unique_ptr<gpu::Geometry> m_whole;
  std::size_t m_indexCount = 0;
  std::size_t m_wholeCount = 0;
};

}  // namespace sline::render::passes
