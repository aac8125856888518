// SPDX-License-Identifier: Apache-2.0
// Tests meshes packed by gzip: each kind that may be, its name, and what is refused.
#include <QtTest>
#include <array>

#include "model/import/plan/import.h"
#include "tests/model/import/readers/mesh_files.h"
#include "tests/model/import/volumes/written_volumes.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

class PackedFilesTest : public QObject {
  Q_OBJECT

 private slots:
  void sameSurface_data() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<QByteArray>("bytes");
    for (const MeshFile& file : cubeFiles())
      QTest::newRow(file.kind) << QString(file.extension) << file.bytes;
  }

  /// A packed file gives the same vertices and triangles as a plain one, even if it is packed in
  /// two members.
  void sameSurface() {
    QFETCH(QString, extension);
    QFETCH(QByteArray, bytes);
    QTemporaryDir folder;
    const Result<RawMeshes> plain = readBytes(folder, "cube" + extension, bytes);
    const qsizetype half = bytes.size() / 2;
    for (const QByteArray& packed :
         {gzipped(bytes), gzipped(bytes.left(half)) + gzipped(bytes.mid(half))}) {
      const Result<RawMeshes> read = readBytes(folder, "cube" + extension + ".GZ", packed);
      QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
      QCOMPARE(read->meshes.size(), plain->meshes.size());
      QCOMPARE(read->meshes[0].positions, plain->meshes[0].positions);
      QCOMPARE(read->meshes[0].triangles, plain->meshes[0].triangles);
    }
  }

  /// A browser may unpack a file and leave its name.
  void calledPackedOnly() {
    QTemporaryDir folder;
    QVERIFY(readBytes(folder, "cube.off.gz", cubeFile("off")).ok());
  }

  /// A packed file is found in a folder, and its structure is named without either ending.
  void inAFolder() {
    QTemporaryDir folder;
    writeText(folder.filePath("small_cube.stl.gz"), gzipped(cubeFile("stl binary")));
    writeText(folder.filePath("notes.txt.gz"), gzipped("nothing of the kind"));
    const Result<Imported> imported =
        importInputs(std::array{std::filesystem::path(folder.path().toStdString())}, {});
    QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
    QVERIFY(named(imported->scene, "small cube").mesh);
    QVERIFY2(imported->report.warnings.empty(), qPrintable(warningsOf(*imported)));
  }

  void refusals_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("told");
    const QByteArray packed = gzipped(cubeFile("obj"));
    QTest::newRow("cut") << "b.obj.gz" << packed.chopped(12) << "end in the middle";
    QByteArray damaged = packed;
    damaged[packed.size() - 6] = char(damaged[packed.size() - 6] ^ 1);
    QTest::newRow("wrong sum") << "b.obj.gz" << damaged << "damaged";
    QTest::newRow("empty") << "b.ply.gz" << gzipped({}) << "holds nothing when unpacked";
    QTest::newRow("bomb") << "b.obj.gz" << gzipped(QByteArray(80 << 20, '\n'))
                          << "unpacks to more than";
    QTest::newRow("another kind") << "b.stl.gz" << gzipped("a letter") << "STL";
    QTest::newRow("a line of it") << "b.obj.gz" << gzipped("v 0 0 0\nv 0 0 zero\n") << "line 2";
  }

  void refusals() {
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    QFETCH(QString, told);
    QTemporaryDir folder;
    const Result<RawMeshes> read = readBytes(folder, name, bytes);
    QVERIFY(!read.ok());
    const QString text = QString::fromStdString(read.error().text());
    QVERIFY2(text.contains(told), qPrintable(text));
    QVERIFY(!read.error().remedy.empty());
  }

  /// The user's limit applies to the unpacked size.
  void limit() {
    QTemporaryDir folder;
    const QByteArray packed = gzipped(cubeFile("off") + QByteArray(100'000, '\n'));
    QVERIFY(readBytes(folder, "cube.off.gz", packed).ok());
    QVERIFY(!readBytes(folder, "cube.off.gz", packed, {.fileBytes = 50'000}).ok());
  }
};

SLINE_TEST(PackedFilesTest)
#include "test_packed_files.moc"
