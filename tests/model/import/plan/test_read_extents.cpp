// SPDX-License-Identifier: Apache-2.0
// Tests that sizes are those of what was read, not of what import made of it.
#include <QTemporaryDir>
#include <QTest>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/import/plan/import.h"
#include "model/import/plan/reload.h"
#include "model/lengths/measured_extent.h"
#include "model/scene_file/scene_file.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

namespace {

/// Returns a volume of 12³ voxels of 2 mm with a cube of that many voxels a side, label 1.
QByteArray cube(int side) {
  QByteArray text =
      "NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: 12 12 12\n"
      "space directions: (2,0,0) (0,2,0) (0,0,2)\nspace origin: (0,0,0)\nencoding: ascii\n\n";
  for (int z = 0; z < 12; ++z)
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 12; ++x)
        text += std::min({x, y, z}) >= 2 && std::max({x, y, z}) < 2 + side ? "1 " : "0 ";
  return text;
}

Scene imported(const QTemporaryDir& folder, const ImportOptions& options = {}) {
  const auto result =
      importInputs(std::array{std::filesystem::path(folder.path().toStdString())}, options);
  return result.ok() ? result->scene : Scene();
}

bool insideBall(const glm::vec3& p) {
  return glm::length(p - glm::vec3(10.0f)) < 8.0f;
}

/// Returns how many voxels of 1 mm the ball has.
double voxelsOfBall() {
  int count = 0;
  for (int z = 0; z < 20; ++z)
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 20; ++x)
        count += insideBall(glm::vec3(x, y, z) + 0.5f);
  return double(count);
}

}  // namespace

class ReadExtentsTest : public QObject {
  Q_OBJECT
 private slots:
  /// Smoothing takes the corners off a cube of voxels; its volume stays that of the voxels.
  void voxelsCount() {
    QTemporaryDir folder;
    writeText(folder.filePath("tumour.nrrd"), cube(8));
    const Scene scene = imported(folder);
    QCOMPARE(scene.structuresBelow(rootId).size(), std::size_t(1));
    const Node& node = *scene.find(scene.structuresBelow(rootId).front());
    QVERIFY(node.provenance.displacementMm > 0.0f);
    const double drawn = *extentOf(*node.mesh).volume;
    QVERIFY2(std::abs(drawn - 4096.0) > 0.01, qPrintable(QString::number(drawn)));
    const MeasuredExtent measured = measuredExtent(node);
    QVERIFY(measured.volumeAsRead && !measured.areaAsRead);
    QCOMPARE(*measured.extent.volume, 4096.0);
    // A scene keeps it.
    const std::filesystem::path file = folder.filePath("kept.sline").toStdString();
    QVERIFY(writeSceneFile(file, SceneDocument{.scene = scene}).ok());
    const auto again = readSceneFile(file);
    QVERIFY(again.ok());
    QCOMPARE(*measuredExtent(*again->scene.find(node.id)).extent.volume, 4096.0);
  }

  void steppedSurfaces() {
    QTemporaryDir folder;
    const MeshPtr steps = voxelSurface(20, insideBall);
    writeMesh(folder.filePath("liver.obj"), *steps);
    const Scene scene = imported(folder);
    const Node& node = named(scene, "liver");
    QVERIFY(node.provenance.smoothingSteps > 0);
    const MeasuredExtent measured = measuredExtent(node);
    QVERIFY(measured.volumeAsRead && measured.areaAsRead);
    QVERIFY(std::abs(*measured.extent.volume - voxelsOfBall()) < 0.01);
    QVERIFY(std::abs(measured.extent.area - extentOf(*steps).area) < 0.01);
    // The surface that is drawn is another one.
    QVERIFY(extentOf(*node.mesh).area < 0.9 * measured.extent.area);
  }

  void unitsCount() {
    QTemporaryDir folder;
    writeMesh(folder.filePath("liver.obj"), *voxelSurface(20, insideBall));
    ImportOptions options;
    options.unit = 10.0f;
    const Scene scene = imported(folder, options);
    const double volume = *measuredExtent(named(scene, "liver")).extent.volume;
    QVERIFY(std::abs(volume / (1000.0 * voxelsOfBall()) - 1.0) < 1e-5);
  }

  void whatIsLeftAloneIsMeasuredItself() {
    QTemporaryDir folder;
    writeMesh(folder.filePath("liver.obj"), *voxelSurface(20, insideBall));
    ImportOptions options;
    options.smoothing.mode = Smoothing::Mode::off;
    const Scene scene = imported(folder, options);
    const Node& node = named(scene, "liver");
    QVERIFY(isAsRead(node.provenance) && !node.provenance.asRead);
    QVERIFY(measuredExtent(node).volumeAsRead);
    // Fewer triangles are another surface, whose own volume does not count.
    options.decimateMm = 0.5f;
    const Scene fewer = imported(folder, options);
    const Node& simple = named(fewer, "liver");
    QVERIFY(simple.mesh->triangleCount() < node.mesh->triangleCount());
    QVERIFY(std::abs(*measuredExtent(simple).extent.volume - voxelsOfBall()) < 0.01);
  }

  /// Scenes of older programs do not know what was read: that is said.
  void unknownIsSaid() {
    QTemporaryDir folder;
    writeMesh(folder.filePath("liver.obj"), *voxelSurface(20, insideBall));
    Node node = named(imported(folder), "liver");
    node.provenance.asRead.reset();
    const MeasuredExtent measured = measuredExtent(node);
    QVERIFY(!measured.volumeAsRead && !measured.areaAsRead);
  }

  void reloadMeasuresAgain() {
    QTemporaryDir folder;
    const QString file = folder.filePath("liver.obj");
    writeMesh(file, *voxelSurface(20, insideBall));
    const Scene scene = imported(folder);
    const double before = *measuredExtent(named(scene, "liver")).extent.volume;
    writeMesh(file, *voxelSurface(20, [](const glm::vec3& p) {
                return glm::length(p - glm::vec3(10.0f)) < 6.0f;
              }));
    const Reloaded reloaded =
        reload(scene, std::array{std::filesystem::path(folder.path().toStdString())});
    QVERIFY(reloaded.changed);
    const Node& now = named(reloaded.scene, "liver");
    QVERIFY(measuredExtent(now).volumeAsRead);
    const double after = *measuredExtent(now).extent.volume;
    QVERIFY2(after > 0.35 * before && after < 0.5 * before, qPrintable(QString::number(after)));
  }
};

SLINE_TEST(ReadExtentsTest)
#include "test_read_extents.moc"
