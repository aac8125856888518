// SPDX-License-Identifier: Apache-2.0
// Tests that the unit of files is never guessed in silence: names tell how large a structure is,
// and where it is not, the unit stays as it is, is told and marked, with the units that would fit.
#include <QtTest>
#include <array>

#include "model/edit/settled_units.h"
#include "model/import/plan/plan.h"
#include "model/scene/known_frame.h"
#include "tests/model/import/dicom/written_structures.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

using Path = std::filesystem::path;

Path pathOf(const QTemporaryDir& folder) {
  return folder.path().toStdString();
}

/// Writes a structure whose greatest extent is `size` in the coordinates of the file; a glTF says
/// so in its metres.
void write(const QTemporaryDir& folder, const QString& name, float size) {
  const bool metres = name.endsWith(".gltf");
  test::writeMesh(folder.filePath(name),
                  *test::octahedron({}, 0.5f * size * (metres ? 1000.0f : 1.0f)));
}

QString texts(const std::vector<float>& units) {
  QStringList texts;
  for (const float unit : units)
    texts << QString::number(double(unit));
  return texts.join(' ');
}

float extentOf(const Scene& scene, const std::string& name) {
  return test::named(scene, name).mesh->bounds().size().x;
}

}  // namespace

class ImportUnitsTest : public QObject {
  Q_OBJECT
 private slots:
  void namesTellSizes_data();
  void namesTellSizes();
  void mostStructuresDecide();
  void oneFileAmongOthers();
  void smallPartsOfAScanAreNoDoubt();
  void whatIsStatedIsNoDoubt();
  void moleculesBesideOrgansAreTold();
  void whatIsChosenIsSettled();
  void planOffersTheUnits();
  void flatStructuresAreTold();
  void oddWholesAreDoubted_data();
  void oddWholesAreDoubted();
};

/// Where no name tells a size, what is as large as nothing of a body is no fact.
void ImportUnitsTest::oddWholesAreDoubted_data() {
  QTest::addColumn<QStringList>("names");
  QTest::addColumn<float>("size");
  QTest::addColumn<bool>("doubted");
  QTest::newRow("0.1") << QStringList{"bunny.stl"} << 0.1f << true;
  QTest::newRow("1.7") << QStringList{"spot.obj"} << 1.7f << true;
  QTest::newRow("17") << QStringList{"spot.obj"} << 17.0f << false;
  QTest::newRow("17,000") << QStringList{"spot.stl", "other.ply"} << 17000.0f << true;
  QTest::newRow("metres") << QStringList{"spot.gltf"} << 0.0017f << false;
  QTest::newRow("a name says so") << QStringList{"stapes.obj"} << 3.0f << false;
}

void ImportUnitsTest::oddWholesAreDoubted() {
  QFETCH(QStringList, names);
  QFETCH(float, size);
  QFETCH(bool, doubted);
  const QTemporaryDir folder;
  for (const QString& name : names)
    write(folder, name, size);
  const auto imported = importInputs(std::array{pathOf(folder)}, {});
  QVERIFY(imported.ok());
  QCOMPARE(hasDoubtedUnits(imported->scene), doubted);
  QCOMPARE(drawnUnit(imported->scene) == DrawnUnit::doubtedMillimetre, doubted);
  QVERIFY(!hasDoubtedUnits(withUnitsSettled(imported->scene).scene));
}

void ImportUnitsTest::namesTellSizes_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<float>("size");    // in the file's coordinates
  QTest::addColumn<float>("extent");  // mm in the scene
  QTest::addColumn<bool>("doubted");
  QTest::addColumn<QString>("units");  // that would fit, the likeliest first
  const auto row = [](const char* tag, const char* file, float size, float extent, bool doubted,
                      const char* units) {
    QTest::newRow(tag) << QString(file) << size << extent << doubted << QString(units);
  };
  row("a liver", "liver.stl", 188.0f, 188.0f, false, "");
  row("a liver in cm", "liver.stl", 18.8f, 18.8f, true, "10");
  row("a liver in m", "liver.ply", 0.188f, 0.188f, true, "1000");
  row("a liver in inches", "liver.obj", 4.0f, 4.0f, true, "25.4");
  row("a liver of 188 m", "liver.gltf", 188.0f, 188'000.0f, true, "1");
  row("a liver of glTF", "liver.gltf", 0.188f, 188.0f, false, "");
  row("a liver of 0 mm", "liver.stl", 0.000188f, 0.000188f, true, "");
  row("a kidney of 10 mm", "left kidney.vtk", 10.0f, 10.0f, true, "10");
  row("a tumour of 2.8 m", "tumour.gltf", 2.8f, 2800.0f, true, "1 10");
  row("a tumour of 28 mm", "tumour.stl", 28.0f, 28.0f, false, "");
  row("a large tumour", "liver tumour.stl", 190.0f, 190.0f, false, "");
  row("a foot of 11 mm", "foot.stl", 11.0f, 11.0f, true, "10 25.4");
  row("a mouse brain of 1.6 m", "mouse brain.stl", 1600.0f, 1600.0f, true, "0.01");
  row("a brain of 1.6 m", "brain.stl", 1600.0f, 1600.0f, true, "0.1");
  row("a mouse brain", "mouse_brain.off", 16.0f, 16.0f, false, "");
  row("a femur of 4.5 m", "femur_left.stl", 4500.0f, 4500.0f, true, "0.1 0.01");
  row("German", "linke Niere.stl", 0.11f, 0.11f, true, "1000");
  row("Latin", "hepar.stl", 0.2f, 0.2f, true, "1000");
  row("Dutch", "lever.stl", 19.0f, 19.0f, true, "10");
  row("Norwegian", "milt.stl", 11.0f, 11.0f, true, "10 25.4");
  row("a vertebra", "vertebrae_L3.stl", 70.0f, 70.0f, false, "");
  row("a vertebra in m", "vertebrae_L3.stl", 0.07f, 0.07f, true, "1000");
  row("a kidney stone", "kidney stone.stl", 4.0f, 4.0f, false, "");
  row("a model as large as a body", "housing.stl", 300.0f, 300.0f, false, "");
}

void ImportUnitsTest::namesTellSizes() {
  QFETCH(QString, file);
  QFETCH(float, size);
  QFETCH(float, extent);
  QFETCH(bool, doubted);
  QFETCH(QString, units);
  const QTemporaryDir folder;
  write(folder, file, size);
  const auto imported =
      importInputs(std::array{pathOf(folder)}, {.smoothing = {Smoothing::Mode::off}});
  QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
  // Never assumed: the coordinates stay as the file has them.
  const Node& node = imported->scene.nodes().front();
  const float found = node.mesh->bounds().size().x;
  QVERIFY2(std::abs(found - extent) <= 1e-3f * extent, qPrintable(QString::number(double(found))));
  QCOMPARE(isUnitDoubted(node.provenance), doubted);
  QCOMPARE(drawnUnit(imported->scene) == DrawnUnit::doubtedMillimetre, doubted);
  const auto& doubts = imported->report.unitDoubts;
  QCOMPARE(doubts.size(), std::size_t(doubted ? 1 : 0));
  QCOMPARE(test::warningsOf(*imported).contains("such structures are"), doubted);
  if (doubted)
    QCOMPARE(texts(doubts.front().units), units);
}

void ImportUnitsTest::mostStructuresDecide() {
  const QTemporaryDir folder;
  write(folder, "liver.stl", 19.0f);
  write(folder, "spleen.stl", 12.0f);
  write(folder, "left kidney.stl", 11.0f);
  write(folder, "right kidney.stl", 45.0f);  // a large one by chance
  write(folder, "something.stl", 3.0f);
  const auto imported = importInputs(std::array{pathOf(folder)}, {});
  QVERIFY(imported.ok());
  QCOMPARE(imported->report.unitDoubts.size(), std::size_t(1));
  const UnitDoubt& doubt = imported->report.unitDoubts.front();
  QCOMPARE(doubt.named, std::size_t(4));
  QCOMPARE(doubt.fitting, std::size_t(1));
  QCOMPARE(doubt.fittingThen, std::size_t(3));
  QCOMPARE(texts(doubt.units), QString("10"));
  QVERIFY(doubt.file.empty());
  // What has no telling name came with the others.
  QVERIFY(isUnitDoubted(test::named(imported->scene, "structure").provenance));
}

void ImportUnitsTest::oneFileAmongOthers() {
  const QTemporaryDir folder;
  write(folder, "liver.stl", 190.0f);
  write(folder, "spleen.stl", 120.0f);
  write(folder, "left kidney.stl", 110.0f);
  write(folder, "right kidney.stl", 0.11f);
  const auto imported = importInputs(std::array{pathOf(folder)}, {});
  QVERIFY(imported.ok());
  QCOMPARE(imported->report.unitDoubts.size(), std::size_t(1));
  QCOMPARE(imported->report.unitDoubts.front().file, std::string("right kidney.stl"));
  QCOMPARE(texts(imported->report.unitDoubts.front().units), QString("1000"));
  QVERIFY(isUnitDoubted(test::named(imported->scene, "right kidney").provenance));
  QVERIFY(!isUnitDoubted(test::named(imported->scene, "left kidney").provenance));
}

void ImportUnitsTest::smallPartsOfAScanAreNoDoubt() {
  // A scanner's file is in millimetres, and its edge may have cut a kidney off.
  const QTemporaryDir folder;
  const auto ball = [](const glm::dvec3& at, double radius) {
    return test::ball(at, radius, at.z - radius + 1.0, 2.0);
  };
  test::writeText(
      folder.filePath("set.dcm"),
      test::dicomFile(test::structureSet({{"Liver", "ORGAN", {}, ball({0, 0, 0}, 80)},
                                          {"Spleen", "ORGAN", {}, ball({200, 0, 0}, 55)},
                                          {"Kidney Left", "ORGAN", {}, ball({0, 200, 0}, 8)}})));
  const auto imported = importInputs(std::array{pathOf(folder)}, {});
  QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
  QVERIFY(imported->report.unitDoubts.empty());
  QVERIFY(drawnUnit(imported->scene) == DrawnUnit::millimetre);
}

/// Whatever its size: nobody is asked how long a millimetre of DICOM is.
void ImportUnitsTest::whatIsStatedIsNoDoubt() {
  const auto small = [](const glm::dvec3& at) { return test::ball(at, 8.0, at.z - 7.0, 2.0); };
  const QTemporaryDir folder;
  test::writeText(folder.filePath("set.dcm"),
                  test::dicomFile(test::structureSet({{"Liver", "ORGAN", {}, small({0, 0, 0})}})));
  const auto imported = importInputs(std::array{pathOf(folder)}, {});
  QVERIFY(imported.ok());
  QVERIFY(imported->report.unitDoubts.empty());
  QVERIFY(drawnUnit(imported->scene) == DrawnUnit::millimetre);
  const QString told = test::warningsOf(*imported);
  QVERIFY2(told.contains("its unit is stated (DICOM: millimetres)"), qPrintable(told));
}

void ImportUnitsTest::moleculesBesideOrgansAreTold() {
  const Path molecule = Path(SLINE_TEST_DATA) / "protein/1crn.pdb";
  if (!std::filesystem::exists(molecule))
    SLINE_ABSENT("the molecule is absent");
  const QTemporaryDir folder;
  write(folder, "liver.stl", 190.0f);
  for (const bool together : {false, true}) {
    std::vector<Path> inputs{molecule};
    if (together)
      inputs.push_back(pathOf(folder));
    const auto imported = importInputs(inputs, {});
    QVERIFY(imported.ok());
    QCOMPARE(test::warningsOf(*imported).contains("ten million times as large as \"liver\""),
             together);
    QVERIFY(drawnUnit(imported->scene) ==
            (together ? DrawnUnit::doubtedMillimetre : DrawnUnit::angstrom));
  }
}

void ImportUnitsTest::whatIsChosenIsSettled() {
  const QTemporaryDir folder;
  write(folder, "left kidney.stl", 10.0f);
  const auto inputs = std::array{pathOf(folder)};
  for (const auto& [unit, extent] : {std::pair(1.0f, 10.0f), std::pair(10.0f, 100.0f)}) {
    const auto imported = importInputs(inputs, {.unit = unit, .smoothing = {}});
    QVERIFY(imported.ok());
    QCOMPARE(extentOf(imported->scene, "left kidney"), extent);
    QVERIFY(imported->report.unitDoubts.empty());
    QVERIFY(drawnUnit(imported->scene) == DrawnUnit::millimetre);
  }
  const auto doubted = importInputs(inputs, {});
  QVERIFY(doubted.ok() && hasDoubtedUnits(doubted->scene));
  const Edited settled = withUnitsSettled(doubted->scene);
  QVERIFY(settled.changed);
  QVERIFY(!hasDoubtedUnits(settled.scene));
  QCOMPARE(settled.scene.nodes().front().provenance.unitReason, std::string(chosenReason));
  QCOMPARE(extentOf(settled.scene, "left kidney"), 10.0f);
  QVERIFY(!withUnitsSettled(settled.scene).changed);
}

void ImportUnitsTest::planOffersTheUnits() {
  const QTemporaryDir folder;
  write(folder, "left kidney.stl", 10.0f);
  write(folder, "liver.stl", 190.0f);
  write(folder, "spleen.stl", 110.0f);
  auto plan = planImport(std::array{pathOf(folder)}, {});
  QVERIFY(plan.ok());
  QCOMPARE(plan->report.unitDoubts.size(), std::size_t(1));
  const auto ids = structuresOf(*plan, plan->report.unitDoubts.front());
  QCOMPARE(ids.size(), std::size_t(1));
  QCOMPARE(plan->scene.find(ids.front())->name, std::string("left kidney"));
  plan->choices[ids.front()].unit = plan->report.unitDoubts.front().units.front();
  const auto imported = carryOut(*plan);
  QVERIFY(imported.ok());
  QCOMPARE(extentOf(imported->scene, "left kidney"), 100.0f);
  QVERIFY(imported->report.unitDoubts.empty());
  QVERIFY(!hasDoubtedUnits(imported->scene));
}

void ImportUnitsTest::flatStructuresAreTold() {
  const QTemporaryDir folder;
  test::writeText(folder.filePath("liver.obj"),
                  "v 0 0 0\nv 190 0 0\nv 0 120 0\nv 190 120 0\nf 1 2 3\nf 2 4 3\n");
  test::writeText(folder.filePath("plate.obj"),
                  "v 0 0 0\nv 190 0 0\nv 0 120 0\nv 190 120 0\nf 1 2 3\nf 2 4 3\n");
  const auto imported = importInputs(std::array{pathOf(folder)}, {});
  QVERIFY(imported.ok());
  const QString told = test::warningsOf(*imported);
  QVERIFY2(told.contains("\"liver\" is flat"), qPrintable(told));
  QVERIFY2(!told.contains("\"plate\" is flat"), qPrintable(told));
}

SLINE_TEST(ImportUnitsTest)
#include "import_units_test.moc"
