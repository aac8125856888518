// SPDX-License-Identifier: Apache-2.0
// Tests label volumes in files: every format, number type, byte order and orientation gives the
// same structures on the same side of the patient.
#include <QtTest>
#include <array>
#include <glm/geometric.hpp>

#include "model/import/plan/import.h"
#include "tests/model/import/volumes/small_body.h"
#include "tests/model/import/volumes/written_volumes.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

namespace {

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
  static const WrittenVolume body =
      sampled(bodySize,
              gridAlong({glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}, bodySize),
              labelledBodyAt);
  return body;
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

class VolumeSidesTest : public QObject {
  Q_OBJECT
 private slots:
  void sides_data();
  void sides();
  void numberTypes_data();
  void numberTypes();
  void detached();
  void frameOverruled();
};

void VolumeSidesTest::sides_data() {
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
    const WrittenVolume body = sampled(bodySize, gridAlong(row.axes, bodySize), labelledBodyAt);
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
void VolumeSidesTest::sides() {
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

void VolumeSidesTest::numberTypes_data() {
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

void VolumeSidesTest::numberTypes() {
  QFETCH(QString, name);
  QFETCH(QByteArray, bytes);
  QTemporaryDir folder;
  const Result<Imported> imported = importBytes(folder, name, bytes);
  QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
  const QString wrong = fault(*imported, 2.5);
  QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
}

/// Data may lie beside the header, behind bytes or lines of something else, and nowhere else.
void VolumeSidesTest::detached() {
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

/// A frame chosen by the user says what the file's numbers mean: for NIfTI, RAS changes nothing.
void VolumeSidesTest::frameOverruled() {
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

SLINE_TEST(VolumeSidesTest)
#include "test_volume_sides.moc"
