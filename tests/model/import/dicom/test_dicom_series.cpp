// SPDX-License-Identifier: Apache-2.0
// Tests slices of CT, MR and PET as volumes of grey values: their values, units and places.
#include <QtTest>
#include <cmath>

#include "model/import/dicom/dicom.h"
#include "tests/model/import/dicom/written_images.h"
#include "tests/model/import/dicom/written_stacks.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

namespace {

using Path = std::filesystem::path;

double valueAt(const model::GreyVolume& volume, int x, int y, int z) {
  const auto at = std::size_t((z * volume.size.y + y) * volume.size.x + x);
  return volume.slope * volume.voxels.at(at) + volume.intercept;
}

}  // namespace

class TestDicomSeries : public QObject {
  Q_OBJECT
 private slots:
  void everyCodingGivesTheSameValues_data();
  void everyCodingGivesTheSameValues();
  void valuesAndUnits_data();
  void valuesAndUnits();
  void eachSliceItsScale();
  void whereVoxelsLie_data();
  void whereVoxelsLie();
  void enhancedImages_data();
  void enhancedImages();
};

void TestDicomSeries::everyCodingGivesTheSameValues_data() {
  QTest::addColumn<Writer>("writer");
  QTest::addColumn<int>("bits");
  QTest::addColumn<double>("tolerance");
  const auto native = [](Syntax syntax) {
    return Writer(
        [syntax](const WrittenImage& written) { return dicomFile(image(written), {syntax}); });
  };
  const auto by = [](Packing packing) {
    return Writer([packing](const WrittenImage& written) {
      return packed(dicomFile(image(written)), packing);
    });
  };
  const auto byJpeg2000 = [](Syntax syntax) {
    return Writer([syntax](const WrittenImage& written) { return jpeg2000File(written, syntax); });
  };
  QTest::newRow("explicit") << Writer(plain) << 16 << 0.0;
  QTest::newRow("implicit") << native(Syntax::implicitLittle) << 16 << 0.0;
  QTest::newRow("big endian") << native(Syntax::explicitBig) << 16 << 0.0;
  QTest::newRow("deflated") << native(Syntax::deflated) << 16 << 0.0;
  QTest::newRow("runs") << Writer(runLengthFile) << 16 << 0.0;
  QTest::newRow("JPEG, lossless") << by(Packing::jpegLossless) << 16 << 0.0;
  QTest::newRow("JPEG, 12 bits") << by(Packing::jpegExtended) << 12 << 60.0;
  QTest::newRow("JPEG, 8 bits") << by(Packing::jpegBaseline) << 8 << 12.0;
  QTest::newRow("JPEG-LS") << by(Packing::jpegLs) << 16 << 0.0;
  QTest::newRow("JPEG-LS, nearly lossless") << by(Packing::jpegLsNear) << 12 << 2.0;
  QTest::newRow("JPEG 2000") << byJpeg2000(Syntax::jpeg2000) << 16 << 0.0;
  QTest::newRow("of a kind that DCMTK does not know") << byJpeg2000(Syntax::htj2k) << 16 << 0.0;
  QTest::newRow("JPEG 2000, 12 bits") << byJpeg2000(Syntax::jpeg2000) << 12 << 0.0;
}

void TestDicomSeries::everyCodingGivesTheSameValues() {
  QFETCH(Writer, writer);
  QFETCH(int, bits);
  QFETCH(double, tolerance);
  WrittenImage like;
  like.stored = std::uint16_t(bits);
  like.isSigned = bits == 16;
  const bool lossy = bits == 8 || tolerance > 10;
  std::vector<WrittenImage> slices = stack(like);
  for (std::size_t z = 0; z < slices.size(); ++z)
    if (lossy)  // something smooth
      slices[z].value = [z, bits](int x, int y) {
        return (6 * x + 5 * y + 7 * int(z)) << (bits - 8);
      };
    else if (bits == 12)
      slices[z].value = [z](int x, int y) { return pattern(x, y, int(z)) + 200; };
  const auto read = volumeOf(slices, writer);
  QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
  QVERIFY(read->size == glm::ivec3(16, 12, 5));
  double worst = 0.0;
  for (int z = 0; z < 5; ++z)
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 16; ++x)
        worst = std::max(worst, std::abs(valueAt(*read, x, y, z) -
                                         (slices[std::size_t(z)].value(x, y) - 1024.0)));
  QVERIFY2(worst <= tolerance, qPrintable(QString::number(worst)));
}

void TestDicomSeries::valuesAndUnits_data() {
  QTest::addColumn<QByteArray>("sopClass");
  QTest::addColumn<QByteArray>("unit");
  QTest::addColumn<int>("bits");
  QTest::addColumn<bool>("isSigned");
  QTest::addColumn<int>("stored");
  QTest::addColumn<bool>("hounsfield");
  QTest::addColumn<QString>("name");
  QTest::newRow("CT") << QByteArray(ctClass) << QByteArray() << 16 << true << -700 << true << "CT";
  QTest::newRow("CT, said") << QByteArray(ctClass) << QByteArray("HU") << 16 << true << 3000 << true
                            << "CT";
  QTest::newRow("CT, another unit")
      << QByteArray(ctClass) << QByteArray("US") << 16 << true << 3000 << false << "CT";
  QTest::newRow("12 bits with sign")
      << QByteArray(ctClass) << QByteArray() << 12 << true << -2000 << true << "CT";
  QTest::newRow("12 bits without")
      << QByteArray(mrClass) << QByteArray() << 12 << false << 4000 << false << "MR";
  QTest::newRow("16 bits without")
      << QByteArray(petClass) << QByteArray() << 16 << false << 65000 << false << "PET";
}

void TestDicomSeries::valuesAndUnits() {
  QFETCH(QByteArray, sopClass);
  QFETCH(QByteArray, unit);
  QFETCH(int, bits);
  QFETCH(bool, isSigned);
  QFETCH(int, stored);
  QFETCH(bool, hounsfield);
  QFETCH(QString, name);
  WrittenImage like;
  like.sopClass = sopClass.constData();
  like.stored = std::uint16_t(bits);
  like.isSigned = isSigned;
  like.slope = 0.5;
  std::vector<WrittenImage> slices = stack(like);
  for (WrittenImage& slice : slices)
    slice.value = [stored](int x, int) { return x == 3 ? stored : 0; };
  const auto read = volumeOf(slices, [&](const WrittenImage& written) {
    WrittenSet set = image(written);
    if (!unit.isEmpty())
      set.insert(set.end() - 1, text({0x0028, 0x1054}, "LO", unit));
    return dicomFile(set);
  });
  QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
  QCOMPARE(valueAt(*read, 3, 2, 1), 0.5 * stored - 1024.0);
  QCOMPARE(valueAt(*read, 4, 2, 1), -1024.0);
  QCOMPARE(read->hounsfield, hounsfield);
  QCOMPARE(QString::fromStdString(read->name), name);
  QVERIFY(read->frame == model::Frame::lps);
}

/// PET gives each slice its own scale.
void TestDicomSeries::eachSliceItsScale() {
  WrittenImage like;
  like.sopClass = petClass;
  like.intercept = 0.0;
  std::vector<WrittenImage> slices = stack(like);
  for (std::size_t z = 0; z < slices.size(); ++z) {
    slices[z].slope = 0.1 * double(z + 1);
    slices[z].value = [](int x, int y) { return 100 * y + 7 * x; };
  }
  const auto read = volumeOf(slices);
  QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
  for (int z = 0; z < 5; ++z)
    for (int x = 0; x < 16; ++x)
      QVERIFY(std::abs(valueAt(*read, x, 5, z) - 0.1 * (z + 1) * (500 + 7 * x)) <= read->slope);
  QVERIFY(read->slope < 0.02);
}

void TestDicomSeries::whereVoxelsLie_data() {
  QTest::addColumn<QByteArray>("orientation");
  QTest::addColumn<glm::dvec3>("step");
  QTest::addColumn<glm::dvec3>("expected");
  // Voxel (2, 3, 1) with columns 0.5 mm and rows 0.8 mm apart, from (−30, 20, 100).
  QTest::newRow("axial") << QByteArray("1\\0\\0\\0\\1\\0") << glm::dvec3(0, 0, 2.5)
                         << glm::dvec3(-29, 22.4, 102.5);
  QTest::newRow("sagittal") << QByteArray("0\\1\\0\\0\\0\\-1") << glm::dvec3(-1.5, 0, 0)
                            << glm::dvec3(-31.5, 21, 97.6);
  QTest::newRow("tilted gantry") << QByteArray("1\\0\\0\\0\\1\\0") << glm::dvec3(0, 0.6, 2.5)
                                 << glm::dvec3(-29, 23.0, 102.5);
  // The directions are rounded to a hundredth, as many scanners write them.
  QTest::newRow("rounded") << QByteArray("1\\0\\0\\0\\1\\0") << glm::dvec3(0, 0, 0.625)
                           << glm::dvec3(-29, 22.4, 100.625);
}

void TestDicomSeries::whereVoxelsLie() {
  QFETCH(QByteArray, orientation);
  QFETCH(glm::dvec3, step);
  QFETCH(glm::dvec3, expected);
  std::vector<WrittenImage> slices = stack();
  for (std::size_t z = 0; z < slices.size(); ++z) {
    slices[z].orientation = orientation;
    slices[z].position = glm::dvec3(-30, 20, 100) + double(z) * step;
    slices[z].position.z = std::round(100.0 * slices[z].position.z) / 100.0;
  }
  const auto read = volumeOf(slices);
  QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
  const glm::dvec3 at(read->toLps * glm::dvec4(2, 3, 1, 1));
  QVERIFY2(glm::length(at - expected) < 0.011,
           qPrintable(QString("%1 %2 %3").arg(at.x).arg(at.y).arg(at.z)));
  QCOMPARE(valueAt(*read, 2, 3, 1), pattern(2, 3, 1) - 1024.0);
}

void TestDicomSeries::enhancedImages_data() {
  QTest::addColumn<int>("syntax");
  QTest::newRow("JPEG 2000, frames in pieces") << int(Syntax::jpeg2000);
  QTest::newRow("runs, frames in one piece each") << int(Syntax::runLength);
  QTest::newRow("explicit") << int(Syntax::explicitLittle);
  QTest::newRow("implicit") << int(Syntax::implicitLittle);
  QTest::newRow("big endian") << int(Syntax::explicitBig);
}

void TestDicomSeries::enhancedImages() {
  QFETCH(int, syntax);
  WrittenImage like;
  like.sopClass = enhancedMrClass;
  WrittenSet set = enhancedImage(stack(like));
  std::vector<QByteArray> frames;
  for (const WrittenImage& slice : stack(like))
    frames.push_back(Syntax(syntax) == Syntax::jpeg2000
                         ? jpeg2000(pixelsOf(slice), slice.columns, slice.rows, 16, true)
                         : runsOf(slice));
  if (Syntax(syntax) == Syntax::jpeg2000)
    set.back() = cutPieces(frames, 40);
  if (Syntax(syntax) == Syntax::runLength)
    set.back() = pieces(frames);
  const QTemporaryDir folder;
  const Path path = put(folder, "all.dcm", dicomFile(set, {Syntax(syntax)}));
  const auto read = model::readDicomSeries(std::array{path}, {});
  QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
  QVERIFY(read->size == glm::ivec3(16, 12, 5));
  QCOMPARE(valueAt(*read, 7, 8, 4), pattern(7, 8, 4) - 1024.0);
  QCOMPARE(read->toLps[2].z, 2.5);
  QCOMPARE(read->name, std::string("MR"));
}

SLINE_TEST_WITH_EVENTS(TestDicomSeries)
#include "test_dicom_series.moc"
