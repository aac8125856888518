// SPDX-License-Identifier: Apache-2.0
// Spoils DICOM files at random, with a fixed seed: the reader answers quickly, with sound surfaces
// or an error, and takes little memory, whatever the bytes.
#include <QDir>
#include <QFile>
#include <QTest>
#include <array>
#include <cmath>
#include <optional>

#include "model/import/dicom/dicom.h"
#include "tests/model/import/dicom/surface_facts.h"
#include "tests/model/import/dicom/written_dicom.h"
#include "tests/model/import/dicom/written_images.h"
#include "tests/model/import/dicom/written_segmentation.h"
#include "tests/model/import/dicom/written_structures.h"
#include "tests/support/mutator.h"
#include "tests/support/process_memory.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

namespace {

constexpr int mutationsPerFile = 250;
constexpr const char* seriesRow = "CT";
constexpr double mostGrowthMiB = 600;

/// Overwrites with lengths and counts that lie, and delimiters where none should be.
void overwrite(Mutator& random, QByteArray& bytes, qsizetype at) {
  static const char words[][5] = {"\x00\x00\x00\x00", "\xff\xff\xff\xff", "\xff\xff\xff\x7f",
                                  "\xfe\xff\x00\xe0", "\xfe\xff\x0d\xe0", "\xfe\xff\xdd\xe0",
                                  "\x00\x00\x00\x40", "\xff\xff\x00\x00", "\x01\x00\x00\x00"};
  bytes.replace(at, std::min<qsizetype>(4, bytes.size() - at),
                QByteArray(words[random.below(std::size(words))], 4));
}

/// Replaces numbers written as text, which keep their length.
void replaceNumber(Mutator& random, QByteArray& bytes, qsizetype at) {
  static const char* const numbers[] = {"1e38", "-1e5", "nan", "99999", "0.0001", "\\\\\\", "-0"};
  while (at < bytes.size() && (bytes[at] < '0' || bytes[at] > '9'))
    ++at;
  const QByteArray with = numbers[random.below(std::size(numbers))];
  if (at + with.size() < bytes.size())
    bytes.replace(at, with.size(), with);
}

WrittenSegmentation masks(bool runLength) {
  WrittenSegmentation written;
  written.runLength = runLength;
  written.segments = {{1, "A", "Organ", {1, 2, 3}}, {2, "B", "Organ", {}}};
  for (std::uint16_t segment = 1; segment <= 2; ++segment)
    for (int z = 0; z < 4; ++z)
      written.frames.push_back({segment, {0, 0, 2.0 * z}, std::vector<std::uint8_t>(64, 1)});
  return written;
}

WrittenSegmentation labelMap() {
  WrittenSegmentation written = masks(false);
  written.labelMap = true;
  written.bits = 8;
  written.frames.resize(4);
  for (WrittenFrame& frame : written.frames)
    std::fill_n(frame.pixels.begin(), 20, std::uint8_t(2));
  return written;
}

std::vector<WrittenImage> slices() {
  std::vector<WrittenImage> all(4);
  for (std::size_t z = 0; z < all.size(); ++z)
    all[z].position.z = 2.0 * double(z);
  return all;
}

QByteArray enhancedJpeg2000() {
  WrittenSet set = enhancedImage(slices());
  std::vector<QByteArray> frames;
  for (const WrittenImage& slice : slices())
    frames.push_back(jpeg2000(pixelsOf(slice), slice.columns, slice.rows, 16, true));
  set.back() = pieces(frames);
  return dicomFile(set, {Syntax::jpeg2000});
}

/// Holds the error, and whether what was read is sound; a slice of a scanner makes a volume,
/// everything else surfaces.
struct Answer {
  std::optional<Error> error;
  bool sound = true;
};

bool isSound(const model::RawMeshes& read) {
  for (const model::RawMesh& mesh : read.meshes) {
    for (const glm::vec3& p : mesh.positions)
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        return false;
    for (const model::Triangle& t : mesh.triangles)
      for (const std::uint32_t v : t)
        if (v >= mesh.positions.size())
          return false;
  }
  return true;
}

Answer readAgain(const QTemporaryDir& folder, const QByteArray& bytes, bool series) {
  if (series) {
    const auto read = model::readDicomSeries(std::array{put(folder, "file.dcm", bytes)}, {});
    if (!read)
      return {read.error()};
    const glm::dvec3 size(read->size);
    return {{}, double(read->voxels.size()) == size.x * size.y * size.z && size.z >= 2.0};
  }
  const auto read = readDicomBytes(folder, bytes);
  if (!read)
    return {read.error()};
  return {{}, isSound(*read)};
}

}  // namespace

class TestMutatedDicom : public QObject {
  Q_OBJECT
 private slots:
  void mutations_data();
  void mutations();
};

void TestMutatedDicom::mutations_data() {
  QTest::addColumn<QByteArray>("bytes");
  const WrittenSet set =
      structureSet({{"Ball", "ORGAN", Colour{1, 2, 3}, ball({0, 0, 0}, 10, -8, 4)},
                    {"Rod", "PTV", {}, rod({30, 0, 0}, 4, {0, 2, 4, 6})}});
  QTest::newRow("structure set, explicit") << dicomFile(set);
  QTest::newRow("structure set, implicit, open") << dicomFile(set, {Syntax::implicitLittle, true});
  QTest::newRow("structure set, deflated") << dicomFile(set, {Syntax::deflated});
  QTest::newRow("segmentation") << dicomFile(segmentation(masks(false)));
  QTest::newRow("segmentation, implicit")
      << dicomFile(segmentation(masks(false)), {Syntax::implicitLittle, true});
  QTest::newRow("segmentation, runs") << dicomFile(segmentation(masks(true)), {Syntax::runLength});
  QTest::newRow("label map") << dicomFile(segmentation(labelMap()));
  QTest::newRow("label map, JPEG-LS")
      << packed(dicomFile(segmentation(labelMap())), Packing::jpegLs);
  const QByteArray scan = dicomFile(enhancedImage(slices()));
  QTest::newRow("CT") << scan;
  QTest::newRow("CT, big endian") << dicomFile(enhancedImage(slices()), {Syntax::explicitBig});
  QTest::newRow("CT, JPEG") << packed(scan, Packing::jpegLossless);
  QTest::newRow("CT, JPEG-LS") << packed(scan, Packing::jpegLs);
  QTest::newRow("CT, JPEG 2000") << enhancedJpeg2000();
  QFile real(QString(SLINE_TEST_DATA) + "/formats/dicom/seg_image_ct_binary.dcm");
  if (real.open(QIODevice::ReadOnly))
    QTest::newRow("real segmentation") << real.readAll();
}

void TestMutatedDicom::mutations() {
  QFETCH(QByteArray, bytes);
  const QTemporaryDir folder;
  Mutator mutate(20261121, {overwrite, overwrite, overwrite, replaceNumber});
  const double before = peakResidentMiB();
  const bool series = QByteArray(QTest::currentDataTag()).startsWith(seriesRow);
  int refused = 0;
  for (int i = 0; i < mutationsPerFile; ++i) {
    const Answer answer = readAgain(folder, mutate(bytes), series);
    QVERIFY2(answer.sound, qPrintable(QString("mutation %1").arg(i)));
    if (answer.error) {
      QVERIFY(!answer.error->reason.empty() && !answer.error->remedy.empty());
      ++refused;
    }
  }
  qInfo("%d of %d refused, %.0f MB more", refused, mutationsPerFile, peakResidentMiB() - before);
  QVERIFY2(refused > mutationsPerFile / 20, "hardly any mutation was noticed");
  if (!sanitized)
    QVERIFY2(peakResidentMiB() - before < mostGrowthMiB,
             qPrintable(QString::number(peakResidentMiB() - before)));
}

SLINE_TEST_WITH_EVENTS(TestMutatedDicom)
#include "test_mutated_dicom.moc"
