// SPDX-License-Identifier: Apache-2.0
// Tests that what a volume says twice and differently, more than once, or in words that are not
// understood is told.
#include <QtTest>
#include <cstring>

#include "model/import/plan/import.h"
#include "tests/model/import/volumes/small_body.h"
#include "tests/model/import/volumes/written_volumes.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

namespace {

QString warningsOf(const Result<Imported>& imported) {
  return imported.ok() ? test::warningsOf(*imported)
                       : QString::fromStdString(imported.error().text());
}

/// Returns a NIfTI file with both forms, which agree.
QByteArray bothForms() {
  NiftiForm form;
  form.place = NiftiForm::Place::qform;
  QByteArray file = niftiFile(smallBody(), Number::uint8, std::endian::little, form);
  const QByteArray other = niftiFile(smallBody());
  file.replace(254, 2, other.mid(254, 2));
  file.replace(280, 48, other.mid(280, 48));
  return file;
}

void changeFloat(QByteArray& file, qsizetype at, float (*change)(float)) {
  float value = 0.0f;
  std::memcpy(&value, file.constData() + at, sizeof value);
  value = change(value);
  std::memcpy(file.data() + at, &value, sizeof value);
}

}  // namespace

class DoubtfulVolumesTest : public QObject {
  Q_OBJECT
 private slots:
  void formsOfNifti_data() {
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<QString>("says");  // empty: nothing of it
    constexpr qsizetype rowX = 280;
    const auto row = [](const char* tag, qsizetype at, float (*change)(float), const char* says) {
      QByteArray file = bothForms();
      if (at > 0)
        changeFloat(file, at, change);
      QTest::newRow(tag) << file << QString(says);
    };
    const auto same = [](float x) { return x; };
    row("agree", 0, same, "");
    row(
        "rounded", rowX + 12, [](float x) { return x + 0.001f; }, "");
    row(
        "moved", rowX + 12, [](float x) { return x + 25.0f; }, "differently, by up to 25 of");
    row(
        "mirrored", rowX, [](float x) { return -x; }, "left and right swapped");
    row(
        "qform off", 252, [](float) { return 0.0f; }, "");
  }
  void formsOfNifti() {
    QFETCH(QByteArray, file);
    QFETCH(QString, says);
    QTemporaryDir folder;
    const Result<Imported> imported = importBytes(folder, "a.nii", file);
    QVERIFY(imported.ok());
    const QString told = warningsOf(imported);
    QVERIFY2(told.contains("sform and qform") == !says.isEmpty(), qPrintable(told));
    QVERIFY2(told.contains(says), qPrintable(told));
  }

  void volumesInARow() {
    QByteArray file = niftiFile(smallBody());
    const QByteArray voxels = numbers(smallBody(), Number::uint8, std::endian::little);
    file[40] = 4;  // axes
    file[48] = 3;  // of the fourth
    QTemporaryDir folder;
    const Result<Imported> imported = importBytes(folder, "a.nii", file + voxels + voxels);
    QVERIFY2(imported.ok(), qPrintable(warningsOf(imported)));
    QVERIFY2(warningsOf(imported).contains("holds 3 label volumes of one place"),
             qPrintable(warningsOf(imported)));
    const Result<Imported> one = importBytes(folder, "b.nii", niftiFile(smallBody()));
    QVERIFY(!warningsOf(one).contains("label volumes"));
    QCOMPARE(imported->scene.structuresBelow(rootId).size(),
             3 * one->scene.structuresBelow(rootId).size());
  }

  void tableThatIsNotUnderstood() {
    QTemporaryDir folder;
    writeText(folder.filePath("b.txt"), "see the protocol\n");
    const Result<Imported> imported = importBytes(folder, "b.nrrd", nrrdFile(smallBody(), "LPS"));
    QVERIFY2(warningsOf(imported).contains("\"b.txt\" beside it gives none of its labels a name"),
             qPrintable(warningsOf(imported)));
    writeText(folder.filePath("b.txt"), "1 liver\n");
    QVERIFY(!warningsOf(importBytes(folder, "b.nrrd", nrrdFile(smallBody(), "LPS")))
                 .contains("beside it"));
  }

  void listOfOneVolume_data() {
    QTest::addColumn<QByteArray>("axes");
    QTest::newRow("a direction of its own") << QByteArray(
        "space dimension: 4\nsizes: 6 6 6 1\nspace directions: (2,0,0,0) (0,2,0,0) "
        "(0,0,3,0) (0,0,0,1)\nkinds: domain domain domain domain\n"
        "space origin: (10,20,30,0)\n");
    QTest::newRow("no direction") << QByteArray(
        "space: LPS\nsizes: 6 6 6 1\nspace directions: (2,0,0) (0,2,0) (0,0,3) none\n"
        "kinds: domain domain domain list\nspace origin: (10,20,30)\n");
  }
  void listOfOneVolume() {
    QFETCH(QByteArray, axes);
    QByteArray file = "NRRD0004\ntype: unsigned char\ndimension: 4\n" + axes +
                      "encoding: raw\nSegment0_ID:=a\nSegment0_Name:=some_thing\n\n";
    for (int i = 0; i < 216; ++i)
      file += char(i % 6 == 2 && i / 6 % 6 == 3 && i / 36 == 1);
    QTemporaryDir folder;
    const Result<Imported> imported = importBytes(folder, "a.seg.nrrd", file);
    QVERIFY2(imported.ok(), qPrintable(warningsOf(imported)));
    const Box box = named(imported->scene, "some thing").mesh->bounds();
    QCOMPARE(box.low, glm::vec3(13.0f, 25.0f, 31.5f));
    QCOMPARE(box.high, glm::vec3(15.0f, 27.0f, 34.5f));
  }

  void placeInAReferenceImage_data() {
    QTest::addColumn<QByteArray>("axes");
    QTest::addColumn<QByteArray>("keys");
    QTest::addColumn<glm::vec3>("middle");  // of the voxel 2, 3, 1, in LPS
    QTest::addColumn<QString>("frame");
    QTest::addColumn<QString>("says");
    const QByteArray spaceless(
        "dimension: 4\nspace dimension: 4\nsizes: 6 6 6 1\nspace directions: (-2,0,0,0) "
        "(0,-2,0,0) (0,0,3,0) (0,0,0,1)\nspace origin: (100,200,30,0)\n");
    const QByteArray lps(
        "dimension: 3\nspace: LPS\nsizes: 6 6 6\nspace directions: (2,0,0) (0,2,0) (0,0,3)\n"
        "space origin: (-100,-200,30)\n");
    const QByteArray extent("Segmentation_Extent:=40 45 50 55 -2 3\n");
    const QByteArray offset("Segmentation_ReferenceImageExtentOffset:=40 50 -2\n");
    const glm::vec3 first(-96, -194, 33);
    const glm::vec3 moved(-16, -94, 27);
    QTest::newRow("SlicerRT's") << spaceless << extent << moved << "RAS"
                                << "";
    QTest::newRow("of all of the image")
        << spaceless << QByteArray("Segmentation_Extent:=0 5 0 5 0 5\n") << first << "RAS"
        << "";
    QTest::newRow("3D Slicer's") << lps << offset << first << "LPS"
                                 << "";
    QTest::newRow("of another size")
        << lps << QByteArray("Segmentation_Extent:=40 49 50 55 -2 3\n") << first << "LPS"
        << "which are not as many as it has";
    QTest::newRow("both") << lps << extent + offset << first << "LPS"
                          << "it was placed by its origin alone";
    QTest::newRow("SlicerRT's with a space") << lps << extent << moved << "LPS"
                                             << "its origin was taken to be that image's";
  }
  void placeInAReferenceImage() {
    QFETCH(QByteArray, axes);
    QFETCH(QByteArray, keys);
    QFETCH(glm::vec3, middle);
    QFETCH(QString, frame);
    QFETCH(QString, says);
    QByteArray file = "NRRD0004\ntype: unsigned char\n" + axes + "encoding: raw\n" + keys +
                      "Segment0_ID:=a\nSegment0_Name:=some_thing\n\n";
    for (int i = 0; i < 216; ++i)
      file += char(i % 6 == 2 && i / 6 % 6 == 3 && i / 36 == 1);
    QTemporaryDir folder;
    const Result<Imported> imported = importBytes(folder, "a.seg.nrrd", file);
    QVERIFY2(imported.ok(), qPrintable(warningsOf(imported)));
    const Node& node = named(imported->scene, "some thing");
    QCOMPARE(node.mesh->bounds().centre(), middle);
    QCOMPARE(QString::fromStdString(node.provenance.frame), frame);
    QVERIFY(node.provenance.evidence.isSure());
    const QString told = warningsOf(imported);
    QCOMPARE(told.contains("reference image"), !says.isEmpty());
    QVERIFY2(told.contains(says), qPrintable(told));
  }

  void filesThatPeopleStumbledOver_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("structure");
    QTest::addColumn<int>("structures");
    QTest::newRow("a list of one") << "union_4_axes.seg.nrrd"
                                   << "Bladder Union PTV" << 1;
    QTest::newRow("DICOM by its bytes") << "label_23x38x3.seg"
                                        << "" << 1;
    QTest::newRow("lists") << "aal.nii.gz"
                           << "Precentral L" << 116;
  }
  void filesThatPeopleStumbledOver() {
    QFETCH(QString, file);
    QFETCH(QString, structure);
    QFETCH(int, structures);
    const QString path = QStringLiteral(SLINE_TEST_DATA "/reports/") + file;
    if (!QFile::exists(path))
      SLINE_ABSENT("the reports' files are not here");
    const auto imported = importInputs(std::array{std::filesystem::path(path.toStdString())}, {});
    QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
    QCOMPARE(int(imported->scene.structuresBelow(rootId).size()), structures);
    if (!structure.isEmpty())
      QVERIFY(named(imported->scene, structure.toStdString()).mesh);
  }
};

SLINE_TEST(DoubtfulVolumesTest)
#include "test_doubtful_volumes.moc"
