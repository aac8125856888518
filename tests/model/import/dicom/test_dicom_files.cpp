// SPDX-License-Identifier: Apache-2.0
// Tests files that are cut short, broken, of other kinds, or real.
#include <QtTest>

#include "model/import/kinds/file_kinds.h"
#include "tests/model/import/dicom/surface_facts.h"
#include "tests/model/import/dicom/written_dicom.h"
#include "tests/model/import/dicom/written_structures.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

namespace {

QByteArray ballFile(const Manner& manner = {}) {
  return dicomFile(structureSet({{"Ball", "ORGAN", {}, ball({0, 0, 0}, 10, -9, 2)}}), manner);
}

}  // namespace

class TestDicomFiles : public QObject {
  Q_OBJECT
 private slots:
  void cutShort_data();
  void cutShort();
  void refusals_data();
  void refusals();
  void otherKinds_data();
  void otherKinds();
  void recognisedWithoutExtension_data();
  void recognisedWithoutExtension();
  void characterSets_data();
  void characterSets();
  void realFiles_data();
  void realFiles();
};

void TestDicomFiles::cutShort_data() {
  QTest::addColumn<int>("syntax");
  QTest::addColumn<bool>("open");
  QTest::newRow("implicit") << int(Syntax::implicitLittle) << false;
  QTest::newRow("explicit") << int(Syntax::explicitLittle) << false;
  QTest::newRow("open lengths") << int(Syntax::explicitLittle) << true;
  QTest::newRow("deflated") << int(Syntax::deflated) << false;
}

/// Wherever a file ends, the answer is an error that says where, or the surface if only elements
/// behind it are missing.
void TestDicomFiles::cutShort() {
  QFETCH(int, syntax);
  QFETCH(bool, open);
  const QByteArray whole = ballFile({Syntax(syntax), open});
  const QTemporaryDir folder;
  int errors = 0;
  for (qsizetype size = 140; size < whole.size(); size += 41) {
    const auto read = readDicomBytes(folder, whole.left(size));
    if (read.ok()) {
      QVERIFY(!read->meshes.empty());
      continue;
    }
    ++errors;
    const std::string& where = read.error().where;
    QVERIFY(!read.error().reason.empty() && !read.error().remedy.empty());
    // A cut between two elements leaves a sound file that holds less.
    QVERIFY2(where.starts_with("byte ") ||
                 read.error().reason.find("region") != std::string::npos ||
                 read.error().reason.find("kind") != std::string::npos,
             read.error().text().c_str());
  }
  QVERIFY(errors > 20);
}

void TestDicomFiles::refusals_data() {
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<QString>("message");
  QTest::newRow("text") << QByteArray("this is no DICOM file, but it is called one\n").repeated(9)
                        << "is not a DICOM file";
  QTest::newRow("empty") << QByteArray() << "is empty";
  // Each level is a sequence and an item in it, both of open length.
  const QByteArray level("\x40\x00\x30\xa7SQ\0\0\xff\xff\xff\xff\xfe\xff\x00\xe0\xff\xff\xff\xff",
                         20);
  QTest::newRow("deeply nested") << dicomFile(identifying("1.2.840.10008.5.1.4.1.1.481.3")) +
                                        level.repeated(50'000)
                                 << "nested too deep";
  // This replaces the length of the contours' sequence, the longest of the file.
  QByteArray lying = ballFile({Syntax::implicitLittle});
  const qsizetype at = lying.indexOf(QByteArray("\x06\x30\x39\x00", 4));
  lying.replace(at + 4, 4, QByteArray("\xf0\xff\xff\x7f", 4));
  QTest::newRow("a length beyond the file") << lying << "elements are damaged";
  QByteArray bomb = dicomFile(identifying("1.2.840.10008.5.1.4.1.1.481.3"), {Syntax::deflated});
  QTest::newRow("damaged deflated data")
      << bomb.left(bomb.size() - 6) + QByteArray(40, '\x55') << "deflated data";
}

void TestDicomFiles::refusals() {
  QFETCH(QByteArray, bytes);
  QFETCH(QString, message);
  const QTemporaryDir folder;
  const auto read = readDicomBytes(folder, bytes);
  QVERIFY(!read.ok());
  QVERIFY2(QString::fromStdString(read.error().text()).contains(message),
           read.error().text().c_str());
  QVERIFY(QString::fromStdString(read.error().file).endsWith("file.dcm"));
}

void TestDicomFiles::otherKinds_data() {
  QTest::addColumn<QByteArray>("uid");
  QTest::addColumn<QString>("name");
  QTest::newRow("CT") << QByteArray("1.2.840.10008.5.1.4.1.1.2") << "CT image";
  QTest::newRow("enhanced CT") << QByteArray("1.2.840.10008.5.1.4.1.1.2.1") << "CT image";
  QTest::newRow("MR") << QByteArray("1.2.840.10008.5.1.4.1.1.4") << "MR image";
  QTest::newRow("PET") << QByteArray("1.2.840.10008.5.1.4.1.1.128") << "PET image";
  QTest::newRow("plan") << QByteArray("1.2.840.10008.5.1.4.1.1.481.5") << "RT plan";
  QTest::newRow("dose") << QByteArray("1.2.840.10008.5.1.4.1.1.481.2") << "RT dose";
  QTest::newRow("surface segmentation")
      << QByteArray("1.2.840.10008.5.1.4.1.1.66.5") << "surface segmentation";
  QTest::newRow("report") << QByteArray("1.2.840.10008.5.1.4.1.1.88.33") << "structured report";
  QTest::newRow("unknown") << QByteArray("1.2.3.4") << "not known here";
}

void TestDicomFiles::otherKinds() {
  QFETCH(QByteArray, uid);
  QFETCH(QString, name);
  const QTemporaryDir folder;
  const auto read = readDicomBytes(folder, dicomFile(identifying(uid.constData())));
  QVERIFY(!read.ok());
  const QString text = QString::fromStdString(read.error().text());
  QVERIFY2(text.contains(name) && text.contains("holds no segmentation"), qPrintable(text));
}

void TestDicomFiles::recognisedWithoutExtension_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<bool>("recognised");
  QTest::newRow("no extension") << "RS0001" << ballFile() << true;
  QTest::newRow("numbers") << "1.2.840.113619" << ballFile() << true;
  QTest::newRow("no preamble") << "RS0001" << ballFile({Syntax::implicitLittle, false, false})
                               << true;
  QTest::newRow("capitals") << "RS.DCM" << ballFile() << true;
  QTest::newRow("text") << "README" << QByteArray("Read me first. ").repeated(20) << false;
  QTest::newRow("another extension") << "ball.txt" << ballFile() << true;
  QTest::newRow("short") << "RS0001" << ballFile().left(100) << false;
}

void TestDicomFiles::recognisedWithoutExtension() {
  QFETCH(QString, name);
  QFETCH(QByteArray, bytes);
  QFETCH(bool, recognised);
  const QTemporaryDir folder;
  QFile file(folder.filePath(name));
  QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
  file.close();
  const std::filesystem::path path = folder.filePath(name).toStdString();
  QCOMPARE(model::isSurfaceFile(path), recognised);
  QCOMPARE(model::readSurfaces(path).ok(), recognised);
}

void TestDicomFiles::characterSets_data() {
  QTest::addColumn<QByteArray>("set");
  QTest::addColumn<QByteArray>("name");
  QTest::addColumn<QByteArray>("expected");
  QTest::newRow("ASCII") << QByteArray() << QByteArray("Liver") << QByteArray("Liver");
  QTest::newRow("ASCII, broken") << QByteArray() << QByteArray("N\xe9") << QByteArray("N?");
  QTest::newRow("Latin 1") << QByteArray("ISO_IR 100") << QByteArray("N\xe9") << QByteArray("Né");
  QTest::newRow("UTF-8") << QByteArray("ISO_IR 192") << QByteArray("Né") << QByteArray("Né");
  QTest::newRow("UTF-8, broken") << QByteArray("ISO_IR 192") << QByteArray("N\xe9t")
                                 << QByteArray("N?t");
  QTest::newRow("several sets") << QByteArray("ISO 2022 IR 6\\ISO 2022 IR 100")
                                << QByteArray("N\x1b-A\xe9") << QByteArray("Né");
  QTest::newRow("Latin 2") << QByteArray("ISO_IR 101") << QByteArray("W\xb1tr")
                           << QByteArray("Wątr");
  QTest::newRow("Cyrillic") << QByteArray("ISO_IR 144") << QByteArray("\xbf\xd5\xe7\xd5\xdd\xec")
                            << QByteArray("Печень");
  QTest::newRow("Greek") << QByteArray("ISO_IR 126") << QByteArray("\xcd\xe5\xf6\xf1\xfc\xf2")
                         << QByteArray("Νεφρός");
  QTest::newRow("Hebrew") << QByteArray("ISO_IR 138") << QByteArray("\xeb\xe1\xe3")
                          << QByteArray("כבד");
  QTest::newRow("Thai") << QByteArray("ISO_IR 166") << QByteArray("\xb5\xd1\xba")
                        << QByteArray("ตับ");
  QTest::newRow("kanji") << QByteArray("\\ISO 2022 IR 87") << QByteArray("GTV \x1b$B4NB!\x1b(B")
                         << QByteArray("GTV 肝臓");
  QTest::newRow("kanji and kana of half width")
      << QByteArray("ISO 2022 IR 13\\ISO 2022 IR 87") << QByteArray("\xb6\xdd \x1b$B4NB!\x1b(J")
      << QByteArray("ｶﾝ 肝臓");
  QTest::newRow("supplementary kanji")
      << QByteArray("\\ISO 2022 IR 159") << QByteArray("\x1b$(D0!\x1b(B") << QByteArray("丂");
  QTest::newRow("broken kanji") << QByteArray("\\ISO 2022 IR 87") << QByteArray("A\xff\x1b$B4")
                                << QByteArray("A? $B4");
  QTest::newRow("hangul") << QByteArray("\\ISO 2022 IR 149") << QByteArray("\x1b$)C\xb0\xa3")
                          << QByteArray("간");
  QTest::newRow("Chinese, GB 18030")
      << QByteArray("GB18030") << QByteArray("\xb8\xce") << QByteArray("肝");
  QTest::newRow("Chinese, GB 2312")
      << QByteArray("\\ISO 2022 IR 58") << QByteArray("\x1b$)A\xb8\xce") << QByteArray("肝");
  QTest::newRow("unknown set") << QByteArray("ISO_IR 999") << QByteArray("N\xe9t")
                               << QByteArray("N?t");
  QTest::newRow("controls") << QByteArray("ISO_IR 192") << QByteArray("a\nb") << QByteArray("a b");
}

void TestDicomFiles::characterSets() {
  QFETCH(QByteArray, set);
  QFETCH(QByteArray, name);
  QFETCH(QByteArray, expected);
  WrittenSet written = structureSet({{name, "ORGAN", {}, ball({0, 0, 0}, 10, -9, 2)}});
  if (!set.isEmpty())
    written.insert(written.begin() + 1, text({0x0008, 0x0005}, "CS", set));
  const QTemporaryDir folder;
  const auto read = readDicomBytes(folder, dicomFile(written));
  QVERIFY(read.ok());
  QCOMPARE(QByteArray::fromStdString(read->meshes.at(0).name), expected);
}

void TestDicomFiles::realFiles_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<int>("surfaces");
  QTest::addColumn<QString>("message");
  QTest::newRow("rtss") << "rtss.dcm" << 9 << "\"Areola\": has no contour";
  QTest::newRow("segmentation") << "seg_image_ct_binary.dcm" << 1 << "";
  QTest::newRow("CT slice") << "ct.0.dcm" << 0 << "CT image";
  QTest::newRow("CT slice 2") << "ct_image.dcm" << 0 << "CT image";
}

void TestDicomFiles::realFiles() {
  QFETCH(QString, file);
  QFETCH(int, surfaces);
  QFETCH(QString, message);
  const QString path = QString(SLINE_TEST_DATA) + "/formats/dicom/" + file;
  if (!QFile::exists(path))
    SLINE_ABSENT("no such file");
  const auto read = model::readSurfaces(path.toStdString());
  if (!read) {
    QCOMPARE(surfaces, 0);
    QVERIFY2(QString::fromStdString(read.error().text()).contains(message),
             read.error().text().c_str());
    return;
  }
  QCOMPARE(int(read->meshes.size()), surfaces);
  QVERIFY2(warningsOf(*read).contains(message), qPrintable(warningsOf(*read)));
  for (const model::RawMesh& mesh : read->meshes) {
    const SurfaceFacts facts = factsOf(mesh);
    QVERIFY2(facts.closed && facts.volume > 0.0, mesh.name.c_str());
  }
}

SLINE_TEST_WITH_EVENTS(TestDicomFiles)
#include "test_dicom_files.moc"
