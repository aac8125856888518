// SPDX-License-Identifier: Apache-2.0
// Tests that one surface in many encodings loads equal: the real one in 22, and the tests' own cube
// in all.
#include <QDir>
#include <QTest>
#include <algorithm>
#include <array>

#include "tests/model/import/readers/mesh_files.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

namespace {
using Corners = std::array<glm::vec3, 3>;

bool before(const glm::vec3& a, const glm::vec3& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// Returns triangles as corner positions, each turned so that its least corner comes first (which
/// keeps its orientation), sorted. Positions are rounded so that text and binary agree.
std::vector<std::array<std::array<long, 3>, 3>> cornerSet(const model::RawMesh& mesh, double grid) {
  std::vector<std::array<std::array<long, 3>, 3>> set;
  for (const model::Triangle& t : mesh.triangles) {
    std::array<std::array<long, 3>, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      for (int axis = 0; axis < 3; ++axis)
        corners[k][std::size_t(axis)] = std::lround(double(mesh.positions[t[k]][axis]) / grid);
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    set.push_back(corners);
  }
  std::sort(set.begin(), set.end());
  return set;
}

/// Returns the largest distance between corners of two sorted lists of triangles.
double farthest(const model::RawMesh& a, const model::RawMesh& b) {
  const auto sorted = [](const model::RawMesh& mesh) {
    std::vector<Corners> list;
    for (const model::Triangle& t : mesh.triangles) {
      Corners corners{mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), before),
                  corners.end());
      list.push_back(corners);
    }
    return list;
  };
  const std::vector<Corners> first = sorted(a);
  const std::vector<Corners> second = sorted(b);
  double distance = first.size() == second.size() ? 0.0 : 1e9;
  // Formats without strips keep the order of triangles too.
  for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      for (int axis = 0; axis < 3; ++axis)
        distance = std::max(distance, std::abs(double(first[i][k][axis] - second[i][k][axis])));
  return distance;
}
}  // namespace

class TestSameMesh : public QObject {
  Q_OBJECT

 private slots:
  void adrenal_data() {
    QTest::addColumn<QString>("path");
    const QDir folder(QString(SLINE_TEST_DATA) + "/formats/same_mesh");
    for (const QString& name : folder.entryList({"adrenal*"}, QDir::Files))
      QTest::newRow(qPrintable(name)) << folder.filePath(name);
  }

  void adrenal() {
    if (!QDir(QString(SLINE_TEST_DATA) + "/formats/same_mesh").exists())
      SLINE_ABSENT("the folder formats/same_mesh of the test data is absent");
    QFETCH(QString, path);
    const QString reference = QString(SLINE_TEST_DATA) + "/formats/same_mesh/adrenal_binary_le.ply";
    const Result<model::RawMeshes> expected = model::readSurfaces(reference.toStdString());
    const Result<model::RawMeshes> read = model::readSurfaces(path.toStdString());
    QVERIFY2(expected, "the reference encoding cannot be read");
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QCOMPARE(read->meshes.size(), std::size_t(1));
    QVERIFY2(read->warnings.empty(), qPrintable(warningText(*read)));
    const model::RawMesh& mesh = read->meshes.front();
    const model::RawMesh& wanted = expected->meshes.front();
    QCOMPARE(mesh.positions.size(), path.endsWith(".stl") ? std::size_t(771) : std::size_t(778));
    QCOMPARE(mesh.triangles.size(), std::size_t(1538));
    // Six digits of text leave 1e-4 of these coordinates; strips also change the triangles' order.
    if (!path.contains("strips"))
      QVERIFY2(farthest(mesh, wanted) < 1.5e-4,
               qPrintable(QString::number(farthest(mesh, wanted))));
    const bool rounded =
        path.endsWith(".off") || path.contains("legacy42_ascii") || path.contains("legacy51_ascii");
    if (!rounded)
      QCOMPARE(cornerSet(mesh, 1e-5), cornerSet(wanted, 1e-5));
    QVERIFY(std::abs(volume(mesh) - volume(wanted)) < 1e-5 * std::abs(volume(wanted)));
    QVERIFY(volume(wanted) != 0.0);
  }

  void all22AreThere() {
    const QDir folder(QString(SLINE_TEST_DATA) + "/formats/same_mesh");
    if (!folder.exists())
      SLINE_ABSENT("the folder formats/same_mesh of the test data is absent");
    QVERIFY(folder.entryList({"adrenal*"}, QDir::Files).size() >= 22);
  }

  void cube_data() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<QByteArray>("bytes");
    for (const MeshFile& file : cubeFiles())
      QTest::newRow(file.kind) << QString(file.extension) << file.bytes;
  }

  void cube() {
    QFETCH(QString, extension);
    QFETCH(QByteArray, bytes);
    QTemporaryDir folder;
    const Result<model::RawMeshes> read = readBytes(folder, "cube" + extension.toUpper(), bytes);
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QVERIFY2(read->warnings.empty(), qPrintable(warningText(*read)));
    QCOMPARE(read->meshes.size(), std::size_t(1));
    const model::RawMesh& mesh = read->meshes.front();
    QCOMPARE(mesh.positions.size(), std::size_t(8));
    QCOMPARE(mesh.triangles.size(), std::size_t(12));
    QCOMPARE(volume(mesh), 6.0);
    const bool gltf = extension.startsWith(".gl");
    QCOMPARE(mesh.yUp, gltf);
    QCOMPARE(mesh.millimetresPerUnit, gltf ? 1000.0f : 1.0f);
  }
};

SLINE_TEST_WITH_EVENTS(TestSameMesh)
#include "test_same_mesh.moc"
