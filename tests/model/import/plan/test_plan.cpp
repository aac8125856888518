// SPDX-License-Identifier: Apache-2.0
// Tests that a plan is carried out as it stands: each structure as chosen, nothing read twice, left
// and right where the frame puts them.
#include <QtTest>
#include <array>
#include <functional>

#include "model/import/plan/plan.h"
#include "tests/model/import/written_meshes.h"
#include "tests/model/scene_file/sample_scene.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

using Path = std::filesystem::path;

NodeId idOf(const ImportPlan& plan, const std::string& name) {
  return test::named(plan.scene, name).id;
}

/// Holds two kidneys in a folder, a sphere of 1,280 triangles each, and a bladder beside it.
class Body {
 public:
  Body() {
    const MeshPtr ball = test::sphere(20.0f, 3);
    write("organs/left kidney.ply", *test::moved(*ball, 1.0f, {60, 0, 0}));
    write("organs/right kidney.ply", *test::moved(*ball, 1.0f, {-60, 0, 0}));
    write("pelvis/bladder.ply", *test::moved(*ball, 1.0f, {0, 10, -80}));
  }
  void write(const QString& name, const Mesh& mesh) const {
    test::writeMesh(m_folder.filePath(name), mesh);
  }
  Path path(const char* below = "") const { return m_folder.filePath(below).toStdString(); }
  ImportPlan plan(const ImportOptions& options = {}) const {
    return std::move(*planImport(std::array{path()}, options));
  }
  void removeFiles() { m_folder.remove(); }

 private:
  QTemporaryDir m_folder;
};

}  // namespace

class PlanTest : public QObject {
  Q_OBJECT
 private slots:
  void eachStructureAsChosen();
  void groupsOfNothingAreLeftOut();
  void changesNeedNoSecondReading();
  void frameOfOneFile();
  void repairReadsAgain();
  void volumeIsReadAgainWhereSmoothedOtherwise();
  void sceneFilesKeepTheirIds();
  void badChoices_data();
  void badChoices();
  void cancelled();
};

void PlanTest::eachStructureAsChosen() {
  const Body body;
  ImportPlan plan = body.plan({.smoothing = {Smoothing::Mode::off}});
  const NodeId left = idOf(plan, "left kidney");
  const NodeId right = idOf(plan, "right kidney");
  const NodeId bladder = idOf(plan, "bladder");
  plan.choices[left] = {.name = "Ren sinister", .smoothing = Smoothing{Smoothing::Mode::steps, 7}};
  plan.choices[right] = {.colour = Colour{1, 2, 3}, .decimateMm = 1.0f};
  const auto imported = carryOut(plan);
  QVERIFY(imported.ok());
  const Node& first = *imported->scene.find(left);
  QCOMPARE(first.name, std::string("Ren sinister"));
  QCOMPARE(first.provenance.smoothingSteps, 7);
  QVERIFY(first.provenance.displacementMm > 0.0f);
  const Node& second = *imported->scene.find(right);
  QVERIFY(second.style.colour == Colour(1, 2, 3));
  QCOMPARE(second.provenance.smoothingSteps, 0);
  QVERIFY(second.mesh->triangleCount() < plan.scene.find(right)->mesh->triangleCount());
  QVERIFY(second.provenance.decimationMm > 0.0f && second.provenance.decimationMm <= 1.0f);
  // A structure without a choice is bit for bit as it was.
  QVERIFY(*imported->scene.find(bladder)->mesh == *plan.scene.find(bladder)->mesh);
  // The reverse holds, too: an option for all does not apply to a structure with its own choice.
  plan.options.decimateMm = 1.0f;
  plan.choices = {{left, {.decimateMm = 0.0f}}};
  const auto others = carryOut(plan);
  QVERIFY(others.ok());
  QVERIFY(*others->scene.find(left)->mesh == *plan.scene.find(left)->mesh);
  QVERIFY(others->scene.find(bladder)->provenance.decimatedFrom > 0);
}

void PlanTest::groupsOfNothingAreLeftOut() {
  const Body body;
  ImportPlan plan = body.plan();
  const NodeId pelvis = plan.scene.find(idOf(plan, "bladder"))->parent;
  QVERIFY(pelvis != rootId);
  plan.choices[idOf(plan, "bladder")].include = false;
  plan.choices[idOf(plan, "left kidney")].include = false;
  const auto imported = carryOut(plan);
  QVERIFY(imported.ok());
  QCOMPARE(imported->scene.structuresBelow(rootId),
           (std::vector<NodeId>{idOf(plan, "right kidney")}));
  QVERIFY(!imported->scene.find(pelvis));
}

void PlanTest::changesNeedNoSecondReading() {
  Body body;
  ImportPlan plan = body.plan({.smoothing = {Smoothing::Mode::off}});
  const NodeId left = idOf(plan, "left kidney");
  plan.choices[left] = {.name = "mine"};
  body.removeFiles();
  const auto turn = [&](std::optional<Frame> frame, std::optional<float> unit) {
    plan.options.frame = frame;
    plan.options.unit = unit;
    auto next = planAgain(plan);
    if (!next.ok())
      qFatal("%s", next.error().text().c_str());
    return std::move(*next);
  };
  const Mesh& before = *plan.scene.find(left)->mesh;
  const ImportPlan turned = turn(Frame::ras, 10.0f);
  const Node& there = *turned.scene.find(left);
  QCOMPARE(there.provenance.frameReason, std::string("chosen by the user"));
  QCOMPARE(there.provenance.mmPerUnit, 10.0f);
  QCOMPARE(turned.report.frame, Frame::ras);
  for (std::size_t i = 0; i < before.vertexCount(); ++i) {
    const glm::vec3 p = before.positions()[i];
    QVERIFY(there.mesh->positions()[i] == glm::vec3(-10.0f * p.x, -10.0f * p.y, 10.0f * p.z));
  }
  QVERIFY(turned.choiceOf(left) == plan.choiceOf(left));
  // Turned back, every bit is as it was: each plan starts from what was read.
  plan.choices = turned.choices;
  const ImportPlan back = turn(std::nullopt, std::nullopt);
  QCOMPARE(back.scene.find(left)->mesh->bounds(), before.bounds());
  QVERIFY(*back.scene.find(left)->mesh == before);
  QVERIFY(back.report.frameReason.starts_with("vote: "));
  QVERIFY(carryOut(turned).ok());
}

void PlanTest::frameOfOneFile() {
  const Body body;
  ImportPlan plan = body.plan({.smoothing = {Smoothing::Mode::off}});
  const NodeId bladder = idOf(plan, "bladder");
  plan.choices[bladder] = {.frame = Frame::ras, .unit = 1000.0f};
  const auto next = planAgain(plan);
  QVERIFY(next.ok());
  QCOMPARE(next->scene.find(bladder)->mesh->bounds().centre(), glm::vec3(0, -10000, -80000));
  QCOMPARE(next->scene.find(bladder)->provenance.frame, std::string("RAS"));
  const NodeId left = idOf(plan, "left kidney");
  QVERIFY(*next->scene.find(left)->mesh == *plan.scene.find(left)->mesh);
  const auto imported = carryOut(*next);
  QVERIFY(imported.ok());
  QVERIFY(*imported->scene.find(bladder)->mesh == *next->scene.find(bladder)->mesh);
}

void PlanTest::repairReadsAgain() {
  const Body body;
  body.write("pelvis/a.ply", *test::octahedron({}, 5));
  test::writeText(QString::fromStdString(body.path("pelvis/twice.off").string()),
                  "OFF\n3 2 0\n0 0 0\n9 0 0\n0 9 0\n3 0 1 2\n3 0 1 2\n");
  ImportPlan plan = body.plan();
  const NodeId twice = idOf(plan, "twice");
  QCOMPARE(plan.scene.find(twice)->mesh->triangleCount(), std::size_t(1));
  plan.choices[twice] = {.name = "once"};
  plan.options.repair = false;
  const auto next = planAgain(plan);
  QVERIFY(next.ok());
  const NodeId now = idOf(*next, "twice");
  QCOMPARE(next->scene.find(now)->mesh->triangleCount(), std::size_t(2));
  QCOMPARE(next->choiceOf(now).name.value_or(""), std::string("once"));
}

void PlanTest::volumeIsReadAgainWhereSmoothedOtherwise() {
  const QString volume =
      QStringLiteral(SLINE_TEST_DATA "/labelmap/totalsegmentator/ct_total_labels_3mm.nii.gz");
  if (!QFileInfo::exists(volume))
    SLINE_ABSENT("no real anatomy here");
  auto plan = planImport(std::array{Path(volume.toStdString())}, {});
  QVERIFY(plan.ok());
  const std::vector<NodeId> all = plan->scene.structuresBelow(rootId);
  QVERIFY(all.size() > 10);
  for (std::size_t i = 3; i < all.size(); ++i)
    plan->choices[all[i]].include = false;
  plan->choices[all[1]].smoothing = Smoothing{Smoothing::Mode::off};
  const auto imported = carryOut(*plan);
  QVERIFY(imported.ok());
  QCOMPARE(imported->scene.structuresBelow(rootId).size(), std::size_t(3));
  QVERIFY(imported->scene.find(all[0])->provenance.displacementMm > 0.0f);
  QCOMPARE(imported->scene.find(all[1])->provenance.displacementMm, 0.0f);
  QVERIFY(*imported->scene.find(all[0])->mesh == *plan->scene.find(all[0])->mesh);
  QVERIFY(!(*imported->scene.find(all[1])->mesh == *plan->scene.find(all[1])->mesh));
}

void PlanTest::sceneFilesKeepTheirIds() {
  const Body body;
  const Path file = body.path("sample.sline");
  QVERIFY(writeSceneFile(file, {.scene = test::sampleScene()}).ok());
  auto plan = planImport(std::array{file, body.path("organs")}, {});
  QVERIFY(plan.ok());
  const Scene sample = test::sampleScene();
  const NodeId own = sample.structuresBelow(rootId).front();
  QVERIFY(plan->scene.find(own));
  plan->choices[own].include = false;
  plan->choices[idOf(*plan, "left kidney")].name = "mine";
  const auto imported = carryOut(*plan);
  QVERIFY(imported.ok());
  QVERIFY(!imported->scene.find(own));
  QCOMPARE(imported->scene.find(idOf(*plan, "left kidney"))->name, std::string("mine"));
  QVERIFY(sceneFileBytes({.scene = imported->scene}).ok());
}

void PlanTest::badChoices_data() {
  QTest::addColumn<int>("row");
  QTest::addColumn<QString>("reason");
  const std::array reasons{"does not have", "no length",    "no length", "out of range",
                           "out of range",  "out of range", "name",      "all structures"};
  for (std::size_t i = 0; i < reasons.size(); ++i)
    QTest::addRow("%zu", i) << int(i) << reasons[i];
}

void PlanTest::badChoices() {
  QFETCH(int, row);
  QFETCH(QString, reason);
  const Body body;
  ImportPlan plan = body.plan();
  const NodeId left = idOf(plan, "left kidney");
  const std::array<std::function<void()>, 8> spoil{
      [&] { plan.choices[NodeId{999}] = {}; },
      [&] { plan.choices[left].unit = 0.0f; },
      [&] { plan.choices[left].unit = std::numeric_limits<float>::quiet_NaN(); },
      [&] {
        plan.choices[left].smoothing = Smoothing{Smoothing::Mode::steps, -1};
      },
      [&] { plan.choices[left].decimateMm = -0.1f; },
      [&] { plan.choices[left].decimateMm = 1000.0f; },
      [&] { plan.choices[left].name = " "; },
      [&] {
        for (const NodeId id : plan.scene.structuresBelow(rootId))
          plan.choices[id].include = false;
      }};
  spoil[std::size_t(row)]();
  const Status checked = checkChoices(plan);
  QVERIFY(!checked.ok());
  QVERIFY2(checked.error().text().find(reason.toStdString()) != std::string::npos,
           checked.error().text().c_str());
  QVERIFY(!carryOut(plan).ok());
}

void PlanTest::cancelled() {
  const Body body;
  const auto stop = [](float, const std::string&) { return false; };
  QVERIFY(!planImport(std::array{body.path()}, {}, stop).ok());
  QVERIFY(!carryOut(body.plan(), stop).ok());
}

SLINE_TEST(PlanTest)
#include "test_plan.moc"
