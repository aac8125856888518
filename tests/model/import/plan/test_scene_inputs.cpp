// SPDX-License-Identifier: Apache-2.0
#include <QtTest>
#include <array>
#include <cmath>

#include "model/import/plan/import.h"
#include "model/import/plan/plan.h"
#include "model/scene_file/scene_file.h"
#include "tests/model/import/written_meshes.h"
#include "tests/model/scene_file/sample_scene.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {
using Path = std::filesystem::path;
Path path(const QTemporaryDir& folder, const QString& below = {}) {
  return Path(folder.filePath(below).toStdString());
}

Path writtenSample(const QTemporaryDir& folder, const QString& name = "sample.sline") {
  const Path file = path(folder, name);
  const SceneDocument document{.scene = test::sampleScene(), .others = {{"notes.txt", "mine"}}};
  return writeSceneFile(file, document).ok() ? file : Path();
}
}  // namespace

class SceneInputsTest : public QObject {
  Q_OBJECT
 private slots:
  void sceneFileComesBackAsItIs();
  void otherInputsAreAddedBelow();
  void twoSceneFilesAreOne();
  void optionsDoNotApply();
  void brokenSceneFileIsAnError();
  void unitOverrides_data();
  void unitOverrides();
  void planTellsWhatWouldBe();
};

void SceneInputsTest::sceneFileComesBackAsItIs() {
  const QTemporaryDir folder;
  const auto imported = importInputs(std::array{writtenSample(folder)}, {});
  QVERIFY(imported.ok());
  QCOMPARE(test::difference(imported->scene, test::sampleScene()), std::string());
  QVERIFY(imported->report.warnings.empty());
  QCOMPARE(imported->others.size(), std::size_t(1));
}

void SceneInputsTest::otherInputsAreAddedBelow() {
  const QTemporaryDir folder;
  test::writeMesh(folder.filePath("liver.ply"), *test::octahedron({}, 40), Frame::lps);
  const auto imported =
      importInputs(std::array{path(folder, "liver.ply"), writtenSample(folder)}, {});
  QVERIFY(imported.ok());
  const Scene before = test::sampleScene();
  const auto& nodes = imported->scene.nodes();
  QVERIFY(nodes.size() > before.nodes().size());
  for (std::size_t i = 0; i < before.nodes().size(); ++i)
    QVERIFY(nodes[i].id == before.nodes()[i].id && nodes[i].name == before.nodes()[i].name);
  QVERIFY(!before.find(test::named(imported->scene, "liver").id));
  QVERIFY(imported->scene.views() == before.views());
  // An input beside a scene that cannot be read is left out, as ever.
  const auto partly =
      importInputs(std::array{writtenSample(folder), path(folder, "nowhere.ply")}, {});
  QVERIFY(partly.ok());
  QVERIFY(test::warningsOf(*partly).contains("nowhere.ply"));
  // Repairs are reported.
  test::writeText(folder.filePath("twice.off"),
                  "OFF\n4 5 0\n0 0 0\n9 0 0\n0 9 0\n0 0 9\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n"
                  "3 0 1 2\n");
  const auto repaired =
      importInputs(std::array{writtenSample(folder), path(folder, "twice.off")}, {});
  QVERIFY(repaired.ok());
  QCOMPARE(repaired->report.repairs.summary,
           std::string("repaired 1 of 1 surface: 1 face given twice left out"));
  QCOMPARE(repaired->report.repairs.surfaces.size(), std::size_t(1));
}

void SceneInputsTest::twoSceneFilesAreOne() {
  const QTemporaryDir folder;
  const auto imported = importInputs(
      std::array{writtenSample(folder, "a.sline"), writtenSample(folder, "b.sline")}, {});
  QVERIFY(imported.ok());
  const Scene one = test::sampleScene();
  const Scene& both = imported->scene;
  const std::size_t count = one.nodes().size();
  QCOMPARE(both.nodes().size(), 2 * count);
  QCOMPARE(both.views().size(), 2 * one.views().size());
  QCOMPARE(both.sections().size(), std::size_t(2));
  // The second file's sections cut its own structures, and its groups hold them.
  QVERIFY(both.sections()[0].scope == both.nodes()[0].id);
  QVERIFY(both.sections()[1].scope == both.nodes()[count].id);
  QVERIFY(both.views().back().annotations->front() != one.views().back().annotations->front());
  QVERIFY(both.views()[one.views().size() + 1].sections->front().scope == both.nodes()[count].id);
  const View& bare = both.views()[one.views().size() + 3];
  QVERIFY(bare.looks->at(0).node == both.nodes()[count + 2].id);
  QVERIFY(bare.annotations->at(0) == both.annotations()[2].id);
  QVERIFY(std::get<SurfacePoint>(both.annotations()[2].anchors[0]).structure ==
          both.nodes()[count + 2].id);
  QCOMPARE(both.annotations().size(), std::size_t(4));
  const std::vector<NodeId> targets{both.nodes()[count + 4].id, both.nodes()[count].id};
  QVERIFY(both.nodes()[count + 2].style.gammaMap->targets == targets);
  QVERIFY(both.keyLight() == one.keyLight());
  QVERIFY(both.nodes()[count + 1].parent == both.nodes()[count].id);
  QVERIFY(sceneFileBytes({.scene = both}).ok());
}

void SceneInputsTest::optionsDoNotApply() {
  const QTemporaryDir folder;
  const std::array inputs{writtenSample(folder)};
  const auto turned = importInputs(inputs, {.frame = Frame::ras, .unit = 10.0f, .smoothing = {}});
  QVERIFY(turned.ok());
  QCOMPARE(test::difference(turned->scene, test::sampleScene()), std::string());
  QVERIFY(test::warningsOf(*turned).contains("do not apply"));
  ImportOptions fewer;
  fewer.decimateMm = 0.5f;
  QVERIFY(test::warningsOf(*importInputs(inputs, fewer)).contains("keep their triangles"));
}

void SceneInputsTest::brokenSceneFileIsAnError() {
  const QTemporaryDir folder;
  test::writeText(folder.filePath("broken.sline"), "no scene");
  test::writeMesh(folder.filePath("liver.ply"), *test::octahedron({}, 40), Frame::lps);
  for (const auto& inputs : {std::vector{path(folder, "broken.sline")},
                             std::vector{path(folder, "liver.ply"), path(folder, "broken.sline")},
                             std::vector{path(folder, "absent.sline")}}) {
    const auto imported = importInputs(inputs, {});
    QVERIFY(!imported.ok());
    QCOMPARE(imported.error().file, inputs.back().string());
  }
}

void SceneInputsTest::unitOverrides_data() {
  QTest::addColumn<float>("unit");
  QTest::addColumn<float>("radius");
  QTest::addColumn<QString>("reason");
  QTest::newRow("none") << 0.0f << 40.0f << "millimetres assumed";
  QTest::newRow("centimetres") << 10.0f << 400.0f << "chosen by the user";
  QTest::newRow("metres") << 1000.0f << 40000.0f << "chosen by the user";
}

void SceneInputsTest::unitOverrides() {
  QFETCH(float, unit);
  QFETCH(float, radius);
  QFETCH(QString, reason);
  const QTemporaryDir folder;
  test::writeMesh(folder.filePath("liver.ply"), *test::octahedron({}, 40), Frame::lps);
  ImportOptions options{.smoothing = {Smoothing::Mode::off}};
  if (unit > 0.0f)
    options.unit = unit;
  const auto imported = importInputs(std::array{path(folder, "liver.ply")}, options);
  QVERIFY(imported.ok());
  const Node& liver = test::named(imported->scene, "liver");
  QCOMPARE(liver.mesh->bounds().high.x, radius);
  QCOMPARE(liver.provenance.mmPerUnit, unit > 0.0f ? unit : 1.0f);
  QVERIFY(QString::fromStdString(liver.provenance.unitReason).contains(reason));
}

void SceneInputsTest::planTellsWhatWouldBe() {
  const QTemporaryDir folder;
  test::writeMesh(folder.filePath("organs/left kidney.ply"), *test::octahedron({30, 0, 0}, 20));
  test::writeMesh(folder.filePath("organs/right kidney.ply"), *test::octahedron({-30, 0, 0}, 20));
  test::writeText(folder.filePath("organs/spleen.obj"), "v 0 0\nf 1 2 3\n");
  const auto plan =
      planImport(std::array{path(folder, "organs")}, {.smoothing = {Smoothing::Mode::steps, 5}});
  QVERIFY(plan.ok());
  const Node& kidney = test::named(plan->scene, "left kidney");
  QCOMPARE(kidney.provenance.smoothingSteps, 0);  // it is known when the plan is carried out
  QVERIFY(kidney.provenance.frameReason.starts_with("vote: "));
  QVERIFY(plan->report.warnings.size() == 1 &&
          plan->report.warnings[0].file.find("spleen.obj") != std::string::npos);
  ImportPlan changed = *plan;
  changed.options.frame = Frame::ras;
  const auto imported = carryOut(changed);
  QVERIFY(imported.ok());
  const Node& turned = test::named(imported->scene, "left kidney");
  QCOMPARE(turned.provenance.smoothingSteps, 5);
  QVERIFY(turned.mesh->bounds().centre().x < -20.0f);
}

SLINE_TEST(SceneInputsTest)
#include "test_scene_inputs.moc"
