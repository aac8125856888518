// SPDX-License-Identifier: Apache-2.0
#include <QtTest>
#include <array>
#include <atomic>
#include <glm/geometric.hpp>
#include <mutex>

#include "model/disk/memory_budget.h"
#include "model/import/plan/import.h"
#include "model/scene_file/ply_writer.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

using Path = std::filesystem::path;
Path path(const QTemporaryDir& folder, const QString& below = {}) {
  return Path(folder.filePath(below).toStdString());
}

}  // namespace

class ImportTest : public QObject {
  Q_OBJECT
 private slots:
  void errors_data();
  void errors();
  void partsThatFailAreWarnings();
  void whatMemoryHasNoRoomForIsAWarning();
  void cleanMeshIsBitEqual();
  void progressRises();
  void cancel_data();
  void cancel();
  void provenanceTellsWhatWasDone();
  void repairCanBeOff();
  void sameResultWhateverTheThreads();
};

void ImportTest::errors_data() {
  QTest::addColumn<QString>("input");
  QTest::addColumn<QString>("message");
  QTest::newRow("absent") << "nowhere.stl"
                          << "no such file";
  QTest::newRow("kind") << "notes.txt"
                        << ".glb";
  QTest::newRow("archive") << "meshes.zip"
                           << "Unpack it";
  QTest::newRow("folder of an archive") << "packed"
                                        << "meshes.zip is an archive";
  QTest::newRow("empty folder") << "empty"
                                << "holds no mesh";
  QTest::newRow("broken mesh") << "broken.stl"
                               << "broken.stl";
  QTest::newRow("folder of broken meshes") << "bad"
                                           << "broken";
}

void ImportTest::errors() {
  QFETCH(QString, input);
  QFETCH(QString, message);
  const QTemporaryDir folder;
  test::writeText(folder.filePath("notes.txt"), "hello");
  test::writeText(folder.filePath("empty/README"), "nothing here");
  for (const char* name : {"meshes.zip", "packed/meshes.zip"})
    test::writeText(folder.filePath(name), "PK");
  test::writeText(folder.filePath("broken.stl"), "x");
  test::writeText(folder.filePath("bad/broken.ply"), "ply\n");
  test::writeText(folder.filePath("bad/broken.obj"), "f 1 2 3\n");
  const auto imported = importInputs(std::array{path(folder, input)}, {});
  QVERIFY(!imported.ok());
  const QString text = QString::fromStdString(imported.error().text());
  QVERIFY2(text.contains(message), qPrintable(text));
  QVERIFY(!importInputs(std::vector<Path>{}, {}).ok());
}

void ImportTest::partsThatFailAreWarnings() {
  const QTemporaryDir folder;
  test::writeMesh(folder.filePath("liver.obj"), *test::octahedron({}, 20));
  test::writeText(folder.filePath("spleen.obj"), "v 0 0\nf 1 2 3\n");
  for (const char* name : {"more.ZIP", "deep/scene.mrb"})
    test::writeText(folder.filePath(name), "PK");
  const auto imported = importInputs(std::array{path(folder), path(folder, "nowhere.ply")}, {});
  QVERIFY(imported.ok());
  QCOMPARE(imported->scene.nodes().size(), std::size_t(1));
  QVERIFY(test::warningsOf(*imported).contains("spleen.obj"));
  QVERIFY(test::warningsOf(*imported).contains("nowhere.ply"));
  QVERIFY(test::warningsOf(*imported).contains(
      "scene.mrb, more.ZIP are archives and were not looked into"));
}

void ImportTest::whatMemoryHasNoRoomForIsAWarning() {
  const QTemporaryDir folder;
  const MeshPtr large = test::sphere(20.0f, 5);
  const MeshPtr small = test::sphere(10.0f, 3);
  for (const auto& [name, mesh] : {std::pair("large.ply", large), std::pair("small.ply", small)}) {
    QFile file(folder.filePath(name));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(plyText(*mesh, "SPACE=LPS")));
  }
  ImportOptions options;
  const std::array inputs{path(folder)};
  options.memoryBytes = (small->triangleCount() + 1) * bytesPerTriangle;
  const auto some = importInputs(inputs, options);
  QVERIFY(some.ok());
  QCOMPARE(some->scene.structuresBelow(rootId).size(), std::size_t(1));
  QCOMPARE(some->report.warnings.size(), std::size_t(1));
  QCOMPARE(some->report.warnings.front().file, std::string("large.ply"));
  QVERIFY(some->report.warnings.front().reason.find("of memory, and 0.0 GB are left") !=
          std::string::npos);
  options.memoryBytes = 1;
  const auto none = importInputs(inputs, options);
  QVERIFY(!none.ok());
  QVERIFY(none.error().text().find("of memory") != std::string::npos);
}

void ImportTest::cleanMeshIsBitEqual() {
  const QTemporaryDir folder;
  const MeshPtr mesh = test::moved(*test::sphere(50, 7), 1.0f, {13.37f, -4.2f, 100.1f});
  test::writeMesh(folder.filePath("liver.ply"), *mesh, Frame::lps);
  const auto imported = importInputs(std::array{path(folder, "liver.ply")}, {});
  QVERIFY(imported.ok());
  const Node& node = imported->scene.nodes().front();
  QVERIFY(*node.mesh == *mesh);
  QCOMPARE(node.provenance.smoothingSteps + node.provenance.refinementSteps +
               node.provenance.repairedFaces,
           0);
}

void ImportTest::progressRises() {
  const QTemporaryDir folder;
  for (int i = 0; i < 20; ++i)
    test::writeMesh(folder.filePath(QString("part%1.ply").arg(i)),
                    *test::sphere(10.0f + float(i), 3));
  std::vector<float> seen;
  std::mutex mutex;
  const auto imported =
      importInputs(std::array{path(folder)}, {}, [&](float done, const std::string&) {
        const std::lock_guard lock(mutex);
        seen.push_back(done);
        return true;
      });
  QVERIFY(imported.ok());
  QVERIFY(seen.size() >= 20);
  QVERIFY(std::is_sorted(seen.begin(), seen.end()));
  QVERIFY(seen.front() >= 0.0f && seen.front() < 0.1f);
  QVERIFY(seen.back() <= 1.0f && seen.back() > 0.5f);
}

void ImportTest::cancel_data() {
  QTest::addColumn<int>("after");
  QTest::newRow("at once") << 0;
  QTest::newRow("while reading") << 5;
  QTest::newRow("while smoothing") << 45;
}

void ImportTest::cancel() {
  QFETCH(int, after);
  const QTemporaryDir folder;
  for (int i = 0; i < 40; ++i)
    test::writeMesh(folder.filePath(QString("part%1.ply").arg(i)), *test::sphere(10.0f, 2));
  std::atomic<int> calls = 0;
  const auto imported = importInputs(std::array{path(folder)}, {},
                                     [&](float, const std::string&) { return calls++ < after; });
  QVERIFY(!imported.ok());
  QVERIFY(QString::fromStdString(imported.error().text()).contains("cancelled"));
  QVERIFY2(calls <= after + 4, qPrintable(QString::number(calls)));
}

void ImportTest::provenanceTellsWhatWasDone() {
  const QTemporaryDir folder;
  test::writeMesh(folder.filePath("liver.stl"), *test::sphere(50, 2));
  test::writeMesh(folder.filePath("spleen.ply"), *test::voxelSurface(40, [](const glm::vec3& p) {
                    return glm::distance(p, glm::vec3(20.2f)) < 16.0f;
                  }));
  const auto imported = importInputs(std::array{path(folder)}, {});
  QVERIFY(imported.ok());
  const Provenance& coarse = test::named(imported->scene, "liver").provenance;
  QCOMPARE(coarse.refinementSteps, 2);
  QCOMPARE(coarse.smoothingSteps, 0);
  const Provenance& stepped = test::named(imported->scene, "spleen").provenance;
  QVERIFY(stepped.smoothingSteps > 0);
  QVERIFY(stepped.displacementMm > 0.1f && stepped.displacementMm < 1.5f);
  ImportOptions off;
  off.smoothing.mode = Smoothing::Mode::off;
  const auto raw = importInputs(std::array{path(folder)}, off);
  QVERIFY(raw.ok());
  for (const Node& node : raw->scene.nodes())
    QCOMPARE(node.provenance.smoothingSteps + node.provenance.refinementSteps, 0);
}

void ImportTest::repairCanBeOff() {
  const QTemporaryDir folder;
  test::writeText(folder.filePath("a.off"),
                  "OFF\n4 6 0\n0 0 0\n9 0 0\n0 9 0\n0 0 9\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n"
                  "3 1 3 2\n3 0 1 2\n");
  ImportOptions options;
  options.smoothing.mode = Smoothing::Mode::off;
  const auto mended = importInputs(std::array{path(folder)}, options);
  QVERIFY(mended.ok());
  QCOMPARE(mended->scene.nodes().front().mesh->triangleCount(), std::size_t(4));
  QCOMPARE(mended->scene.nodes().front().provenance.repairedFaces, 6);
  // A repair that loses nothing gives no warning: one line for all surfaces, and one for each.
  QVERIFY(mended->report.warnings.empty());
  QCOMPARE(mended->report.repairs.summary,
           std::string("repaired 1 of 1 surface: 2 faces given twice left out"));
  QCOMPARE(mended->report.repairs.surfaces,
           std::vector<std::string>{"a.off: \"a\": 2 faces given twice"});
  options.repair = false;
  const auto raw = importInputs(std::array{path(folder)}, options);
  QVERIFY(raw.ok());
  QCOMPARE(raw->scene.nodes().front().mesh->triangleCount(), std::size_t(6));
}

void ImportTest::sameResultWhateverTheThreads() {
  const QTemporaryDir folder;
  for (int i = 0; i < 12; ++i)
    test::writeMesh(folder.filePath(QString("part%1.ply").arg(i)),
                    *test::moved(*test::sphere(10.0f, 3), 1.0f, {5.0f * float(i), 0, 0}));
  const auto first = importInputs(std::array{path(folder)}, {});
  QVERIFY(first.ok());
  for (int i = 0; i < 5; ++i) {
    const auto again = importInputs(std::array{path(folder)}, {});
    QVERIFY(again.ok());
    QCOMPARE(again->scene.nodes().size(), first->scene.nodes().size());
    for (std::size_t k = 0; k < first->scene.nodes().size(); ++k) {
      QCOMPARE(again->scene.nodes()[k].name, first->scene.nodes()[k].name);
      QVERIFY(*again->scene.nodes()[k].mesh == *first->scene.nodes()[k].mesh);
    }
  }
}

SLINE_TEST(ImportTest)
#include "test_import.moc"
