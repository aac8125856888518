// SPDX-License-Identifier: Apache-2.0
// From a surface net to one closed triangle mesh per structure.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/geometry/mesh.h"
#include "model/import/volumes/cell_cycles.h"
#include "model/import/volumes/surface_net.h"

namespace sline::model {

/// The quadrilaterals of a net, each across the edge between two voxels of different structures,
/// sorted by structure.
class NetFaces {
 public:
  NetFaces(const VoxelBox& box, const SurfaceNet& net, std::size_t labels);

  /// Of label n (1 …).
  std::size_t count(std::size_t label) const { return m_first[label] - m_first[label - 1]; }

  struct LabelMesh {
    std::vector<std::uint32_t> cells;  ///< of each vertex: the cell in which it lies
    std::vector<glm::vec3> positions;
    std::vector<Triangle> triangles;  ///< counter-clockwise seen from outside the structure
  };
  /// The closed surface of label n around `at`, the vertices of the net. A cell in which it has
  /// several sheets gives it several vertices at one place, so that every edge has two triangles
  /// and every vertex one fan of them.
  LabelMesh mesh(std::size_t label, std::span<const glm::vec3> at) const;

 private:
  /// The cell at the far end, times 8, the axis of the edge, times 2, and whether the structure
  /// lies at the edge's end rather than at its beginning.
  using Face = std::uint32_t;
  friend class LabelMesher;

  const VoxelBox& m_box;
  const SurfaceNet& m_net;
  CellCycles m_cycles;
  std::vector<Face> m_faces;
  std::vector<std::size_t> m_first;  ///< of label n + 1 in m_faces
};

}  // namespace sline::model
