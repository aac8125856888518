// SPDX-License-Identifier: Apache-2.0
// DICOM files spoiled at random, with a fixed seed: the reader answers quickly, with sound surfaces
// or an error, and takes little memory, whatever the bytes.
#include <QDir>
#include <QFile>
#include <QTest>
#include <cmath>
#include <ctime>

#include "tests/model/import/dicom/surface_facts.h"
#include "tests/model/import/dicom/written_dicom.h"
#include "tests/support/mutator.h"
#include "tests/support/process_memory.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

namespace {

constexpr int mutationsPerFile = 250;
constexpr double mostSeconds = 5.0;  ///< of the processor's time, all threads together
constexpr double mostGrowthMiB = 600;

/// Lengths and counts that lie, delimiters where none should be.
void overwrite(Mutator& random, QByteArray& bytes, qsizetype at) {
  static const char words[][5] = {"\x00\x00\x00\x00", "\xff\xff\xff\xff", "\xff\xff\xff\x7f",
                                  "\xfe\xff\x00\xe0", "\xfe\xff\x0d\xe0", "\xfe\xff\xdd\xe0",
                                  "\x00\x00\x00\x40", "\xff\xff\x00\x00", "\x01\x00\x00\x00"};
  bytes.replace(at, std::min<qsizetype>(4, bytes.size() - at),
                QByteArray(words[random.below(std::size(words))], 4));
}

/// The same for numbers written as text, which keep their length.
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
  QFile real(QString(SLINE_TEST_DATA) + "/formats/dicom/seg_image_ct_binary.dcm");
  if (real.open(QIODevice::ReadOnly))
    QTest::newRow("real segmentation") << real.readAll();
}

void TestMutatedDicom::mutations() {
  QFETCH(QByteArray, bytes);
  const QTemporaryDir folder;
  Mutator mutate(20261121, {overwrite, overwrite, overwrite, replaceNumber});
  const double before = peakResidentMiB();
  int refused = 0;
  for (int i = 0; i < mutationsPerFile; ++i) {
    const std::clock_t start = std::clock();
    const auto read = readDicomBytes(folder, mutate(bytes));
    const double took = double(std::clock() - start) / CLOCKS_PER_SEC;
    QVERIFY2(took < mostSeconds, qPrintable(QString("mutation %1").arg(i)));
    if (read) {
      QVERIFY2(isSound(*read), qPrintable(QString("mutation %1").arg(i)));
    } else {
      QVERIFY(!read.error().reason.empty() && !read.error().remedy.empty());
      ++refused;
    }
  }
  QVERIFY2(refused > mutationsPerFile / 20, "hardly any mutation was noticed");
  if (!sanitized)
    QVERIFY2(peakResidentMiB() - before < mostGrowthMiB,
             qPrintable(QString::number(peakResidentMiB() - before)));
}

SLINE_TEST_WITH_EVENTS(TestMutatedDicom)
#include "test_mutated_dicom.moc"
