// SPDX-License-Identifier: Apache-2.0
// Tests that a structure on the other side than its name says is told of on every way in, and that
// every way in says the same of sides.
#include <QtTest>
#include <algorithm>
#include <array>
#include <map>

#include "model/edit/sides.h"
#include "model/edit/tree.h"
#include "model/import/naming/laterality.h"
#include "model/import/naming/other_sides.h"
#include "model/import/naming/uprightness.h"
#include "model/import/plan/plan.h"
#include "model/import/plan/read_inputs.h"
#include "model/scene/known_frame.h"
#include "model/scene_file/scene_file.h"
#include "tests/model/import/volumes/written_volumes.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

/// The middles of organs in LPS, millimetres.
const std::map<QString, glm::vec3>& body() {
  static const std::map<QString, glm::vec3> places{{"liver", {-70, -30, 10}},
                                                   {"spleen", {80, 20, 15}},
                                                   {"spine", {0, 60, -5}},
                                                   {"left kidney", {50, 40, -40}},
                                                   {"right kidney", {-50, 40, -45}},
                                                   {"left ureter", {40, 30, -90}},
                                                   {"right ureter", {-40, 30, -90}},
                                                   {"right femur", {-90, 10, -200}},
                                                   {"gall bladder", {-30, -40, -20}},
                                                   {"gall bladder fundus", {-30, -50, -40}},
                                                   {"left renal cortex", {50, 40, -30}},
                                                   {"left renal medulla", {50, 40, -60}},
                                                   {"right renal cortex", {-50, 40, -35}},
                                                   {"descending colon", {85, 10, -60}},
                                                   {"appendix", {-80, 0, -110}},
                                                   {"growth", {30, -10, -20}},
                                                   {"left superiomedial segment", {-25, -30, 20}},
                                                   {"left inferomedial segment", {-25, -32, 5}},
                                                   {"left medial lobe", {-24, -31, 12}},
                                                   {"left apical segment of lung", {-50, 0, 90}}};
  return places;
}

constexpr float radius = 12.0f;

/// Returns the names that stand in quotation marks, sorted.
QStringList namesIn(const QString& told) {
  QStringList names;
  const QStringList parts = told.split('"');
  for (qsizetype i = 1; i < parts.size(); i += 2)
    names << parts[i];
  names.sort();
  return names;
}

}  // namespace

class OtherSidesTest : public QObject {
  Q_OBJECT
 private slots:
  void theOtherSideIsTold_data();
  void theOtherSideIsTold();
  void aScanChangesNothing();
  void anotherAxisUpIsDoubted_data();
  void anotherAxisUpIsDoubted();
};

/// Programs for modelling write y up; names of sides cannot tell.
void OtherSidesTest::anotherAxisUpIsDoubted_data() {
  QTest::addColumn<QStringList>("organs");
  QTest::addColumn<int>("turned");  // quarters about the axis from left to right
  QTest::addColumn<bool>("doubted");
  QTest::addColumn<bool>("refuted");  // all directions are in doubt, and a warning says so
  const QStringList whole{"liver",        "spleen",      "left kidney",
                          "right kidney", "right femur", "left femur"};
  QTest::newRow("upright") << whole << 0 << false << false;
  QTest::newRow("y up") << whole << 1 << true << true;
  QTest::newRow("upside down") << whole << 2 << true << true;
  QTest::newRow("y down") << whole << 3 << true << true;
  QTest::newRow("nothing low") << QStringList{"liver", "spleen", "left kidney", "right kidney"} << 1
                               << true << false;
  QTest::newRow("a gall bladder is none of urine")
      << QStringList{"liver", "spleen", "gall bladder", "gall bladder fundus"} << 0 << true
      << false;
  QTest::newRow("cortex and medulla of the kidney")
      << QStringList{"left renal cortex", "left renal medulla", "right renal cortex"} << 0 << true
      << false;
  QTest::newRow("one low") << QStringList{"liver", "spleen", "left kidney", "right kidney",
                                          "right femur"}
                           << 0 << false << false;
}

void OtherSidesTest::anotherAxisUpIsDoubted() {
  QFETCH(QStringList, organs);
  QFETCH(int, turned);
  QFETCH(bool, doubted);
  QFETCH(bool, refuted);
  const QTemporaryDir folder;
  for (const QString& organ : organs) {
    glm::vec3 at = organ == "left femur" ? glm::vec3(90, 10, -200) : body().at(organ);
    for (int i = 0; i < turned; ++i)
      at = {at.x, at.z, -at.y};
    test::writeMesh(folder.filePath(organ + ".ply"), *test::octahedron(at, radius));
  }
  const auto imported =
      importInputs(std::array{std::filesystem::path(folder.path().toStdString())}, {});
  QVERIFY(imported.ok());
  for (const int axis : {0, 1, 2})
    if (refuted || axis == 2)
      QCOMPARE(knownSides(imported->scene).inDoubt(axis), doubted);
  QCOMPARE(test::warningsOf(*imported).contains(notUpright.data()), refuted);
  const Scene settled = withSidesSettled(imported->scene, SideAnswer::right).scene;
  QVERIFY(!knownSides(settled).inDoubt(2));
}

/// Whatever the others say of the frame.
void OtherSidesTest::theOtherSideIsTold_data() {
  QTest::addColumn<QStringList>("organs");
  QTest::addColumn<QStringList>("swapped");  // left and right
  QTest::addColumn<QString>("told");
  const auto row = [](const char* tag, const QStringList& organs, const QStringList& swapped,
                      const char* told) {
    QTest::newRow(tag) << organs << swapped << QString(told);
  };
  const QStringList kidneys{"left kidney", "right kidney"};
  row("nothing", {"liver", "spleen", "spine", "left kidney", "right kidney"}, {}, "");
  row("a pair", {"liver", "spleen", "appendix", "descending colon", "left kidney", "right kidney"},
      kidneys, "\"left kidney\", \"right kidney\" lie on the other side than their names say");
  row("one of several without a pair", {"liver", "spleen", "right ureter", "left kidney"},
      {"left kidney"}, "\"left kidney\" lies on the other side than its name says");
  row("sides of the liver's parts are none of the body's",
      {"liver", "spleen", "spine", "left kidney", "right kidney", "left superiomedial segment",
       "left inferomedial segment", "left medial lobe"},
      {}, "");
  row("those of the lung's are",
      {"liver", "spleen", "spine", "left kidney", "right kidney", "left apical segment of lung"},
      {}, "\"left apical segment of lung\" lies on the other side than its name says");
  row("one beside the spine", {"left ureter", "right femur", "spine", "left kidney"},
      {"left kidney"}, "\"left kidney\" lies on the other side than its name says");
}

void OtherSidesTest::theOtherSideIsTold() {
  QFETCH(QStringList, organs);
  QFETCH(QStringList, swapped);
  QFETCH(QString, told);
  for (const std::optional<Frame> stated : {std::optional<Frame>(), std::optional(Frame::ras)}) {
    const QTemporaryDir folder;
    for (const QString& organ : organs) {
      glm::vec3 middle = body().at(organ);
      middle.x = swapped.contains(organ) ? -middle.x : middle.x;
      test::writeMesh(folder.filePath("body/" + organ + ".ply"),
                      *test::octahedron(halfTurn(middle), radius), stated);
    }
    const std::filesystem::path root(folder.path().toStdString());
    const auto says = [&told](const ImportReport& report) {
      const auto about = [](const ImportWarning& w) {
        return w.reason.find("other side") != std::string::npos;
      };
      const auto found = std::find_if(report.warnings.begin(), report.warnings.end(), about);
      return found == report.warnings.end() ? told.isEmpty()
                                            : QString::fromStdString(found->reason) == told;
    };
    const auto imported = importInputs(std::array{root / "body"}, {});
    QVERIFY(imported.ok());
    QCOMPARE(imported->report.frame, Frame::ras);
    QVERIFY2(says(imported->report), qPrintable(test::warningsOf(*imported)));
    const auto plan = planImport(std::array{root / "body"}, {});
    QVERIFY(plan.ok() && says(plan->report));
    QVERIFY(writeSceneFile(root / "body.sline", {.scene = imported->scene}).ok());
    const auto opened = importInputs(std::array{root / "body.sline"}, {});
    QVERIFY(opened.ok() && says(opened->report));
    const auto doubted = [](const Scene& scene) {
      QStringList names;
      for (const Node& node : scene.nodes())
        if (isNameDoubted(node))
          names << QString::fromStdString(node.name);
      names.sort();
      return names;
    };
    const QStringList names = namesIn(told);
    QCOMPARE(doubted(imported->scene), names);
    QCOMPARE(doubted(opened->scene), names);
    // What a person has said is asked no more, here or when the scene is opened again. Sides that
    // are in doubt come first.
    const Scene sided = hasDoubtedSides(imported->scene)
                            ? withSidesSettled(imported->scene, SideAnswer::right).scene
                            : imported->scene;
    QCOMPARE(doubted(sided), names);
    const Edited settled = withSidesSettled(sided, SideAnswer::right);
    QCOMPARE(settled.changed, !names.isEmpty());
    QCOMPARE(hasDoubtedNames(settled.scene), false);
    QVERIFY(otherSidesText(settled.scene).empty());
    QVERIFY(writeSceneFile(root / "body.sline", {.scene = settled.scene}).ok());
    const auto again = importInputs(std::array{root / "body.sline"}, {});
    QVERIFY(again.ok() && doubted(again->scene).isEmpty());
    for (const QString& name : names) {
      const NodeId id = imported->scene.named(name.toStdString()).front();
      QVERIFY(!isNameDoubted(*renamed(imported->scene, id, "thing").scene.find(id)));
    }
  }
}

/// A scan that is kept, or read for a plan, says nothing of surfaces beside it.
void OtherSidesTest::aScanChangesNothing() {
  const QTemporaryDir folder;
  test::writeMesh(folder.filePath("growth.ply"),
                  *test::octahedron(halfTurn(body().at("growth")), radius));
  glm::dmat4 place(1.0);
  for (int axis = 0; axis < 3; ++axis)
    place[axis][axis] = 4.0;
  // Read as LPS the growth lies within, read as RAS beside it.
  place[3] = glm::dvec4(-90.0, -60.0, -60.0, 1.0);
  const auto grey = [](const glm::dvec3& p) { return int(500.0 + 7.0 * p.x + 3.0 * p.y + p.z); };
  test::writeText(folder.filePath("ct.nrrd"),
                  test::nrrdFile(test::sampled(glm::ivec3(24), place, grey),
                                 "left-posterior-superior", "raw", test::Number::int16));
  const std::array inputs{std::filesystem::path(folder.path().toStdString())};
  const auto told = [](const Scene& scene) {
    const Provenance& from = test::named(scene, "growth").provenance;
    return QString::fromStdString(from.frame + ": " + from.frameReason) +
           (from.evidence.isSure() ? "" : "?");
  };
  const auto plan = planImport(inputs, {});
  QVERIFY(plan.ok() && !plan->read->scans.empty());
  for (const bool keep : {false, true}) {
    ImportOptions options;
    options.keepScans = keep;
    const auto imported = importInputs(inputs, options);
    QVERIFY(imported.ok());
    QCOMPARE(told(imported->scene), QString("LPS: %1?").arg(nothingTellsFrame.data()));
    QCOMPARE(told(plan->scene), told(imported->scene));
  }
}

SLINE_TEST(OtherSidesTest)
#include "other_sides_test.moc"
