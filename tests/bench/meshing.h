// SPDX-License-Identifier: Apache-2.0
// What the mesh workshop makes of surfaces, beside what OpenMesh's own algorithms make of them: why
// the one is used and the other not (model/LIBRARIES.md). Figures of one run are compared with each
// other; times are of the processor, the least of three.
#pragma once

#include <string>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::bench {

struct Decimated {
  std::size_t triangles = 0;
  float error = 0.0f;  ///< farther of both directions, mm
  double milliseconds = 0.0;
};

struct MeshingRow {
  std::string name;
  std::size_t triangles = 0;
  std::size_t refusedFaces = 0;  ///< by OpenMesh's add_face
  Decimated decimated;
  Decimated openMeshDecimated;  ///< DecimaterT with its own modules, within the same error
  double adjacencyMs = 0.0;     ///< half-edges and rings
  double openMeshAdjacencyMs = 0.0;
  double subdivisionMs = 0.0;  ///< one step of Loop's scheme
  double openMeshSubdivisionMs = 0.0;
};

/// Measures with decimation to `bound` mm. The mesh is not empty.
MeshingRow measureMeshing(const std::string& name, const model::MeshPtr& mesh, float bound);

std::string asText(const std::vector<MeshingRow>& rows);

}  // namespace sline::bench
