// SPDX-License-Identifier: Apache-2.0
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/model/import/dicom/surface_facts.h"
#include "tests/model/import/dicom/written_dicom.h"
#include "tests/model/import/dicom/written_structures.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

namespace {

using Contours = std::vector<std::vector<glm::dvec3>>;
constexpr double pi = std::numbers::pi;

std::vector<double> heights(double first, double step, int count) {
  std::vector<double> all;
  for (int i = 0; i < count; ++i)
    all.push_back(first + step * i);
  return all;
}

Contours joined(Contours a, const Contours& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

template <class Place>
Contours placed(Contours contours, const Place& place) {
  for (auto& contour : contours)
    for (glm::dvec3& p : contour)
      p = place(p);
  return contours;
}

/// Returns a ring in one plane as one polygon: around, in through a channel, around the hole, out
/// again.
std::vector<glm::dvec3> keyhole(double z, double outer, double inner) {
  std::vector<glm::dvec3> ring = circle({0, 0, z}, outer);
  std::vector<glm::dvec3> hole = circle({0, 0, z}, inner);
  ring.push_back(ring.front());
  ring.push_back(hole.front());
  ring.insert(ring.end(), hole.rbegin(), hole.rend());
  return ring;
}

Result<model::RawMeshes> readContours(const Contours& contours, const Manner& manner = {}) {
  const QTemporaryDir folder;
  return readDicomBytes(folder, dicomFile(structureSet({{"Body", "ORGAN", {}, contours}}), manner));
}

}  // namespace

class TestStructureSets : public QObject {
  Q_OBJECT
 private slots:
  void volumes_data();
  void volumes();
  void topology_data();
  void topology();
  void orderChangesNothing();
  void syntaxChangesNothing_data();
  void syntaxChangesNothing();
  void namesColoursGroups();
  void sidesStay();
  void whatIsSkippedIsTold_data();
  void whatIsSkippedIsTold();
  void nothingToShow_data();
  void nothingToShow();
  void smoothingOffMovesNothing();
};

void TestStructureSets::volumes_data() {
  QTest::addColumn<Contours>("contours");
  QTest::addColumn<double>("volume");
  QTest::addColumn<double>("tolerance");
  const double sphere = 4.0 / 3.0 * pi * 25.0 * 25.0 * 25.0;
  for (const double shift : {0.0, 0.7, 1.5, 2.9})
    QTest::newRow(qPrintable(QString("ball, slices at %1").arg(shift)))
        << ball({10, -20, 30}, 25, 5.0 + shift, 3.0) << sphere << 0.03;
  QTest::newRow("ball, slices of 1 mm") << ball({0, 0, 0}, 25, -24.6, 1.0) << sphere << 0.01;
  QTest::newRow("small ball") << ball({0, 0, 0}, 6, -5.2, 1.0) << 4.0 / 3.0 * pi * 216 << 0.03;
  const auto rodOf = [](const std::vector<double>& at) { return rod({5, 5, 0}, 20, at); };
  // A contour stands for the slab around it.
  QTest::newRow("rod") << rodOf(heights(-30, 3, 21)) << pi * 400 * 63 << 0.03;
  QTest::newRow("rod of two slices") << rodOf({0, 10}) << pi * 400 * 20 << 0.08;
  QTest::newRow("rod, uneven slices")
      << rodOf({0, 2, 5, 9, 11, 12, 15, 18, 21, 24, 27, 30}) << pi * 400 * 33 << 0.03;
  QTest::newRow("rod, a slice missing")
      << rodOf({0, 3, 6, 9, 15, 18, 21, 24, 27, 30}) << pi * 400 * 33 << 0.03;
  const Contours upright = rod({0, 0, 0}, 20, heights(-30, 3, 21));
  QTest::newRow("sagittal planes")
      << placed(upright, [](const glm::dvec3& p) { return glm::dvec3(p.z, p.x, p.y); })
      << pi * 400 * 63 << 0.03;
  QTest::newRow("coronal planes") << placed(upright, [](const glm::dvec3& p) {
    return glm::dvec3(p.x, -p.z, p.y);
  }) << pi * 400 * 63 << 0.03;
  QTest::newRow("oblique planes") << placed(upright, [](const glm::dvec3& p) {
    const double c = std::cos(0.6);
    const double s = std::sin(0.6);
    return glm::dvec3(c * p.x - s * p.z, p.y + 40, s * p.x + c * p.z);
  }) << pi * 400 * 63 << 0.03;
  // One slice gives no spacing: 1 mm is assumed.
  QTest::newRow("one slice") << rodOf({0}) << pi * 400 << 0.1;
}

void TestStructureSets::volumes() {
  QFETCH(Contours, contours);
  QFETCH(double, volume);
  QFETCH(double, tolerance);
  const auto read = readContours(contours);
  QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
  const SurfaceFacts facts = factsOf(read->meshes.at(0));
  QVERIFY(facts.closed);
  QCOMPARE(facts.pieces, std::size_t(1));
  QCOMPARE(facts.euler, 2L);
  qInfo("volume %.0f of %.0f: %+.2f %%, %zu triangles", facts.volume, volume,
        100.0 * (facts.volume / volume - 1.0), read->meshes[0].triangles.size());
  QVERIFY(std::abs(facts.volume / volume - 1.0) < tolerance);
}

void TestStructureSets::topology_data() {
  QTest::addColumn<Contours>("contours");
  QTest::addColumn<int>("pieces");
  QTest::addColumn<int>("euler");
  QTest::addColumn<double>("volume");
  // Walls of a few samples lose a little at their rims.
  const auto at = heights(0, 3, 10);
  const double ring = pi * (400 - 81) * 30;
  QTest::newRow("contour in a contour is a hole")
      << joined(rod({0, 0, 0}, 20, at), rod({0, 0, 0}, 9, at)) << 1 << 0 << ring;
  Contours keyholes;
  for (const double z : at)
    keyholes.push_back(keyhole(z, 20, 9));
  QTest::newRow("keyhole") << keyholes << 1 << 0 << ring;
  QTest::newRow("a rind of 2 mm") << joined(rod({0, 0, 0}, 60, at), rod({0, 0, 0}, 58, at)) << 1
                                  << 0 << pi * (3600 - 58 * 58) * 30;
  QTest::newRow("two bodies in the same slices")
      << joined(rod({-30, 0, 0}, 10, at), rod({30, 0, 0}, 10, at)) << 2 << 4 << 2 * pi * 100 * 30;
  Contours branching = rod({0, 0, 0}, 12, heights(0, 3, 8));
  for (int i = 0; i < 8; ++i)
    for (const double side : {-1.0, 1.0})
      branching.push_back(circle({side * (6.0 + 1.5 * i), 0, 24.0 + 3.0 * i}, 5.5));
  QTest::newRow("a trunk with two branches")
      << branching << 1 << 2 << pi * 144 * 24 + 2 * pi * 5.5 * 5.5 * 24;
  QTest::newRow("an island in one slice")
      << joined(rod({0, 0, 0}, 10, at), {circle({40, 0, 12}, 5)}) << 2 << 4
      << pi * 100 * 30 + pi * 25 * 2.5;
  QTest::newRow("far apart along the normal")
      << joined(rod({0, 0, 0}, 10, heights(0, 3, 6)), rod({0, 0, 0}, 10, heights(60, 3, 6))) << 2
      << 4 << 2 * pi * 100 * 18;
  // A hole that ends within the body is a hollow, with a surface that faces inward.
  QTest::newRow("hollow") << joined(rod({0, 0, 0}, 20, at), rod({0, 0, 0}, 9, heights(9, 3, 4)))
                          << 2 << 4 << pi * 400 * 30 - pi * 81 * 12;
}

void TestStructureSets::topology() {
  QFETCH(Contours, contours);
  QFETCH(int, pieces);
  QFETCH(int, euler);
  QFETCH(double, volume);
  const auto read = readContours(contours);
  QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
  const SurfaceFacts facts = factsOf(read->meshes.at(0));
  QVERIFY(facts.closed);
  QCOMPARE(int(facts.pieces), pieces);
  QCOMPARE(int(facts.euler), euler);
  qInfo("volume %.0f of %.0f: %+.2f %%", facts.volume, volume,
        100.0 * (facts.volume / volume - 1.0));
  QVERIFY(std::abs(facts.volume / volume - 1.0) < 0.07);
}

void TestStructureSets::orderChangesNothing() {
  Contours contours = joined(ball({0, 0, 0}, 20, -19, 2.5), ball({50, 0, 0}, 12, -11, 2.5));
  const auto first = readContours(contours);
  std::shuffle(contours.begin(), contours.end(), std::mt19937(7));
  for (auto& contour : contours)
    std::rotate(contour.begin(), contour.begin() + 11, contour.end());
  std::reverse(contours[3].begin(), contours[3].end());
  const auto second = readContours(contours);
  QVERIFY(first.ok() && second.ok());
  QVERIFY(first->meshes[0].positions == second->meshes[0].positions);
  QVERIFY(first->meshes[0].triangles == second->meshes[0].triangles);
}

void TestStructureSets::syntaxChangesNothing_data() {
  QTest::addColumn<int>("syntax");
  QTest::addColumn<bool>("open");
  QTest::addColumn<bool>("preamble");
  QTest::newRow("implicit") << int(Syntax::implicitLittle) << false << true;
  QTest::newRow("implicit, open lengths") << int(Syntax::implicitLittle) << true << true;
  QTest::newRow("explicit, open lengths") << int(Syntax::explicitLittle) << true << true;
  QTest::newRow("deflated") << int(Syntax::deflated) << false << true;
  QTest::newRow("big endian") << int(Syntax::explicitBig) << false << true;
  QTest::newRow("big endian, open lengths") << int(Syntax::explicitBig) << true << true;
  QTest::newRow("implicit without preamble") << int(Syntax::implicitLittle) << false << false;
  QTest::newRow("explicit without preamble") << int(Syntax::explicitLittle) << true << false;
}

void TestStructureSets::syntaxChangesNothing() {
  QFETCH(int, syntax);
  QFETCH(bool, open);
  QFETCH(bool, preamble);
  const Contours contours = ball({5, 6, 7}, 15, -7, 3);
  const auto plain = readContours(contours);
  const auto other = readContours(contours, {Syntax(syntax), open, preamble});
  QVERIFY2(other.ok(), other.ok() ? "" : other.error().text().c_str());
  QVERIFY(plain->meshes[0].positions == other->meshes[0].positions);
  QVERIFY(plain->meshes[0].triangles == other->meshes[0].triangles);
}

void TestStructureSets::namesColoursGroups() {
  const Contours contours = ball({0, 0, 0}, 10, -9, 2);
  WrittenSet set = structureSet({{"Gr\xf6\xdf"
                                  "e",
                                  "GTV", Colour{255, 10, 0}, contours},
                                 {"Rim", "PTV", {}, contours},
                                 {"Cord", "ORGAN", {}, contours},
                                 {"Skin", "EXTERNAL", {}, contours},
                                 {"", "CONTROL", {}, contours}});
  set.insert(set.begin() + 1, text({0x0008, 0x0005}, "CS", "ISO_IR 100"));
  const QTemporaryDir folder;
  const auto read = readDicomBytes(folder, dicomFile(set));
  QVERIFY(read.ok());
  QCOMPARE(read->meshes.size(), std::size_t(5));
  const model::RawMesh& first = named(*read, "Größe");
  QVERIFY(first.colour == (Colour{255, 10, 0}));
  QCOMPARE(first.groups, std::vector<std::string>{"Targets"});
  QCOMPARE(named(*read, "Rim").groups, std::vector<std::string>{"Targets"});
  QVERIFY(!named(*read, "Rim").colour);
  QCOMPARE(named(*read, "Cord").groups, std::vector<std::string>{"Organs at risk"});
  QCOMPARE(named(*read, "Skin").groups, std::vector<std::string>{"External"});
  QVERIFY(named(*read, "Structure 5").groups.empty());
  QVERIFY(first.smooth && first.frame == model::Frame::lps && !first.unitReason.empty());
}

void TestStructureSets::sidesStay() {
  const QTemporaryDir folder;
  const auto read = readDicomBytes(
      folder, dicomFile(structureSet({{"Left", "ORGAN", {}, ball({60, 20, 100}, 10, 91, 2)}})));
  QVERIFY(read.ok());
  const SurfaceFacts facts = factsOf(read->meshes[0]);
  // DICOM and scenes agree: +x is the patient's left, +y posterior, +z the head.
  QVERIFY(std::abs(facts.low.x - 50) < 0.5 && std::abs(facts.high.x - 70) < 0.5);
  QVERIFY(std::abs(facts.low.y - 10) < 0.5 && std::abs(facts.high.y - 30) < 0.5);
  QVERIFY(std::abs(facts.low.z - 90) < 1.0 && std::abs(facts.high.z - 110) < 1.0);
}

void TestStructureSets::whatIsSkippedIsTold_data() {
  QTest::addColumn<Contours>("more");
  QTest::addColumn<QByteArray>("geometry");
  QTest::addColumn<QString>("message");
  const Contours one = {circle({0, 0, 3}, 5)};
  QTest::newRow("points") << one << QByteArray("POINT") << "points or open lines";
  QTest::newRow("open") << one << QByteArray("OPEN_PLANAR") << "points or open lines";
  QTest::newRow("no contour") << Contours{} << QByteArray("CLOSED_PLANAR") << "has no contour";
  QTest::newRow("two points") << Contours{{{0, 0, 0}, {1, 0, 0}}} << QByteArray("CLOSED_PLANAR")
                              << "no three points";
  QTest::newRow("a line") << Contours{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}
                          << QByteArray("CLOSED_PLANAR") << "enclose nothing";
  QTest::newRow("another plane") << joined(ball({0, 0, 0}, 10, -9, 2),
                                           {{{0, 0, 0}, {0, 9, 0}, {0, 9, 9}}})
                                 << QByteArray("CLOSED_PLANAR")
                                 << "1 contour lies in another plane";
  QTest::newRow("twice") << joined(ball({0, 0, 0}, 10, -9, 2),
                                   {circle({0, 0, -9}, std::sqrt(19.0))})
                         << QByteArray("CLOSED_PLANAR") << "1 contour given twice";
  QTest::newRow("missing slice") << rod({0, 0, 0}, 10, {0, 3, 6, 12, 15, 18})
                                 << QByteArray("CLOSED_PLANAR") << "1 slice without a contour";
  QTest::newRow("one slice") << one << QByteArray("CLOSED_PLANAR")
                             << "one slice; made 2 mm thick, as slices of other structures are";
  QTest::newRow("wide gap") << rod({0, 0, 0}, 10, {0, 3, 6, 60, 63, 66})
                            << QByteArray("CLOSED_PLANAR") << "2 pieces";
}

void TestStructureSets::whatIsSkippedIsTold() {
  QFETCH(Contours, more);
  QFETCH(QByteArray, geometry);
  QFETCH(QString, message);
  const QTemporaryDir folder;
  const auto read = readDicomBytes(
      folder, dicomFile(structureSet({{"Sound", "ORGAN", {}, ball({0, 0, 0}, 10, -9, 2)},
                                      {"Odd one", "ORGAN", {}, more, geometry}})));
  QVERIFY(read.ok());
  QVERIFY2(warningsOf(*read).contains("\"Odd one\": ") && warningsOf(*read).contains(message),
           qPrintable(warningsOf(*read)));
  QVERIFY(!named(*read, "Sound").triangles.empty());
}

void TestStructureSets::nothingToShow_data() {
  QTest::addColumn<QByteArray>("geometry");
  QTest::addColumn<int>("regions");
  QTest::addColumn<QString>("message");
  QTest::newRow("no regions") << QByteArray() << 0 << "names no region";
  QTest::newRow("points only") << QByteArray("POINT") << 2 << "2 regions of interest";
}

void TestStructureSets::nothingToShow() {
  QFETCH(QByteArray, geometry);
  QFETCH(int, regions);
  QFETCH(QString, message);
  const std::vector<WrittenRegion> all(std::size_t(regions),
                                       {"Iso", "ISOCENTER", {}, {circle({0, 0, 0}, 3)}, geometry});
  const QTemporaryDir folder;
  const auto read = readDicomBytes(folder, dicomFile(structureSet(all)));
  QVERIFY(!read.ok());
  QVERIFY2(QString::fromStdString(read.error().text()).contains(message),
           read.error().text().c_str());
}

void TestStructureSets::smoothingOffMovesNothing() {
  const QTemporaryDir folder;
  const QByteArray bytes =
      dicomFile(structureSet({{"Rod", "ORGAN", {}, rod({0, 0, 0}, 10, heights(0, 3, 8))}}));
  model::ReadOptions options;
  const auto smoothed = readDicomBytes(folder, bytes, options);
  options.smoothing.mode = model::Smoothing::Mode::off;
  const auto plain = readDicomBytes(folder, bytes, options);
  QVERIFY(smoothed.ok() && plain.ok());
  QCOMPARE(plain->meshes[0].displacement, 0.0f);
  QVERIFY(smoothed->meshes[0].displacement > 0.0f);
  // The limit is three quarters of the slices' spacing.
  QVERIFY(smoothed->meshes[0].displacement <= 2.26f);
}

SLINE_TEST_WITH_EVENTS(TestStructureSets)
#include "test_structure_sets.moc"
