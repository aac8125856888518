// SPDX-License-Identifier: Apache-2.0
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/import/dicom/segment_table.h"
#include "model/import/dicom/segmentation.h"
#include "tests/model/import/dicom/surface_facts.h"
#include "tests/model/import/dicom/written_dicom.h"
#include "tests/model/import/dicom/written_images.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

namespace {

/// Describes a box of pixels [low, high) in slices [first, last).
struct Box {
  int lowX, highX, lowY, highY, first, last;
};
void addBox(WrittenSegmentation& written, std::uint16_t segment, const Box& box,
            std::uint8_t value = 1) {
  for (int z = box.first; z < box.last; ++z) {
    WrittenFrame frame{segment, {-10.0, -20.0, 100.0 + written.sliceSpacing * z}, {}};
    for (int y = 0; y < written.rows; ++y)
      for (int x = 0; x < written.columns; ++x)
        frame.pixels.push_back(
            x >= box.lowX && x < box.highX && y >= box.lowY && y < box.highY ? value : 0);
    written.frames.push_back(std::move(frame));
  }
}

/// Returns a segmentation of 20 × 12 pixels of 0.5 × 1 mm and slices of 2 mm, without frames.
WrittenSegmentation empty() {
  WrittenSegmentation written;
  written.columns = 20;
  written.rows = 12;
  written.columnSpacing = 0.5;
  written.segments = {{1, "Liver", "Anatomical Structure", {}}, {2, "Tumour", "Lesion", {}}};
  return written;
}

Result<model::LabelVolumes> volumesOf(const QByteArray& bytes) {
  const QTemporaryDir folder;
  const auto dicom = model::DicomFile::read(put(folder, "seg.dcm", bytes), {});
  if (!dicom)
    return dicom.error();
  return model::segmentationVolumes(*dicom, {});
}

Result<model::LabelVolumes> volumesOf(const WrittenSegmentation& written,
                                      const Manner& manner = {}) {
  return volumesOf(dicomFile(segmentation(written), manner));
}

Result<model::RawMeshes> surfacesOf(const WrittenSegmentation& written, const Manner& manner = {}) {
  const QTemporaryDir folder;
  return readDicomBytes(folder, dicomFile(segmentation(written), manner));
}

/// Holds the mean place of a label's voxels in LPS and their number.
struct Lump {
  glm::dvec3 centre{0.0};
  int count = 0;
};
Lump lumpOf(const model::LabelVolume& volume, std::size_t label) {
  Lump lump;
  for (int z = 0; z < volume.size.z; ++z)
    for (int y = 0; y < volume.size.y; ++y)
      for (int x = 0; x < volume.size.x; ++x)
        if (volume.voxels[volume.at(x, y, z)] == label + 1) {
          lump.centre += glm::dvec3(volume.toLps * glm::dvec4(x, y, z, 1));
          ++lump.count;
        }
  lump.centre /= std::max(lump.count, 1);
  return lump;
}

bool near(const glm::dvec3& a, const glm::dvec3& b) {
  return glm::length(a - b) < 1e-6;
}

}  // namespace

class TestSegmentations : public QObject {
  Q_OBJECT
 private slots:
  void whereVoxelsLie_data();
  void whereVoxelsLie();
  void namesColoursGroups();
  void overlapsComeInLayers();
  void absentFramesAreEmpty();
  void labelMaps_data();
  void labelMaps();
  void labelMapsSayWhatTheyLeaveOut();
  void packedMasks_data();
  void packedMasks();
  void labelsInAnyScript();
  void surfaces();
  void refusals_data();
  void refusals();
  void labColours_data();
  void labColours();
  void realFile();
};

void TestSegmentations::whereVoxelsLie_data() {
  QTest::addColumn<int>("syntax");
  QTest::addColumn<bool>("fractional");
  QTest::addColumn<bool>("shuffled");
  QTest::addColumn<QByteArray>("orientation");
  QTest::addColumn<glm::dvec3>("centre");
  // Columns 4 … 9 of 0.5 mm, rows 3 … 7 of 1 mm, slices 1 … 3 of 2 mm from (−10, −20, 100).
  const glm::dvec3 upright(-10 + 6.5 * 0.5, -20 + 5.0, 104);
  const QByteArray plain = "1\\0\\0\\0\\1\\0";
  const int implicitLittle = int(Syntax::implicitLittle);
  const int explicitLittle = int(Syntax::explicitLittle);
  QTest::newRow("bits, implicit") << implicitLittle << false << false << plain << upright;
  QTest::newRow("bits, explicit") << explicitLittle << false << false << plain << upright;
  QTest::newRow("bits, deflated") << int(Syntax::deflated) << false << false << plain << upright;
  QTest::newRow("bits, runs") << int(Syntax::runLength) << false << false << plain << upright;
  QTest::newRow("bits, big endian")
      << int(Syntax::explicitBig) << false << false << plain << upright;
  QTest::newRow("fractions, big endian")
      << int(Syntax::explicitBig) << true << false << plain << upright;
  QTest::newRow("fractions") << explicitLittle << true << false << plain << upright;
  QTest::newRow("fractions, runs") << int(Syntax::runLength) << true << false << plain << upright;
  QTest::newRow("any order") << explicitLittle << false << true << plain << upright;
  // Columns run to the right, as for a patient who lies face down.
  QTest::newRow("prone") << explicitLittle << false << false << QByteArray("-1\\0\\0\\0\\-1\\0")
                         << glm::dvec3(-10 - 6.5 * 0.5, -20 - 5.0, 104);
}

void TestSegmentations::whereVoxelsLie() {
  QFETCH(int, syntax);
  QFETCH(bool, fractional);
  QFETCH(bool, shuffled);
  QFETCH(QByteArray, orientation);
  QFETCH(glm::dvec3, centre);
  WrittenSegmentation written = empty();
  written.fractional = fractional;
  written.bits = fractional ? 8 : 1;
  written.runLength = Syntax(syntax) == Syntax::runLength;
  written.orientation = orientation;
  written.sharedOrientation = !shuffled;
  addBox(written, 1, {4, 10, 3, 8, 1, 4}, fractional ? 128 : 1);
  if (fractional)
    addBox(written, 1, {0, 20, 0, 12, 1, 4}, 127);
  if (shuffled)
    std::reverse(written.frames.begin(), written.frames.end());
  const auto read = volumesOf(written, {Syntax(syntax)});
  QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
  QCOMPARE(read->volumes.size(), std::size_t(1));
  const Lump lump = lumpOf(read->volumes[0], 0);
  QCOMPARE(lump.count, 6 * 5 * 3);
  QVERIFY(near(lump.centre, centre));
  QVERIFY(read->volumes[0].frame == model::Frame::lps);
}

void TestSegmentations::namesColoursGroups() {
  WrittenSegmentation written = empty();
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

void TestSegmentations::overlapsComeInLayers() {
  WrittenSegmentation written = empty();
  written.segments.push_back({3, "Spleen", "Anatomical Structure", {}});
  addBox(written, 1, {0, 10, 0, 10, 0, 4});
  addBox(written, 2, {4, 8, 4, 8, 1, 3});
  addBox(written, 3, {12, 16, 0, 5, 0, 4});
  const auto read = volumesOf(written);
  QVERIFY(read.ok());
  QCOMPARE(read->volumes.size(), std::size_t(2));
  QCOMPARE(read->volumes[0].labels.size(), std::size_t(2));
  QCOMPARE(lumpOf(read->volumes[0], 0).count, 400);
  QCOMPARE(lumpOf(read->volumes[0], 1).count, 80);
  QCOMPARE(lumpOf(read->volumes[1], 0).count, 32);
  QCOMPARE(read->volumes[1].labels[0].name, std::string("Tumour"));
}

void TestSegmentations::absentFramesAreEmpty() {
  WrittenSegmentation written = empty();
  addBox(written, 1, {2, 8, 2, 8, 0, 3});
  addBox(written, 1, {2, 8, 2, 8, 6, 9});
  const auto read = surfacesOf(written);
  QVERIFY(read.ok());
  const SurfaceFacts facts = factsOf(read->meshes.at(0));
  QVERIFY(facts.closed);
  QCOMPARE(facts.pieces, std::size_t(2));
}

void TestSegmentations::labelMaps_data() {
  QTest::addColumn<int>("syntax");
  QTest::addColumn<int>("bits");
  QTest::addColumn<int>("packing");
  QTest::addColumn<int>("background");
  const int explicitLittle = int(Syntax::explicitLittle);
  QTest::newRow("8 bits") << explicitLittle << 8 << int(Packing::none) << 0;
  QTest::newRow("16 bits") << explicitLittle << 16 << int(Packing::none) << 0;
  QTest::newRow("implicit") << int(Syntax::implicitLittle) << 16 << int(Packing::none) << 0;
  QTest::newRow("big endian") << int(Syntax::explicitBig) << 16 << int(Packing::none) << 0;
  QTest::newRow("deflated") << int(Syntax::deflated) << 8 << int(Packing::none) << 0;
  QTest::newRow("runs") << int(Syntax::runLength) << 8 << int(Packing::none) << 0;
  QTest::newRow("JPEG") << explicitLittle << 8 << int(Packing::jpegLossless) << 0;
  QTest::newRow("JPEG-LS") << explicitLittle << 16 << int(Packing::jpegLs) << 0;
  QTest::newRow("JPEG 2000") << int(Syntax::jpeg2000) << 8 << int(Packing::none) << 0;
  QTest::newRow("another background") << explicitLittle << 8 << int(Packing::none) << 9;
}

void TestSegmentations::labelMaps() {
  QFETCH(int, syntax);
  QFETCH(int, bits);
  QFETCH(int, packing);
  QFETCH(int, background);
  WrittenSegmentation written = empty();
  written.labelMap = true;
  written.bits = bits;
  written.runLength = Syntax(syntax) == Syntax::runLength;
  if (background != 0)
    written.padding = std::uint16_t(background);
  if (Syntax(syntax) == Syntax::jpeg2000)
    written.pack = [](const WrittenFrame& frame) {
      return jpeg2000({frame.pixels.begin(), frame.pixels.end()}, 20, 12, 8, false);
    };
  addBox(written, 0, {4, 10, 3, 8, 1, 4});
  for (WrittenFrame& frame : written.frames)
    for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
      // The second segment touches the first.
      const bool second = i % 20 == 10 && i / 20 == 4;
      frame.pixels[i] = second ? 2 : frame.pixels[i] == 0 ? std::uint8_t(background) : 1;
    }
  const auto read =
      volumesOf(packed(dicomFile(segmentation(written), {Syntax(syntax)}), Packing(packing)));
  QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
  QCOMPARE(read->volumes.size(), std::size_t(1));
  const model::LabelVolume& volume = read->volumes[0];
  QCOMPARE(volume.labels.size(), std::size_t(2));
  QCOMPARE(volume.labels[0].name, std::string("Liver"));
  QCOMPARE(volume.labels[1].name, std::string("Tumour"));
  QCOMPARE(lumpOf(volume, 0).count, 6 * 5 * 3);
  QVERIFY(near(lumpOf(volume, 0).centre, glm::dvec3(-10 + 6.5 * 0.5, -20 + 5.0, 104)));
  QCOMPARE(lumpOf(volume, 1).count, 3);
  QVERIFY(near(lumpOf(volume, 1).centre, glm::dvec3(-5, -16, 104)));
  QVERIFY(read->warnings.empty());
}

void TestSegmentations::labelMapsSayWhatTheyLeaveOut() {
  WrittenSegmentation written = empty();
  written.labelMap = true;
  written.bits = 8;
  addBox(written, 0, {4, 10, 3, 8, 1, 4});
  written.frames[1].pixels[50] = 77;
  const auto read = surfacesOf(written);
  QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
  QCOMPARE(read->meshes.size(), std::size_t(1));
  QVERIFY(warningsOf(*read).contains("1 of its pixels' values are not described"));
  QVERIFY(warningsOf(*read).contains("\"Tumour\" has no pixel"));
}

void TestSegmentations::packedMasks_data() {
  QTest::addColumn<int>("packing");
  QTest::newRow("JPEG") << int(Packing::jpegLossless);
  QTest::newRow("JPEG-LS") << int(Packing::jpegLs);
}

void TestSegmentations::packedMasks() {
  QFETCH(int, packing);
  WrittenSegmentation written = empty();
  written.fractional = true;
  written.bits = 8;
  addBox(written, 1, {4, 10, 3, 8, 1, 4}, 200);
  const auto read = volumesOf(packed(dicomFile(segmentation(written)), Packing(packing)));
  QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
  QCOMPARE(lumpOf(read->volumes.at(0), 0).count, 6 * 5 * 3);
}

/// Names come as UTF-8, and the patient's never comes at all, in whatever letters.
void TestSegmentations::labelsInAnyScript() {
  const QByteArray kanji("\x1b$B;3ED\x1b(B");  // Yamada
  WrittenSegmentation written = empty();
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
  WrittenSegmentation written = empty();
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
  WrittenSegmentation written = empty();
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

void TestSegmentations::realFile() {
  const QString path = QString(SLINE_TEST_DATA) + "/formats/dicom/seg_image_ct_binary.dcm";
  if (!QFile::exists(path))
    SLINE_ABSENT("no file to read");
  const auto dicom = model::DicomFile::read(path.toStdString(), {});
  QVERIFY(dicom.ok());
  const auto read = model::segmentationVolumes(*dicom, {});
  QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
  QCOMPARE(read->volumes.size(), std::size_t(1));
  const model::LabelVolume& volume = read->volumes[0];
  QVERIFY(volume.size == glm::ivec3(16, 16, 3));
  QCOMPARE(volume.labels.at(0).name, std::string("first segment"));
  QCOMPARE(volume.labels.at(0).groups, std::vector<std::string>{"Tissue"});
  const glm::dvec4 origin = volume.toLps * glm::dvec4(0, 0, 0, 1);
  QVERIFY(near(glm::dvec3(origin), {-125.0, -128.100006, 103.019997}));
  QVERIFY(std::abs(volume.toLps[2].z - 1.25) < 1e-6);
}

SLINE_TEST_WITH_EVENTS(TestSegmentations)
#include "test_segmentations.moc"
