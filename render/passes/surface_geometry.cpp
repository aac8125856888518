// SPDX-License-Identifier: Apache-2.0
#include "render/passes/surface_geometry.h"

#include <algorithm>
#include <cmath>

namespace sline::render::passes {

std::uint32_t packedNormal(const glm::vec3& normal) {
  const auto bits = [](float x) {
    return std::uint32_t(std::int32_t(std::lround(std::clamp(x, -1.0f, 1.0f) * 511.0f))) & 0x3ffu;
  };
  return bits(normal.x) | bits(normal.y) << 10 | bits(normal.z) << 20;
}

PackedShape packedShape(const glm::mat3& scaledShape) {
  const auto bits = [](float x) {
    return std::int16_t(std::lround(std::clamp(x / shapeScale, -1.0f, 1.0f) * 32767.0f));
  };
  const glm::mat3& s = scaledShape;
  return {
      {bits(s[0][0]), bits(s[1][1]), bits(s[2][2]), bits(s[0][1]), bits(s[0][2]), bits(s[1][2])}};
}

SurfaceGeometry::SurfaceGeometry(std::span<const SurfaceVertex> vertices, std::string_view name)
    : m_vertices(gpu::BufferKind::vertices, name), m_indices(gpu::BufferKind::indices, name) {
  m_vertices.fill(std::as_bytes(vertices));
  rebuild();
}

void SurfaceGeometry::addShape(std::span<const PackedShape> shape) {
  m_shape.emplace(gpu::BufferKind::vertices, "curvature");
  m_shape->fill(std::as_bytes(shape));
  rebuild();
}

void SurfaceGeometry::setGammaOffsets(std::span<const float> offsets) {
  const bool first = !m_gammaOffsets;
  if (first)
    m_gammaOffsets.emplace(gpu::BufferKind::vertices, "offsets of gamma");
  m_gammaOffsets->fill(std::as_bytes(offsets));
  if (first)
    rebuild();
}

void SurfaceGeometry::setTriangles(std::span<const std::uint32_t> indices) {
  m_indices.stream(std::as_bytes(indices));
  m_indexCount = indices.size();
}

void SurfaceGeometry::keepWhole(std::span<const std::uint32_t> indices) {
  m_wholeIndices.emplace(gpu::BufferKind::indices, "all triangles");
  m_wholeIndices->fill(std::as_bytes(indices));
  m_wholeCount = indices.size();
  rebuild();
}

void SurfaceGeometry::rebuild() {
  m_geometry = geometryOf(m_indices);
  if (m_wholeIndices)
    m_whole = geometryOf(*m_wholeIndices);
}

std::unique_ptr<gpu::Geometry> SurfaceGeometry::geometryOf(const gpu::Buffer& indices) const {
  using gpu::AttributeType;
  std::vector<gpu::Stream> streams;
  streams.push_back(
      {.buffer = &m_vertices,
       .stride = sizeof(SurfaceVertex),
       .attributes = {{0, 3, AttributeType::float32, 0}, {1, 4, AttributeType::signed10x3, 12}}});
  if (m_shape)
    streams.push_back(
        {.buffer = &*m_shape,
         .stride = sizeof(PackedShape),
         .attributes = {{2, 4, AttributeType::signed16, 0}, {3, 2, AttributeType::signed16, 8}}});
  if (m_gammaOffsets)
    streams.push_back({.buffer = &*m_gammaOffsets,
                       .stride = sizeof(float),
                       .attributes = {{4, 1, AttributeType::float32, 0}}});
  return std::make_unique<gpu::Geometry>(std::move(streams), &indices, "surface");
}

}  // namespace sline::render::passes
