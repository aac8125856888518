// SPDX-License-Identifier: Apache-2.0
// Tests decimation as part of an import: what it is applied to, what provenance records of it, and
// real anatomy.
#include <QtTest>
#include <array>

#include "model/geometry/spatial_order.h"
#include "model/geometry/topology.h"
#include "model/import/plan/import.h"
#include "model/meshing/simplification.h"
#include "model/scene_file/scene_file.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {
Result<Imported> import(const QString& file, float decimateMm, float unit = 1.0f) {
  ImportOptions options;
  options.decimateMm = decimateMm;
  options.unit = unit;
  options.smoothing.mode = Smoothing::Mode::off;
  return importInputs(std::array{std::filesystem::path(file.toStdString())}, options);
}

const Node& only(const Imported& imported) {
  return *imported.scene.find(imported.scene.structuresBelow(rootId).front());
}
}  // namespace

class DecimationTest : public QObject {
  Q_OBJECT
 private slots:
  void boundIsInMillimetres_data() {
    QTest::addColumn<float>("unit");
    QTest::newRow("mm") << 1.0f;
    QTest::newRow("cm") << 10.0f;
  }
  void boundIsInMillimetres() {
    QFETCH(float, unit);
    const QTemporaryDir folder;
    const QString file = folder.filePath("ball.ply");
    test::writeMesh(file, *test::moved(*test::sphere(50, 4), 1.0f / unit, {7, 8, 9}), std::nullopt);
    const auto whole = import(file, 0.0f, unit);
    const auto fewer = import(file, 0.4f, unit);
    QVERIFY(whole.ok() && fewer.ok());
    const Node& before = only(*whole);
    const Node& after = only(*fewer);
    QCOMPARE(before.provenance.decimatedFrom, 0);
    QCOMPARE(before.provenance.decimationMm, 0.0f);
    QCOMPARE(after.provenance.decimatedFrom, int(before.mesh->triangleCount()));
    QVERIFY(after.mesh->triangleCount() * 2 < before.mesh->triangleCount());
    QVERIFY(after.mesh->triangleCount() > 300);
    QVERIFY(after.provenance.decimationMm > 0.1f && after.provenance.decimationMm <= 0.4f);
  }

  void provenanceIsSaved() {
    const QTemporaryDir folder;
    test::writeMesh(folder.filePath("ball.ply"), *test::sphere(50, 4), std::nullopt);
    const auto fewer = import(folder.filePath("ball.ply"), 0.4f);
    QVERIFY(fewer.ok());
    const auto bytes = sceneFileBytes({.scene = fewer->scene});
    QVERIFY(bytes.ok());
    const auto again = documentFromBytes(*bytes);
    QVERIFY(again.ok());
    QVERIFY(again->scene.nodes().front().provenance == only(*fewer).provenance);
  }

  void liverOfTheAtlas() {
    const QString file = QStringLiteral(SLINE_TEST_DATA "/abdomen/Data/Model_3_liver.vtk");
    if (!QFileInfo::exists(file))
      SLINE_ABSENT("the abdomen of the test data is absent");
    const auto whole = import(file, 0.0f);
    const auto fewer = import(file, 0.3f);
    QVERIFY(whole.ok() && fewer.ok());
    const Mesh& before = *only(*whole).mesh;
    const MeshPtr after = only(*fewer).mesh;
    qInfo("%zu triangles to %zu, %.3f mm", before.triangleCount(), after->triangleCount(),
          double(only(*fewer).provenance.decimationMm));
    QVERIFY(after->triangleCount() * 2 < before.triangleCount());
    QVERIFY(farthestSample(before, Bvh(after, spatialOrder(*after)), 0.5f) < 1.05f * 0.3f);
    const EdgeCount edgesBefore = countEdges(before, VertexFaces(before));
    const EdgeCount edgesAfter = countEdges(*after, VertexFaces(*after));
    QCOMPARE(edgesAfter.open, edgesBefore.open);
    QCOMPARE(edgesAfter.nonManifold, edgesBefore.nonManifold);
    QCOMPARE(connectedComponents(*after).count, connectedComponents(before).count);
  }
};

SLINE_TEST_WITH_EVENTS(DecimationTest)
#include "test_decimation.moc"
