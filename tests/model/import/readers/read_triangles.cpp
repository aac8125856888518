// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/readers/read_triangles.h"

#include <QTemporaryDir>

#include "tests/model/import/readers/mesh_files.h"

namespace sline::test {

std::vector<model::Triangle> trianglesOf(const QString& extension, const QByteArray& bytes) {
  QTemporaryDir folder;
  const Result<model::RawMeshes> read = readBytes(folder, "detail" + extension, bytes);
  if (!read)
    qWarning("%s", read.error().text().c_str());
  return read ? read->meshes.front().triangles : std::vector<model::Triangle>();
}

}  // namespace sline::test
