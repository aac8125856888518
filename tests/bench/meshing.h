// SPDX-License-Identifier: Apache-2.0
// Compares the results of the mesh workshop with those of OpenMesh's own algorithms: why the one is
// used and the other not (ARCHITECTURE.md). Figures of one run are compared with each other; times
// are the processor's, the least of three.
#pragma once

#include <string>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::bench {

struct Decimated {
  std::size_t triangles = 0;
  float error = 0.0f;  ///< the farther of both directions, mm
  double milliseconds = 0.0;
};

struct MeshingRow {
  std::string name;
  std::size_t triangles = 0;
  std::size_t refusedFaces = 0;  ///< faces that OpenMesh's add_face refused
  Decimated decimated;
  Decimated openMeshDecimated;  ///< DecimaterT with its own modules, within the same error
  double adjacencyMs = 0.0;     ///< half-edges and rings
  double openMeshAdjacencyMs = 0.0;
  double subdivisionMs = 0.0;  ///< one step of Loop's scheme
  double openMeshSubdivisionMs = 0.0;
};

/// Measures the mesh, with decimation to `bound` mm. The mesh is not empty.
MeshingRow measureMeshing(const std::string& name, const model::MeshPtr& mesh, float bound);

std::string asText(const std::vector<MeshingRow>& rows);

}  // namespace sline::bench
