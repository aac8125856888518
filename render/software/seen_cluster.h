// SPDX-License-Identifier: Apache-2.0
// Projects clusters of triangles into the picture, and tells which samples a triangle covers, as a
// rasteriser does (METHOD §10).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "model/geometry/surface.h"
#include "render/drawn/picture_view.h"

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
/// pixels below, and its triangles' boxes and edges.
struct SeenCluster {
  using Vertices = std::array<float, model::Clusters::maximumVertices>;
  using Triangles = std::array<float, model::Clusters::maximumTriangles>;
  using Counts = std::array<std::int32_t, model::Clusters::maximumTriangles>;
  /// By how much a driver's vertices may lie beside ours, in pixels: it rounds them to 1/256.
  static constexpr float slack = 1.0f / 256.0f;

  Vertices x;
  Vertices y;
  Vertices depth;     ///< of the window: 0 … 1
  Vertices w;         ///< the distance from the eye's plane, or 1 in a parallel projection
  bool withinDepths;  ///< all of them lie within the view's depths
  std::array<Triangles, 3> cornerX;
  std::array<Triangles, 3> cornerY;
  std::array<Triangles, 3> cornerDepth;
  Triangles area;  ///< doubled; positive: turned to the eye
  /// The first middle of a pixel in each triangle's box and how many there are.
  Counts left;
  Counts bottom;
  Counts columns;
  Counts rows;
  /// A number that changes evenly across a triangle: at the first middle, and its rise per column
  /// and per row.
  struct Slopes {
    Triangles first, perColumn, perRow;
  };
  std::array<Slopes, 3> inside;  ///< of each edge; below 0: beyond it
  Slopes steepness;              ///< of the depth
  Triangles least, most;         ///< of the corners' depths

  /// Projects the vertices. Returns false where some lie behind the eye or too far away to tell.
  bool project(const model::Cluster& cluster, const ClusterPlaces& places, const PictureView& view,
               const SampleGrid& grid);
  /// Finds the triangles' areas and which middles of pixels their boxes hold.
  void findBoxes(std::span<const std::array<std::uint8_t, 3>> triangles);
  /// Says which middles a triangle holds. `rounded`: wherever a driver may round the corners to;
  /// `exact`: as they are, and a hair more, so that no gap is left between neighbours.
  enum class Corners { exact, rounded };
  /// Finds the slopes of the first so many triangles, whose boxes are known.
  void findSlopes(std::size_t count, Corners corners);
  /// Tells by the slopes whether a triangle holds one of the middles in its box.
  bool holds(std::size_t triangle, int column, int row) const {
    return std::all_of(inside.begin(), inside.end(), [&](const Slopes& edge) {
      return edge.perColumn[triangle] * float(column) + edge.perRow[triangle] * float(row) +
                 edge.first[triangle] >=
             0.0f;
    });
  }
};

}  // namespace sline::render
