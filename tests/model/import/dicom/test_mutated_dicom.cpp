// SPDX-License-Identifier: Apache-2.0
// DICOM files spoiled at random, with a fixed seed: the reader answers quickly, with sound surfaces
// or an error, and takes little memory, whatever the bytes.
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTest>
#include <cmath>
#include <random>

#include "tests/model/import/dicom/surface_facts.h"
#include "tests/model/import/dicom/written_dicom.h"

using namespace sline;
using namespace sline::test;

namespace {

constexpr int mutationsPerFile = 250;
constexpr qint64 longestMs = 5000;
constexpr long mostGrowthKib = 600L * 1024;

// AddressSanitizer keeps freed memory back, so peaks say nothing there.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool measuresMemory = false;
#else
constexpr bool measuresMemory = true;
#endif

/// The most memory this process ever held.
long peakKib() {
  QFile status("/proc/self/status");
  if (!status.open(QIODevice::ReadOnly))
    return 0;
  for (const QByteArray& line : status.readAll().split('\n'))
    if (line.startsWith("VmHWM:"))
      return line.mid(6).trimmed().split(' ').front().toLong();
  return 0;
}

class Mutator {
 public:
  explicit Mutator(std::uint32_t seed) : m_random(seed) {}

  QByteArray operator()(QByteArray bytes) {
    const int edits = 1 + int(below(3));
    for (int i = 0; i < edits && !bytes.isEmpty(); ++i)
      edit(bytes);
    return bytes;
  }

 private:
  std::size_t below(std::size_t n) { return std::size_t(m_random()) % n; }

  void edit(QByteArray& bytes) {
    const auto at = qsizetype(below(std::size_t(bytes.size())));
    const auto length = qsizetype(below(16)) + 1;
    switch (below(8)) {
      case 0:
        bytes[at] = char(bytes[at] ^ (1 << below(8)));
        break;
      case 1:
        bytes.truncate(at);
        break;
      case 2:
        bytes.remove(at, length);
        break;
      case 3:
        bytes.insert(at, bytes.mid(qsizetype(below(std::size_t(bytes.size()))), length));
        break;
      case 4:
        number(bytes, at);
        break;
      default:
        word(bytes, at);
    }
  }

  /// Lengths and counts that lie, delimiters where none should be.
  void word(QByteArray& bytes, qsizetype at) {
    static const char words[][5] = {"\x00\x00\x00\x00", "\xff\xff\xff\xff", "\xff\xff\xff\x7f",
                                    "\xfe\xff\x00\xe0", "\xfe\xff\x0d\xe0", "\xfe\xff\xdd\xe0",
                                    "\x00\x00\x00\x40", "\xff\xff\x00\x00", "\x01\x00\x00\x00"};
    bytes.replace(at, std::min<qsizetype>(4, bytes.size() - at),
                  QByteArray(words[below(std::size(words))], 4));
  }

  /// The same for numbers written as text, which keep their length.
  void number(QByteArray& bytes, qsizetype at) {
    static const char* const numbers[] = {"1e38", "-1e5", "nan", "99999", "0.0001", "\\\\\\", "-0"};
    while (at < bytes.size() && (bytes[at] < '0' || bytes[at] > '9'))
      ++at;
    const QByteArray with = numbers[below(std::size(numbers))];
    if (at + with.size() < bytes.size())
      bytes.replace(at, with.size(), with);
  }

  std::mt19937 m_random;
};

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
  Mutator mutate(20261121);
  const long before = peakKib();
  int refused = 0;
  for (int i = 0; i < mutationsPerFile; ++i) {
    QElapsedTimer timer;
    timer.start();
    const auto read = readDicomBytes(folder, mutate(bytes));
    QVERIFY2(timer.elapsed() < longestMs, qPrintable(QString("mutation %1").arg(i)));
    if (read) {
      QVERIFY2(isSound(*read), qPrintable(QString("mutation %1").arg(i)));
    } else {
      QVERIFY(!read.error().reason.empty() && !read.error().remedy.empty());
      ++refused;
    }
  }
  QVERIFY2(refused > mutationsPerFile / 20, "hardly any mutation was noticed");
  if (measuresMemory)
    QVERIFY2(peakKib() - before < mostGrowthKib, qPrintable(QString::number(peakKib() - before)));
}

QTEST_GUILESS_MAIN(TestMutatedDicom)
#include "test_mutated_dicom.moc"
