// SPDX-License-Identifier: Apache-2.0
// Spoils files at random, with a fixed seed: a reader answers quickly, with a sound surface or an
// error, and takes little memory, whatever the bytes.
#include <QDir>
#include <QFile>
#include <QTest>

#include "tests/model/import/foreign/written_scenes.h"
#include "tests/model/import/readers/mesh_files.h"
#include "tests/support/mutator.h"
#include "tests/support/process_memory.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

namespace {
constexpr int mutationsPerFile = 400;
constexpr double mostGrowthMiB = 200;

/// Overwrites with extremes of the integers and reals that stand in binary files.
void overwrite(Mutator& random, QByteArray& bytes, qsizetype at) {
  static const std::uint32_t words[] = {0,          1,          0x7fffffff, 0x80000000, 0xffffffff,
                                        0x7fc00000, 0x7f800000, 0x00ffffff, 0x10000000, 0x01000000};
  QByteArray word;
  append(word, words[random.below(std::size(words))],
         random.below(2) == 0 ? std::endian::little : std::endian::big);
  bytes.replace(at, std::min<qsizetype>(4, bytes.size() - at), word);
}

/// Replaces numbers written as text by such extremes.
void replaceNumber(Mutator& random, QByteArray& bytes, qsizetype at) {
  static const char* const numbers[] = {
      "0",   "-1",   "4294967295",           "2147483648",          "1e39",
      "nan", "-inf", "99999999999999999999", "9223372036854775807", "",
      "3.5"};
  while (at < bytes.size() && (bytes[at] < '0' || bytes[at] > '9'))
    ++at;
  qsizetype end = at;
  while (end < bytes.size() && ((bytes[end] >= '0' && bytes[end] <= '9') || bytes[end] == '.'))
    ++end;
  bytes.replace(at, end - at, numbers[random.below(std::size(numbers))]);
}
}  // namespace

class TestMutatedFiles : public QObject {
  Q_OBJECT

 private slots:
  void mutations_data() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<QByteArray>("bytes");
    for (const MeshFile& file : cubeFiles())
      QTest::newRow(file.kind) << QString(file.extension) << file.bytes;
    QTest::newRow("x3d") << ".x3d" << x3dXml();
    QTest::newRow("vrml") << ".wrl" << vrml();
    QTest::newRow("3ds") << ".3ds" << threeDs();
    // Real files add features that the cube lacks: compressed blocks, strips, field data.
    QDir folder(QString(SLINE_TEST_DATA) + "/formats/same_mesh");
    for (const QString& name :
         folder.entryList({"adrenal_appended*", "adrenal_binary*", "*strips*"}, QDir::Files)) {
      QFile file(folder.filePath(name));
      if (file.open(QIODevice::ReadOnly))
        QTest::newRow(qPrintable(name)) << name.mid(name.lastIndexOf('.')) << file.readAll();
    }
    QFile slicer(QString(SLINE_TEST_DATA) + "/formats/slicer/TestData/cube.vtp");
    if (slicer.open(QIODevice::ReadOnly))
      QTest::newRow("slicer cube.vtp") << ".vtp" << slicer.readAll();
    QFile sparse(QString(SLINE_TEST_DATA) + "/formats/online3dviewer/SimpleSparseAccessor.gltf");
    if (sparse.open(QIODevice::ReadOnly))
      QTest::newRow("sparse gltf") << ".gltf" << sparse.readAll();
  }

  void mutations() {
    QFETCH(QString, extension);
    QFETCH(QByteArray, bytes);
    QTemporaryDir folder;
    Mutator mutate(20240117, {overwrite, overwrite, replaceNumber});
    const double before = peakResidentMiB();
    int refused = 0;
    for (int i = 0; i < mutationsPerFile; ++i) {
      const QByteArray spoiled = mutate(bytes);
      const Result<model::RawMeshes> read = readBytes(folder, "spoiled" + extension, spoiled);
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
};

SLINE_TEST_WITH_EVENTS(TestMutatedFiles)
#include "test_mutated_files.moc"
