// SPDX-License-Identifier: Apache-2.0
// Tests label volumes in files: every format, number type, byte order and orientation gives the
// same structures on the same side of the patient; names and colours; what is refused, and why.
#include <QFile>
#include <QtTest>
#include <array>
#include <glm/geometric.hpp>

#include "model/import/plan/import.h"
#include "tests/model/import/readers/mesh_files.h"
#include "tests/model/import/volumes/written_volumes.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

namespace {

/// Returns a body with different things at left, in front and at the head, so that no turn or
/// reflection leaves it as it is, in LPS millimetres.
int bodyAt(const glm::dvec3& p) {
  const auto box = [&](const glm::dvec3& low, const glm::dvec3& high) {
    return p.x > low.x && p.y > low.y && p.z > low.z && p.x < high.x && p.y < high.y &&
           p.z < high.z;
  };
  if (box({4.0, -6.0, -5.0}, {11.0, 1.0, 3.0}))
    return 1;  // left
  if (box({-9.0, -12.0, 2.0}, {-3.0, -4.0, 7.0}))
    return 2;  // right, in front, towards the head
  if (box({-5.0, 3.0, -13.0}, {1.0, 10.0, -8.0}))
    return 5;  // behind, towards the feet
  return 0;
}

const std::array<std::pair<int, Box>, 3>& bodyBoxes() {
  static const std::array<std::pair<int, Box>, 3> boxes = {
      {{1, {{4.0f, -6.0f, -5.0f}, {11.0f, 1.0f, 3.0f}}},
       {2, {{-9.0f, -12.0f, 2.0f}, {-3.0f, -4.0f, 7.0f}}},
       {5, {{-5.0f, 3.0f, -13.0f}, {1.0f, 10.0f, -8.0f}}}}};
  return boxes;
}

/// Returns a grid of half millimetres around the body with axes along the columns.
glm::dmat4 gridAlong(const std::array<glm::dvec3, 3>& axes, const glm::ivec3& size) {
  glm::dmat4 matrix(1.0);
  glm::dvec3 corner(0.0);
  for (int i = 0; i < 3; ++i) {
    matrix[i] = glm::dvec4(0.5 * axes[std::size_t(i)], 0.0);
    corner -= 0.25 * double(size[i]) * axes[std::size_t(i)];
  }
  matrix[3] = glm::dvec4(corner, 1.0);
  return matrix;
}

constexpr glm::ivec3 bodySize{64, 62, 60};

const WrittenVolume& plainBody() {
  static const WrittenVolume body = sampled(
      bodySize,
      gridAlong({glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}, bodySize), bodyAt);
  return body;
}

/// Returns a smaller body for rows in which only the numbers matter.
const WrittenVolume& smallBody() {
  static const WrittenVolume body = [] {
    glm::dmat4 grid(2.0);
    grid[3] = glm::dvec4(-15.0, -15.0, -15.0, 1.0);
    return sampled(glm::ivec3(15), grid, bodyAt);
  }();
  return body;
}

Result<Imported> importBytes(const QTemporaryDir& folder, const QString& name,
                             const QByteArray& bytes, Smoothing::Mode mode = Smoothing::Mode::off) {
  const QString path = folder.filePath(name);
  writeText(path, bytes);
  ImportOptions options;
  options.smoothing.mode = mode;
  return importInputs(std::array{std::filesystem::path(path.toStdString())}, options);
}

QString fault(const Imported& imported, double tolerance) {
  for (const auto& [label, box] : bodyBoxes()) {
    const Node& node = named(imported.scene, "label " + std::to_string(label));
    if (!node.mesh)
      return QString("no label %1").arg(label);
    const Box& found = node.mesh->bounds();
    const float off =
        std::max(glm::length(found.low - box.low), glm::length(found.high - box.high));
    if (!(off < float(tolerance)))
      return QString("label %1 is off by %2 mm").arg(label).arg(double(off));
  }
  return {};
}

}  // namespace

class VolumeFilesTest : public QObject {
  Q_OBJECT
 private slots:
  void sides_data();
  void sides();
  void numberTypes_data();
  void numberTypes();
  void detached();
  void namesAndColours_data();
  void namesAndColours();
  void segmentsInLayers();
  void frameOverruled();
  void refusals_data();
  void refusals();
  void spoiled_data();
  void spoiled();
};

void VolumeFilesTest::sides_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<double>("tolerance");
  const glm::dvec3 x(1, 0, 0);
  const glm::dvec3 y(0, 1, 0);
  const glm::dvec3 z(0, 0, 1);
  const glm::dvec3 u = glm::normalize(glm::dvec3(0.9, 0.3, -0.2));
  const glm::dvec3 v = glm::normalize(glm::cross(glm::dvec3(0.1, 0.2, 1.0), u));
  const glm::dvec3 w = glm::cross(u, v);
  struct Row {
    const char* name;
    std::array<glm::dvec3, 3> axes;
    double tolerance;
  };
  // Boxes seen on an oblique grid have ragged corners.
  const Row rows[] = {{"LPS", {x, y, z}, 0.6},
                      {"RAS", {-x, -y, z}, 0.6},
                      {"x reversed", {-x, y, z}, 0.6},
                      {"z reversed", {x, y, -z}, 0.6},
                      {"all reversed", {-x, -y, -z}, 0.6},
                      {"permuted", {z, x, y}, 0.6},
                      {"permuted, mirrored", {y, x, z}, 0.6},
                      {"oblique", {u, v, w}, 1.6},
                      {"oblique, mirrored", {v, u, w}, 1.6}};
  for (const Row& row : rows) {
    const WrittenVolume body = sampled(bodySize, gridAlong(row.axes, bodySize), bodyAt);
    const auto add = [&](const char* format, const char* name, const QByteArray& bytes) {
      QTest::addRow("%s, %s", row.name, format) << QString(name) << bytes << row.tolerance;
    };
    add("NIfTI sform", "body.nii", niftiFile(body));
    NiftiForm form;
    form.place = NiftiForm::Place::qform;
    add("NIfTI qform", "body.nii.gz",
        gzipped(niftiFile(body, Number::int16, std::endian::big, form)));
    form.version = 2;
    add("NIfTI-2 qform", "body.nii", niftiFile(body, Number::uint8, std::endian::little, form));
    add("NRRD LPS", "body.nrrd", nrrdFile(body, "left-posterior-superior", "gzip"));
    add("NRRD RAS", "body.nrrd", nrrdFile(body, "RAS"));
    add("NRRD LAS", "body.nrrd", nrrdFile(body, "left-anterior-superior"));
    add("MetaImage", "body.mha", metaImageFile(body, true));
    add("MINC", "body.mnc", mincFile(body));
    add("MINC, scaled", "body.mnc", mincFile(body, 15.0));
  }
}

/// Wherever the voxels begin and whichever way they run, structures at the patient's left stay
/// there.
void VolumeFilesTest::sides() {
  QFETCH(QString, name);
  QFETCH(QByteArray, bytes);
  QFETCH(double, tolerance);
  QTemporaryDir folder;
  const Result<Imported> imported = importBytes(folder, name, bytes);
  QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
  const QString wrong = fault(*imported, tolerance);
  QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
  for (const Node& node : imported->scene.nodes())
    if (node.mesh)
      QVERIFY(QString::fromStdString(node.provenance.frameReason).startsWith("header: "));
}

void VolumeFilesTest::numberTypes_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QByteArray>("bytes");
  const char* const types[] = {"int8",   "uint8", "int16",  "uint16", "int32",
                               "uint32", "int64", "uint64", "float",  "double"};
  for (int type = 0; type < 10; ++type)
    for (const std::endian order : {std::endian::little, std::endian::big}) {
      const auto add = [&](const char* format, const char* name, const QByteArray& bytes) {
        QTest::addRow("%s %s %s", format, types[type], order == std::endian::big ? "big" : "little")
            << QString(name) << bytes;
      };
      const WrittenVolume& body = smallBody();
      const auto number = Number(type);
      NiftiForm second;
      second.version = 2;
      add("NIfTI-1", "b.nii", niftiFile(body, number, order));
      add("NIfTI-2", "b.nii.gz", gzipped(niftiFile(body, number, order, second)));
      for (const char* encoding : {"raw", "gzip", "bzip2", "hex", "ascii"})
        add(qPrintable(QString("NRRD ") + encoding), "b.nrrd",
            nrrdFile(body, "LPS", encoding, number, order));
      add("MetaImage", "b.mha", metaImageFile(body, false, number, order));
      add("packed MetaImage", "b.mha", metaImageFile(body, true, number, order));
    }
}

void VolumeFilesTest::numberTypes() {
  QFETCH(QString, name);
  QFETCH(QByteArray, bytes);
  QTemporaryDir folder;
  const Result<Imported> imported = importBytes(folder, name, bytes);
  QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
  const QString wrong = fault(*imported, 2.5);
  QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
}

/// Data may lie beside the header, behind bytes or lines of something else, and nowhere else.
void VolumeFilesTest::detached() {
  const WrittenVolume& body = smallBody();
  const QByteArray raw = numbers(body, Number::uint8, std::endian::little);
  const auto header = [&](const QByteArray& more) {
    QByteArray bytes = nrrdFile(body, "LPS").replace("\n\n", "\n" + more + "\n");
    return bytes.left(bytes.size() - raw.size() - 1);
  };
  struct Row {
    QByteArray more;
    QByteArray data;
    bool good;
  };
  const Row rows[] = {{"data file: b.raw\n", raw, true},
                      {"data file: ./b.raw\n", raw, true},
                      {"byte skip: 5\ndatafile: b.raw\n", "12345" + raw, true},
                      {"byte skip: -1\ndata file: b.raw\n", "anything" + raw, true},
                      {"line skip: 2\ndata file: b.raw\n", "one\ntwo\n" + raw, true},
                      {"data file: b.raw\n", raw.chopped(1), false},
                      {"byte skip: -2\ndata file: b.raw\n", raw, false},
                      {"data file: ../b.raw\n", raw, false},
                      {"data file: /etc/passwd\n", raw, false},
                      {"data file: none.raw\n", raw, false},
                      {"data file: LIST\n", raw, false}};
  for (const Row& row : rows) {
    QTemporaryDir folder;
    writeText(folder.filePath("b.raw"), row.data);
    const Result<Imported> imported = importBytes(folder, "b.nhdr", header(row.more));
    QVERIFY2(imported.ok() == row.good, row.more.constData());
    if (row.good)
      QVERIFY2(fault(*imported, 2.5).isEmpty(), row.more.constData());
  }
  QTemporaryDir folder;
  writeText(folder.filePath("b.raw"), raw);
  QByteArray meta = metaImageFile(body, false);
  meta = meta.left(meta.size() - raw.size()).replace("LOCAL", "b.raw");
  QVERIFY(fault(*importBytes(folder, "b.mhd", meta), 2.5).isEmpty());
  QVERIFY(!importBytes(folder, "b.mhd", QByteArray(meta).replace("b.raw", "../b.raw")).ok());
}

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

/// A frame chosen by the user says what the file's numbers mean: for NIfTI, RAS changes nothing.
void VolumeFilesTest::frameOverruled() {
  QTemporaryDir folder;
  const QString path = folder.filePath("b.nii");
  writeText(path, niftiFile(plainBody()));
  ImportOptions options;
  options.smoothing.mode = Smoothing::Mode::off;
  const std::array inputs{std::filesystem::path(path.toStdString())};
  options.frame = Frame::ras;
  QVERIFY(fault(*importInputs(inputs, options), 0.6).isEmpty());
  options.frame = Frame::lps;
  const Result<Imported> turned = importInputs(inputs, options);
  QVERIFY(named(turned->scene, "label 1").mesh->bounds().high.x < 0.0f);
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
