// SPDX-License-Identifier: Apache-2.0
// Measures a surface without knowing how it was made; reads bytes as DICOM files.
#pragma once

#include <QByteArray>
#include <QTemporaryDir>

#include "model/import/source/raw_mesh.h"
#include "model/import/source/read_options.h"

namespace sline::test {

struct SurfaceFacts {
  double volume = 0.0;  ///< mm³, positive if normals point outward
  glm::dvec3 low{0.0};
  glm::dvec3 high{0.0};
  bool closed = false;  ///< each edge has two triangles, which run along it in opposite directions
  std::size_t pieces = 0;
  long euler = 0;  ///< V − E + F: 2 for a ball, 0 for a ring
};
SurfaceFacts factsOf(const model::RawMesh& mesh);

Result<model::RawMeshes> readDicomBytes(const QTemporaryDir& folder, const QByteArray& bytes,
                                        const model::ReadOptions& options = {});
/// Returns the surface of that name; aborts the test program if there is none.
const model::RawMesh& named(const model::RawMeshes& read, const std::string& name);
QString warningsOf(const model::RawMeshes& read);

}  // namespace sline::test
