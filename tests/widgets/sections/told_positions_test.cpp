// SPDX-License-Identifier: Apache-2.0
// Tests that lengths, areas, volumes and places are told in the unit and with the directions that
// the scene's files tell of, with a question mark where these are not sure.
#include <QLocale>
#include <QTest>

#include "tests/support/shapes.h"
#include "tests/support/suite.h"
#include "widgets/sections/section_position.h"
#include "widgets/session/length_texts.h"

namespace sline::widgets {

using model::DrawnUnit;

class ToldPositionsTest : public QObject {
  Q_OBJECT

  static model::Scene sceneOf(const model::Provenance& from) {
    model::Scene scene;
    scene.append({.name = "one", .mesh = test::sphere(10.0f, 1), .provenance = from});
    return scene;
  }
  static model::Provenance body() {
    return {.file = "liver.vtk", .frame = "LPS", .frameReason = "header", .unitReason = "header"};
  }
  static model::Provenance molecule() {
    return {.file = "1crn.pdb",
            .frame = std::string(model::fileFrame),
            .unitReason = std::string(model::angstromReason)};
  }

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale(QLocale::English)); }

  void units() {
    const model::Scene known = sceneOf(body());
    QCOMPARE(lengthText(known, 3.44), QStringLiteral("3.4 mm"));
    QCOMPARE(lengthText(known, 34.4), QStringLiteral("34 mm"));
    QCOMPARE(lengthText(known, 0.034), QStringLiteral("34 µm"));
    QCOMPARE(lengthText(known, -34.44, 1), QStringLiteral("-34.4 mm"));
    QCOMPARE(sizeText(known, {140.0, 60.04, 7.0}), QStringLiteral("140.0 × 60.0 × 7.0 mm"));
    QCOMPARE(unitSuffix(known), QStringLiteral(" mm"));

    const model::Scene atoms = sceneOf(molecule());
    QCOMPARE(lengthText(atoms, 3.44), QStringLiteral("3.4 Å"));
    QCOMPARE(lengthText(atoms, 0.034, 2), QStringLiteral("0.03 Å"));
    QCOMPARE(sizeText(atoms, {14.0, 6.0, 7.0}), QStringLiteral("14.0 × 6.0 × 7.0 Å"));
    QCOMPARE(unitSuffix(atoms), QStringLiteral(" Å"));

    model::Provenance doubted = body();
    doubted.unitEvidence = model::Evidence::conflict;
    QCOMPARE(lengthText(sceneOf(doubted), 3.44), QStringLiteral("3.4 mm?"));
    QCOMPARE(unitSuffix(sceneOf(doubted)), QStringLiteral(" mm?"));
  }

  void surfacesThatWereMoved() {
    const model::Scene known = sceneOf(body());
    const QString space = QChar(QChar::Nbsp);
    QCOMPARE(lengthText(known, {.mm = 12.3f, .offMm = 0.2f}), QStringLiteral("12 mm"));
    QCOMPARE(lengthText(known, {.mm = 12.3f, .offMm = 0.9f}), "≈" + space + "12 mm");
    QCOMPARE(lengthText(known, {.mm = 0.2f, .offMm = 0.9f}), "<" + space + "2 mm");
  }

  void areasAndVolumes() {
    QCOMPARE(areaText(DrawnUnit::millimetre, 8820.0), QStringLiteral("88.20 cm²"));
    QCOMPARE(areaText(DrawnUnit::millimetre, 0.25), QStringLiteral("0.250 mm²"));
    QCOMPARE(areaText(DrawnUnit::millimetre, 1.2e-5), QStringLiteral("12.0 µm²"));
    QCOMPARE(areaText(DrawnUnit::angstrom, 8820.0), QStringLiteral("8,820 Å²"));
    QCOMPARE(areaText(DrawnUnit::doubtedMillimetre, 8820.0), QStringLiteral("88.20 cm²?"));
    QCOMPARE(volumeText(DrawnUnit::millimetre, 1234.0), QStringLiteral("1.23 ml"));
    QCOMPARE(volumeText(DrawnUnit::millimetre, 4.3), QStringLiteral("4.30 mm³"));
    QCOMPARE(volumeText(DrawnUnit::millimetre, 5e-7), QStringLiteral("500 µm³"));
    QCOMPARE(volumeText(DrawnUnit::angstrom, 1234.0), QStringLiteral("1,234 Å³"));
    QCOMPARE(volumeText(DrawnUnit::doubtedMillimetre, 4.3), QStringLiteral("4.30 mm³?"));
  }

  void directions() {
    const model::Plane left{.normal = {1, 0, 0}, .offset = 12.0f};
    const model::Plane right{.normal = {1, 0, 0}, .offset = -12.0f};
    const QString space = QChar(QChar::Nbsp);
    QCOMPARE(positionText(left, sceneOf(body())), "L" + space + "12.0 mm");
    QCOMPARE(positionText(right, sceneOf(body())), "R" + space + "12.0 mm");
    QCOMPARE(positionText(left, sceneOf(molecule())), "X" + space + "12.0 Å");
    QCOMPARE(positionText(right, sceneOf(molecule())), "X" + space + "-12.0 Å");
    model::Provenance assumed = body();
    assumed.frameReason = std::string(model::nothingTellsFrame);
    assumed.evidence = model::evidenceOfReason(assumed.frameReason);
    QCOMPARE(positionText(left, sceneOf(assumed)), "L?" + space + "12.0 mm");
  }
};

}  // namespace sline::widgets

SLINE_TEST(sline::widgets::ToldPositionsTest)
#include "told_positions_test.moc"
