// SPDX-License-Identifier: Apache-2.0
// Tests where the voxels of segments lie: frames, layers, label maps and packed masks.
#include <QtTest>
#include <algorithm>
#include <cmath>

#include "model/import/dicom/segmentation.h"
#include "tests/model/import/dicom/made_segmentations.h"
#include "tests/model/import/dicom/surface_facts.h"
#include "tests/model/import/dicom/written_dicom.h"
#include "tests/model/import/dicom/written_images.h"
#include "tests/model/import/dicom/written_segmentation.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

namespace {

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

class TestSegmentVoxels : public QObject {
  Q_OBJECT
 private slots:
  void whereVoxelsLie_data();
  void whereVoxelsLie();
  void overlapsComeInLayers();
  void absentFramesAreEmpty();
  void labelMaps_data();
  void labelMaps();
  void labelMapsSayWhatTheyLeaveOut();
  void packedMasks_data();
  void packedMasks();
  void realFile();
};

void TestSegmentVoxels::whereVoxelsLie_data() {
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

void TestSegmentVoxels::whereVoxelsLie() {
  QFETCH(int, syntax);
  QFETCH(bool, fractional);
  QFETCH(bool, shuffled);
  QFETCH(QByteArray, orientation);
  QFETCH(glm::dvec3, centre);
  WrittenSegmentation written = emptySegmentation();
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

void TestSegmentVoxels::overlapsComeInLayers() {
  WrittenSegmentation written = emptySegmentation();
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

void TestSegmentVoxels::absentFramesAreEmpty() {
  WrittenSegmentation written = emptySegmentation();
  addBox(written, 1, {2, 8, 2, 8, 0, 3});
  addBox(written, 1, {2, 8, 2, 8, 6, 9});
  const auto read = surfacesOf(written);
  QVERIFY(read.ok());
  const SurfaceFacts facts = factsOf(read->meshes.at(0));
  QVERIFY(facts.closed);
  QCOMPARE(facts.pieces, std::size_t(2));
}

void TestSegmentVoxels::labelMaps_data() {
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

void TestSegmentVoxels::labelMaps() {
  QFETCH(int, syntax);
  QFETCH(int, bits);
  QFETCH(int, packing);
  QFETCH(int, background);
  WrittenSegmentation written = emptySegmentation();
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

void TestSegmentVoxels::labelMapsSayWhatTheyLeaveOut() {
  WrittenSegmentation written = emptySegmentation();
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

void TestSegmentVoxels::packedMasks_data() {
  QTest::addColumn<int>("packing");
  QTest::newRow("JPEG") << int(Packing::jpegLossless);
  QTest::newRow("JPEG-LS") << int(Packing::jpegLs);
}

void TestSegmentVoxels::packedMasks() {
  QFETCH(int, packing);
  WrittenSegmentation written = emptySegmentation();
  written.fractional = true;
  written.bits = 8;
  addBox(written, 1, {4, 10, 3, 8, 1, 4}, 200);
  const auto read = volumesOf(packed(dicomFile(segmentation(written)), Packing(packing)));
  QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
  QCOMPARE(lumpOf(read->volumes.at(0), 0).count, 6 * 5 * 3);
}

void TestSegmentVoxels::realFile() {
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

SLINE_TEST_WITH_EVENTS(TestSegmentVoxels)
#include "test_segment_voxels.moc"
