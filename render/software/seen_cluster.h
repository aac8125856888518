// SPDX-License-Identifier: Apache-2.0
// Projects clusters of triangles into the picture, and tells which samples a triangle covers, as a
// rasteriser does (METHOD §10).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "model/geometry/surface.h"
#include "render/strokes/picture_view.h"

namespace sline::render {

/// Says where surfaces are sampled: in the middles of squares of `step` pixels, one of which has
/// its lower left corner at `corner`.
struct SampleGrid {
  glm::ivec2 corner{0};
  int step = 1;
};

/// Clusters, and where the vertices lie that they name.
struct ClusterPlaces {
  const model::Clusters& clusters;
  std::span<const glm::vec3> positions;
};

/// Holds a cluster's vertices as they lie in the picture, counted in steps of the grid, which are
/// pixels below, and its triangles' boxes.
struct SeenCluster {
  using Vertices = std::array<float, model::Clusters::maximumVertices>;
  using Triangles = std::array<float, model::Clusters::maximumTriangles>;
  using Counts = std::array<std::int32_t, model::Clusters::maximumTriangles>;
  /// By how much a driver's vertices may lie beside ours, in pixels: it rounds them to 1/256.
  static constexpr float slack = 1.0f / 256.0f;

  std::array<Vertices, 3> position;
  Vertices x;
  Vertices y;
  Vertices depth;     ///< of the window: 0 … 1
  Vertices w;         ///< the distance from the eye's plane, or 1 in a parallel projection
  bool withinDepths;  ///< all of them lie within the view's depths
  std::array<Triangles, 3> cornerX;
  std::array<Triangles, 3> cornerY;
  Triangles area;  ///< doubled; positive: turned to the eye
  /// The first middle of a pixel in each triangle's box and how many there are.
  Counts left;
  Counts bottom;
  Counts columns;
  Counts rows;

  /// Projects the vertices. Returns false where some lie behind the eye or too far away to tell.
  bool project(const model::Cluster& cluster, const ClusterPlaces& places, const PictureView& view,
               const SampleGrid& grid);
  /// Finds the triangles' areas and which middles of pixels their boxes hold.
  void findBoxes(std::span<const std::array<std::uint8_t, 3>> triangles);
};

/// Tells which of the middles in its box a triangle holds.
class TriangleEdges {
 public:
  /// `rounded`: wherever a driver may round the corners to; `exact`: as they are, and a hair more,
  /// so that no gap is left between neighbours.
  enum class Corners { exact, rounded };
  TriangleEdges(const SeenCluster& seen, std::size_t triangle, Corners corners) {
    const float turn = seen.area[triangle] < 0.0f ? -1.0f : 1.0f;
    const glm::vec2 first(float(seen.left[triangle]) + 0.5f, float(seen.bottom[triangle]) + 0.5f);
    float around = 0.0f;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t next = (c + 1) % 3;
      const float dx = turn * (seen.cornerX[next][triangle] - seen.cornerX[c][triangle]);
      const float dy = turn * (seen.cornerY[next][triangle] - seen.cornerY[c][triangle]);
      m_inside[c] = {
          -dy, dx,
          dx * (first.y - seen.cornerY[c][triangle]) - dy * (first.x - seen.cornerX[c][triangle])};
      around += std::abs(dx) + std::abs(dy);
    }
    // By no more than this do moves of corners within the slack change what lies within the box.
    constexpr float slack = SeenCluster::slack;
    const float moves = corners == Corners::rounded ? slack * around : 0.0f;
    for (glm::vec3& edge : m_inside)
      edge.z += slack * (std::abs(edge.x) + std::abs(edge.y)) + moves;
  }

  /// Takes a middle's place in the box.
  bool hold(int column, int row) const {
    const glm::vec3 at(float(column), float(row), 1.0f);
    return glm::dot(m_inside[0], at) >= 0.0f && glm::dot(m_inside[1], at) >= 0.0f &&
           glm::dot(m_inside[2], at) >= 0.0f;
  }
  /// Returns an edge as what its side towards the triangle has above zero: per column, per row, and
  /// at the first middle.
  const glm::vec3& inside(std::size_t edge) const { return m_inside[edge]; }

 private:
  std::array<glm::vec3, 3> m_inside{};
};

}  // namespace sline::render
