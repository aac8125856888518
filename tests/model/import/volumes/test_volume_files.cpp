// SPDX-License-Identifier: Apache-2.0
// Tests label volumes in files: names and colours; what is refused, and why.
#include <QtTest>

#include "model/import/plan/import.h"
#include "tests/model/import/readers/mesh_files.h"
#include "tests/model/import/volumes/small_body.h"
#include "tests/model/import/volumes/written_volumes.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

class VolumeFilesTest : public QObject {
  Q_OBJECT
 private slots:
  void namesAndColours_data();
  void namesAndColours();
  void codesBehindNames();
  void segmentsInLayers();
  void refusals_data();
  void refusals();
  void spoiled_data();
  void spoiled();
};

void VolumeFilesTest::namesAndColours_data() {
  QTest::addColumn<QString>("side");
  QTest::addColumn<QByteArray>("text");
  QTest::newRow("3D Slicer colour table")
      << "b.ctbl"
      << QByteArray("# one\n1 strange_thing 12 240 7 255\n2 liver 1 2 3 255\n5 x 9 9 9 255\n");
  QTest::newRow("the folder's only one")
      << "Colours.ctbl" << QByteArray("1 strange_thing 12 240 7 255\n2 liver 1 2 3 255\n");
  QTest::newRow("ITK-SNAP") << "b.txt"
                            << QByteArray(
                                   "# ITK-SnAP\n 0 0 0 0 0 0 0 \"Clear Label\"\n 1 12 240 7 1 1 1 "
                                   "\"strange thing\"\n 2 1 2 3 1 1 1 \"liver\"\n");
  QTest::newRow("BIDS")
      << "b.tsv"
      << QByteArray("index\tname\tcolor\n1\tstrange thing\t#0cf007\n2\tliver\t#010203\n");
  QTest::newRow("columns") << "b_names.csv"
                           << QByteArray(
                                  "name,r,g,b,label\nstrange thing,12,240,7,1\nliver,1,2,3,2\n");
  QTest::newRow("JSON lists")
      << "b.json"
      << QByteArray(R"({"labels":["air","strange thing","liver"],"R":[0,12,1],"G":[0,240,2],)"
                    R"("B":[0,7,3]})");
  QTest::newRow("JSON lists with numbers")
      << "b.json"
      << QByteArray(R"({"I":[2,1],"labels":["liver","strange thing"],"R":[1,12],"G":[2,240],)"
                    R"("B":[3,7]})");
  QTest::newRow("JSON list")
      << "b.json"
      << QByteArray(
             R"([{"value":1,"name":"strange thing","color":[12,240,7]},{"value":2,"name":"liver"}])");
}

void VolumeFilesTest::namesAndColours() {
  QFETCH(QString, side);
  QFETCH(QByteArray, text);
  QTemporaryDir folder;
  writeText(folder.filePath(side), text);
  const Result<Imported> imported = importBytes(folder, "b.nrrd", nrrdFile(smallBody(), "LPS"));
  QVERIFY(imported.ok());
  QCOMPARE(named(imported->scene, "strange thing").style.colour, std::optional(Colour{12, 240, 7}));
  QVERIFY(named(imported->scene, "liver").mesh != nullptr);
  // The anatomical table knows the liver's colour better.
  QVERIFY(named(imported->scene, "liver").style.colour != std::optional(Colour{1, 2, 3}));

  NiftiForm form;
  form.extension =
      "<?xml version=\"1.0\"?><CaretExtension><VolumeInformation><LabelTable>"
      "<Label Key=\"1\" Red=\"0.047\" Green=\"0.941\" Blue=\"0.027\" Alpha=\"1\">"
      "<![CDATA[strange_thing]]></Label><Label Key=\"2\" Red=\"0\" Green=\"0\" Blue=\"1\" "
      "Alpha=\"1\">kidney_right</Label></LabelTable></VolumeInformation></CaretExtension>";
  const Result<Imported> caret =
      importBytes(folder, "other.nii.gz",
                  gzipped(niftiFile(smallBody(), Number::uint8, std::endian::little, form)));
  QVERIFY(caret.ok());
  QCOMPARE(named(caret->scene, "strange thing").style.colour, std::optional(Colour{12, 240, 7}));
  QVERIFY(named(caret->scene, "kidney right").mesh != nullptr);
}

/// 3D Slicer's overlapping segments come in two layers, with a voxel in both.
/// Atlases of the brain have a third column; numbers that tell names apart are not one.
void VolumeFilesTest::codesBehindNames() {
  QTemporaryDir folder;
  const auto imported = [&](const char* table) {
    writeText(folder.filePath("b.txt"), table);
    return importBytes(folder, "b.nrrd", nrrdFile(smallBody(), "LPS"));
  };
  const auto coded = imported("1 strange_thing 2001\n2 liver 2002\n5 spleen 2101\n");
  QVERIFY(coded.ok());
  QVERIFY(named(coded->scene, "strange thing").mesh && named(coded->scene, "liver").mesh);
  const auto numbered = imported("1 rib 1\n2 rib 2\n5 rib 3\n");
  QVERIFY(numbered.ok());
  QVERIFY(named(numbered->scene, "rib 1").mesh && named(numbered->scene, "rib 2").mesh);
  const auto some = imported("1 strange_thing 2001\n2 liver 2002\n5 spleen\n");
  QVERIFY(some.ok());
  QVERIFY(named(some->scene, "strange thing 2001").mesh);
}

void VolumeFilesTest::segmentsInLayers() {
  QByteArray header =
      "NRRD0005\ntype: unsigned char\ndimension: 4\nspace: left-posterior-superior\n"
      "sizes: 2 6 6 6\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\n"
      "kinds: list domain domain domain\nencoding: raw\nspace origin: (0,0,0)\n"
      "Segment0_Name:=tumour\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n"
      "Segment0_Color:=0.1 0.9 0.2\nSegment1_Name:=liver\nSegment1_LabelValue:=1\n"
      "Segment1_Layer:=1\nSegment2_Name:=cyst\nSegment2_LabelValue:=2\nSegment2_Layer:=1\n\n";
  for (int z = 0; z < 6; ++z)
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 6; ++x) {
        header += char(x == 2 && y == 2 && z == 2);
        header += char(x == 5 ? 2 : x > 0 ? 1 : 0);
      }
  QTemporaryDir folder;
  const Result<Imported> imported = importBytes(folder, "a.seg.nrrd", header);
  QVERIFY(imported.ok());
  QCOMPARE(imported->scene.structuresBelow(rootId).size(), std::size_t(3));
  QCOMPARE(named(imported->scene, "tumour").mesh->bounds().low, glm::vec3(1.5f));
  QCOMPARE(named(imported->scene, "liver").mesh->bounds().high, glm::vec3(4.5f, 5.5f, 5.5f));
  QCOMPARE(named(imported->scene, "cyst").mesh->bounds().low, glm::vec3(4.5f, -0.5f, -0.5f));
}

void VolumeFilesTest::refusals_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<QString>("fragment");
  const WrittenVolume& body = smallBody();
  const auto row = [](const char* what, const char* name, const QByteArray& bytes,
                      const char* fragment) {
    QTest::newRow(what) << QString(name) << bytes << QString(fragment);
  };
  WrittenVolume grey = body;
  WrittenVolume below = body;
  for (std::size_t i = 0; i < grey.values.size(); ++i) {
    grey.values[i] = int(i * 7919 % 251);
    below.values[i] = int(i % 40) - 20;
  }
  row("grey values", "b.nii", niftiFile(grey), "scan rather than a label volume");
  row("Hounsfield units", "b.nii.gz", gzipped(niftiFile(below, Number::int16)), "below zero");
  NiftiForm scaled;
  scaled.slope = 0.3f;
  row("probabilities", "b.nii", niftiFile(body, Number::uint8, std::endian::little, scaled),
      "whole numbers");
  row("nothing but background", "b.mha",
      metaImageFile(sampled(glm::ivec3(9), glm::dmat4(1.0), [](const glm::dvec3&) { return 0; }),
                    true),
      "background");
  row("cut off", "b.nrrd", nrrdFile(body, "LPS").chopped(5), "promises 3375");
  row("cut off, packed", "b.nrrd", nrrdFile(body, "LPS", "gzip").chopped(40), "voxel");
  row("broken gzip", "b.nrrd", nrrdFile(body, "LPS", "gzip").replace("\x1f\x8b", "\x1f\x8c"),
      "unpacked");
  row("MINC 2", "b.mnc", "\x89HDF\r\n\x1a\n", "MINC 2 (HDF5)");
  row("MINC cut off", "b.mnc", mincFile(body).left(300), "broken there or ends early");
  row("MINC of another kind", "b.mnc", mincFile(body).replace("image\0\0\0", "voxel\0\0\0"),
      "without a variable 'image'");
  row("no volume", "b.nii", "something else altogether", "NIfTI");
  row("too many voxels", "b.nrrd",
      nrrdFile(body, "LPS").replace("sizes: 15 15 15", "sizes: 999999 999999 999999"), "voxels");
  row("more than the bytes", "b.mha",
      metaImageFile(body, true).replace("DimSize = 15 15 15", "DimSize = 512 512 512"), "bytes");
  row("one axis", "b.nrrd", "NRRD0001\ntype: uchar\ndimension: 1\nsizes: 3\nencoding: raw\n\nabc",
      "three");
  row("colours", "b.nrrd",
      QByteArray("NRRD0004\ntype: uchar\ndimension: 4\nsizes: 3 2 2 2\nkinds: RGB-color domain "
                 "domain domain\nencoding: raw\n\n") +
          QByteArray(24, '\1'),
      "neither label nor intensity");
  row("blocks", "b.nrrd", nrrdFile(body, "LPS").replace("type: uchar", "type: block"), "type");
  row("unknown encoding", "b.nrrd", nrrdFile(body, "LPS").replace("raw", "zstd"), "encoding");
  row("unknown space", "b.nrrd", nrrdFile(body, "sideways"), "space");
  row("flat directions", "b.nrrd", nrrdFile(body, "LPS").replace("(0,0,2)", "(0,2,0)"), "span");
  row("no data line", "b.mha", "ObjectType = Image\nNDims = 3\n", "ElementDataFile");
}

void VolumeFilesTest::refusals() {
  QFETCH(QString, name);
  QFETCH(QByteArray, bytes);
  QFETCH(QString, fragment);
  QTemporaryDir folder;
  const Result<RawMeshes> read = readBytes(folder, name, bytes);
  QVERIFY(!read.ok());
  const QString told = QString::fromStdString(read.error().text());
  QVERIFY2(told.contains(fragment), qPrintable(told));
  QVERIFY2(!read.error().file.empty() && !read.error().remedy.empty(), qPrintable(told));
}

void VolumeFilesTest::spoiled_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QByteArray>("bytes");
  const WrittenVolume& body = smallBody();
  QTest::newRow("NIfTI") << "s.nii" << niftiFile(body, Number::int16);
  QTest::newRow("packed NIfTI") << "s.nii.gz" << gzipped(niftiFile(body));
  for (const char* encoding : {"raw", "gzip", "bzip2", "ascii"})
    QTest::addRow("NRRD %s", encoding) << "s.nrrd" << nrrdFile(body, "RAS", encoding);
  QTest::newRow("MetaImage") << "s.mha" << metaImageFile(body, false, Number::float32);
  QTest::newRow("packed MetaImage") << "s.mha" << metaImageFile(body, true);
  QTest::newRow("MINC") << "s.mnc" << mincFile(body);
}

/// Bytes changed, cut and doubled at random give a sound surface, or an error with a remedy.
void VolumeFilesTest::spoiled() {
  QFETCH(QString, name);
  QFETCH(QByteArray, bytes);
  QTemporaryDir folder;
  std::mt19937 random(20260101);
  const auto below = [&](qsizetype n) { return qsizetype(random() % std::uint32_t(n)); };
  // A change matters most in headers.
  const auto place = [&](const QByteArray& in) {
    return below(random() % 3 == 0 ? in.size() : std::min<qsizetype>(in.size(), 400));
  };
  int refused = 0;
  for (int i = 0; i < 150; ++i) {
    QByteArray spoiled = bytes;
    switch (random() % 5) {
      case 0:
        spoiled.truncate(1 + below(spoiled.size() - 1));
        break;
      case 1:
        spoiled.remove(place(spoiled), 1 + below(9));
        break;
      case 2:
        spoiled.insert(place(spoiled), "99999999");
        break;
      default:
        for (int k = 0; k < 3; ++k)
          spoiled[place(spoiled)] = char(random());
    }
    const Result<RawMeshes> read = readBytes(folder, name, spoiled);
    if (read)
      QVERIFY(isSound(*read));
    else
      QVERIFY(!read.error().reason.empty() && !read.error().remedy.empty());
    refused += !read.ok();
  }
  QVERIFY(refused > 10);
}

SLINE_TEST(VolumeFilesTest)
#include "test_volume_files.moc"
