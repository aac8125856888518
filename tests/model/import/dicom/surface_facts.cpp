// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/dicom/surface_facts.h"

#include <QFile>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>

#include "model/geometry/topology.h"
#include "model/import/dicom/dicom.h"

namespace sline::test {

SurfaceFacts factsOf(const model::RawMesh& mesh) {
  SurfaceFacts facts;
  facts.low = glm::dvec3(1e30);
  facts.high = glm::dvec3(-1e30);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const model::Triangle& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t[0]]);
    const glm::dvec3 b(mesh.positions[t[1]]);
    const glm::dvec3 c(mesh.positions[t[2]]);
    facts.volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    for (std::size_t k = 0; k < 3; ++k)
      ++edges[{t[k], t[(k + 1) % 3]}];
  }
  for (const glm::vec3& p : mesh.positions) {
    facts.low = glm::min(facts.low, glm::dvec3(p));
    facts.high = glm::max(facts.high, glm::dvec3(p));
  }
  facts.closed = !edges.empty();
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    facts.closed = facts.closed && count == 1 && back != edges.end() && back->second == 1;
  }
  facts.euler = long(mesh.positions.size()) - long(edges.size() / 2) + long(mesh.triangles.size());
  if (const auto made = model::Mesh::create(mesh.positions, mesh.triangles))
    facts.pieces = model::connectedComponents(*made).count;
  return facts;
}

Result<model::RawMeshes> readDicomBytes(const QTemporaryDir& folder, const QByteArray& bytes,
                                        const model::ReadOptions& options) {
  const QString path = folder.filePath("file.dcm");
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
    qFatal("cannot write %s", qPrintable(path));
  file.close();
  return model::readDicom(path.toStdString(), options);
}

const model::RawMesh& named(const model::RawMeshes& read, const std::string& name) {
  for (const model::RawMesh& mesh : read.meshes)
    if (mesh.name == name)
      return mesh;
  qFatal("no surface %s", name.c_str());
}

QString warningsOf(const model::RawMeshes& read) {
  QString all;
  for (const model::ImportWarning& warning : read.warnings)
    all += QString::fromStdString(warning.reason) + "; ";
  return all;
}

}  // namespace sline::test
