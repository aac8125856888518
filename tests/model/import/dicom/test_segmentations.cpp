// SPDX-License-Identifier: Apache-2.0
// Tests segmentations: names, colours and groups of segments, surfaces, what is refused.
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/import/dicom/segment_table.h"
#include "tests/model/import/dicom/made_segmentations.h"
#include "tests/model/import/dicom/surface_facts.h"
#include "tests/model/import/dicom/written_dicom.h"
#include "tests/model/import/dicom/written_segmentation.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

class TestSegmentations : public QObject {
  Q_OBJECT
 private slots:
  void namesColoursGroups();
  void labelsInAnyScript();
  void surfaces();
  void refusals_data();
  void refusals();
  void labColours_data();
  void labColours();
};

void TestSegmentations::namesColoursGroups() {
  WrittenSegmentation written = emptySegmentation();
  written.segments = {{1, "Leber", "Anatomical Structure", {34924, 53196, 50050}},
                      {2, "", "Lesion", {}}};
  addBox(written, 1, {0, 5, 0, 5, 0, 2});
  addBox(written, 2, {8, 12, 0, 5, 0, 2});
  const auto read = volumesOf(written);
  QVERIFY(read.ok());
  const auto& labels = read->volumes.at(0).labels;
  QCOMPARE(labels.at(0).name, std::string("Leber"));
  QCOMPARE(labels.at(0).groups, std::vector<std::string>{"Anatomical Structure"});
  QVERIFY(labels.at(0).colour);
  QCOMPARE(labels.at(1).name, std::string("Named by type"));
  QVERIFY(!labels.at(1).colour);
}

/// Names come as UTF-8, and the patient's never comes at all, in whatever letters.
void TestSegmentations::labelsInAnyScript() {
  const QByteArray kanji("\x1b$B;3ED\x1b(B");  // Yamada
  WrittenSegmentation written = emptySegmentation();
  written.segments = {{1, "\x1b$B4NB!\x1b(B", "\x1b$B4o41\x1b(B", {}}};
  addBox(written, 1, {4, 10, 3, 8, 1, 4});
  WrittenSet set = segmentation(written);
  set.insert(set.begin() + 1, text({0x0008, 0x0005}, "CS", "\\ISO 2022 IR 87"));
  for (WrittenElement& element : set)
    if (element.tag == model::Tag{0x0010, 0x0010})
      element.value = "YAMADA^TARO=" + kanji;
  const auto read = readDicomBytes(QTemporaryDir(), dicomFile(set));
  QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
  const model::RawMesh& mesh = read->meshes.at(0);
  QCOMPARE(mesh.name, std::string("肝臓"));
  QCOMPARE(mesh.groups, std::vector<std::string>{"器官"});
  const std::string all = mesh.name + mesh.groups[0] + mesh.origin + mesh.frameReason +
                          mesh.unitReason + mesh.file + warningsOf(*read).toStdString();
  for (const char* whose : {"YAMADA", "TARO", "山田", "\x1b"})
    QVERIFY2(all.find(whose) == std::string::npos, whose);
}

void TestSegmentations::surfaces() {
  // The surface is of a ball of 20 mm in voxels of 0.8 × 1 × 2 mm, patient left of the origin.
  WrittenSegmentation written = emptySegmentation();
  written.columns = 80;
  written.rows = 60;
  written.columnSpacing = 0.8;
  for (int z = 0; z < 25; ++z) {
    WrittenFrame frame{1, {20, -30, 2.0 * z}, {}};
    for (int y = 0; y < written.rows; ++y)
      for (int x = 0; x < written.columns; ++x) {
        const glm::dvec3 p(20 + 0.8 * x - 52, -30 + y + 1, 2.0 * z - 24);
        frame.pixels.push_back(glm::length(p) < 20.0 ? 1 : 0);
      }
    written.frames.push_back(std::move(frame));
  }
  const auto read = surfacesOf(written, {Syntax::deflated});
  QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
  const SurfaceFacts facts = factsOf(read->meshes.at(0));
  const double volume = 4.0 / 3.0 * std::numbers::pi * 8000.0;
  QVERIFY(facts.closed);
  QCOMPARE(facts.euler, 2L);
  qInfo("volume %+.2f %%", 100.0 * (facts.volume / volume - 1.0));
  QVERIFY(std::abs(facts.volume / volume - 1.0) < 0.03);
  QVERIFY(std::abs(0.5 * (facts.low.x + facts.high.x) - 52.0) < 0.5);
  QVERIFY(std::abs(0.5 * (facts.low.y + facts.high.y) + 1.0) < 0.5);
  QVERIFY(std::abs(0.5 * (facts.low.z + facts.high.z) - 24.0) < 0.5);
  QCOMPARE(read->meshes[0].name, std::string("Liver"));
  QCOMPARE(read->meshes[0].origin, std::string("DICOM segmentation"));
}

void TestSegmentations::refusals_data() {
  QTest::addColumn<int>("fault");
  QTest::addColumn<QString>("message");
  QTest::newRow("MPEG") << 0 << "compressed";
  QTest::newRow("nothing drawn") << 1 << "none of its segments has a pixel";
  QTest::newRow("too little data") << 2 << "too few for";
  QTest::newRow("turned frame") << 3 << "does not lie above the first";
  QTest::newRow("frame far away") << 4 << "too far apart";
  QTest::newRow("16 bits") << 5 << "16 bits";
  QTest::newRow("no places") << 6 << "frames but tells where";
  QTest::newRow("no position") << 7 << "does not say where it lies";
}

void TestSegmentations::refusals() {
  QFETCH(int, fault);
  QFETCH(QString, message);
  WrittenSegmentation written = emptySegmentation();
  addBox(written, 1, {2, 8, 2, 8, 0, 3}, fault == 1 ? 0 : 1);
  if (fault == 3)
    written.frames[1].position.x += 3.0;
  if (fault == 4)
    written.frames[2].position.z += 5000.0;
  written.runLength = fault == 0;
  WrittenSet set = segmentation(written);
  const auto element = [&](model::Tag tag) -> WrittenElement& {
    return *std::find_if(set.begin(), set.end(),
                         [&](const WrittenElement& e) { return e.tag == tag; });
  };
  if (fault == 2)
    element({0x7fe0, 0x0010}).value.chop(4);
  if (fault == 5) {
    element({0x0028, 0x0100}) = shorts({0x0028, 0x0100}, {16});
    element({0x7fe0, 0x0010}).value.resize(2 * 20 * 12 * 3);
  }
  if (fault == 6)
    element({0x5200, 0x9230}).items.pop_back();
  if (fault == 7)
    element({0x5200, 0x9230}).items[1].erase(element({0x5200, 0x9230}).items[1].begin() + 1);
  const QTemporaryDir folder;
  const auto read =
      readDicomBytes(folder, dicomFile(set, {fault == 0 ? Syntax::mpeg : Syntax::explicitLittle}));
  QVERIFY(!read.ok());
  QVERIFY2(QString::fromStdString(read.error().text()).contains(message),
           read.error().text().c_str());
  QVERIFY(!read.error().remedy.empty());
}

void TestSegmentations::labColours_data() {
  QTest::addColumn<std::vector<std::uint16_t>>("lab");
  QTest::addColumn<Colour>("colour");
  const auto coded = [](double l, double a, double b) {
    return std::vector<std::uint16_t>{std::uint16_t(std::lround(l / 100 * 65535)),
                                      std::uint16_t(std::lround((a + 128) / 255 * 65535)),
                                      std::uint16_t(std::lround((b + 128) / 255 * 65535))};
  };
  QTest::newRow("white") << coded(100, 0, 0) << Colour{255, 255, 255};
  QTest::newRow("black") << coded(0, 0, 0) << Colour{0, 0, 0};
  QTest::newRow("middle grey") << coded(53.585, 0, 0) << Colour{128, 128, 128};
  // The sRGB primaries under D50.
  QTest::newRow("red") << coded(54.29, 80.81, 69.89) << Colour{255, 0, 0};
  QTest::newRow("green") << coded(87.82, -79.29, 80.99) << Colour{0, 255, 0};
  QTest::newRow("blue") << coded(29.57, 68.30, -112.03) << Colour{0, 0, 255};
}

void TestSegmentations::labColours() {
  QFETCH(std::vector<std::uint16_t>, lab);
  QFETCH(Colour, colour);
  const Colour made = model::colourOfLab({lab[0], lab[1], lab[2]});
  const auto close = [](int a, int b) { return std::abs(a - b) <= 2; };
  QVERIFY2(close(made.red, colour.red) && close(made.green, colour.green) &&
               close(made.blue, colour.blue),
           qPrintable(QString("%1 %2 %3").arg(made.red).arg(made.green).arg(made.blue)));
}

SLINE_TEST_WITH_EVENTS(TestSegmentations)
#include "test_segmentations.moc"
