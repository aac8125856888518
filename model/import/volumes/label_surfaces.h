// SPDX-License-Identifier: Apache-2.0
// Makes the surfaces of a label volume's structures.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "model/import/source/raw_mesh.h"
#include "model/import/source/read_options.h"
#include "model/import/volumes/formats/label_volume.h"
#include "model/import/volumes/label_sheets.h"
#include "model/import/volumes/surface_net.h"

namespace sline::model {

/// Returns one closed, outward oriented, manifold surface per label that has a voxel, in the order
/// of `labels`, in millimetres in the volume's own frame. Structures that touch share their faces,
/// vertex for vertex. Where a label reaches the border of the volume its surface closes half a
/// voxel outside the last voxel's centre.
///
/// `options.smoothing`: `off` leaves each vertex in the middle of its cell, `steps` relaxes it that
/// often within its cell, by less than half a voxel along any axis, `automatic` until steps are
/// gone, by less than a voxel (net_relaxation.h). RawMesh::displacement says how far the farthest
/// vertex moved. What is there already is not made (ReadOptions::isThere).
/// Errors: more vertices or triangles than the limits allow, a matrix that cannot be inverted, and
/// `goesOn` having said no; they name no file.
Result<RawMeshes> labelSurfaces(const LabelVolume& volume, const ReadOptions& options);

/// Holds a volume's net with its sheets; a place is (x, y, z) of voxels of the box times `spacing`.
struct LabelNet {
  const VoxelBox& box;
  const SurfaceNet& net;
  const LabelSheets& sheets;
  glm::vec3 spacing;
};
/// Returns where each point of the net comes to lie; nothing where it was told to give up.
using NetPlacement = std::function<std::vector<glm::vec3>(const LabelNet&)>;

/// Returns the surfaces with vertices at the places that `placement` gives.
Result<RawMeshes> placedSurfaces(const LabelVolume& volume, const ReadOptions& options,
                                 const NetPlacement& placement);

}  // namespace sline::model
