// SPDX-License-Identifier: Apache-2.0
// Tests scans: intensities as they stand in files, and structures made of them by thresholds.
#include <QFile>
#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/import/volumes/threshold_presets.h"
#include "model/import/volumes/volume_readers.h"
#include "tests/model/import/readers/mesh_files.h"
#include "tests/model/import/volumes/scan_phantoms.h"
#include "tests/model/import/volumes/written_volumes.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

namespace {

std::string told(const std::vector<std::string>& notes) {
  std::string all;
  for (const std::string& note : notes)
    all += note + "\n";
  return all;
}

double volumeOf(const Mesh& mesh) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles()) {
    const auto& p = mesh.positions();
    sum += glm::dot(glm::dvec3(p[t[0]]), glm::cross(glm::dvec3(p[t[1]]), glm::dvec3(p[t[2]])));
  }
  return sum / 6.0;
}

}  // namespace

class ScansTest : public QObject {
  Q_OBJECT
 private slots:
  void numberTypes_data();
  void numberTypes();
  void fractionsAreRounded();
  void surfaceLiesWhereIntensitiesCross_data();
  void surfaceLiesWhereIntensitiesCross();
  void boundsOnBothSides();
  void bodyAndItsParts();
  void withoutUnits();
  void whatIsRefused_data();
  void whatIsRefused();
  void amongLabels();
  void realCt();
};

void ScansTest::numberTypes_data() {
  QTest::addColumn<int>("type");
  QTest::addColumn<int>("shift");
  QTest::newRow("int16") << int(Number::int16) << 0;
  QTest::newRow("uint16 beyond int16") << int(Number::uint16) << 40'000;
  QTest::newRow("int32 far from zero") << int(Number::int32) << -1'000'000;
  QTest::newRow("float, whole") << int(Number::float32) << 0;
  QTest::newRow("double, whole") << int(Number::float64) << 70'000;
}

void ScansTest::numberTypes() {
  QFETCH(int, type);
  QFETCH(int, shift);
  WrittenVolume volume = ball();
  for (int& value : volume.values)
    value += shift;
  QTemporaryDir folder;
  for (const auto order : {std::endian::little, std::endian::big}) {
    const std::array files{
        written(folder, "a.nii.gz", gzipped(niftiFile(volume, Number(type), order))),
        written(folder, "a.nrrd", nrrdFile(volume, "LPS", "gzip", Number(type), order)),
        written(folder, "b.nrrd", nrrdFile(volume, "LPS", "ascii", Number(type), order)),
        written(folder, "a.mha", metaImageFile(volume, true, Number(type), order))};
    for (const auto& file : files) {
      const auto read = readGreyVolume(file, {});
      QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
      QVERIFY(read->notes.empty());
      const GreyVolume& grey = *read->volume;
      QCOMPARE(grey.voxels.size(), volume.values.size());
      for (std::size_t i = 0; i < grey.voxels.size(); ++i)
        QCOMPARE(grey.slope * grey.voxels[i] + grey.intercept, double(volume.values[i]));
    }
  }
}

void ScansTest::fractionsAreRounded() {
  NiftiForm form;
  form.slope = 0.25f;
  WrittenVolume wide = ball();
  for (int& value : wide.values)
    value *= 1000;  // spans 1.8 million: more than 16 bits tell apart
  QTemporaryDir folder;
  const auto file =
      written(folder, "a.nii", niftiFile(wide, Number::int32, std::endian::little, form));
  const auto read = readGreyVolume(file, {});
  QVERIFY(read.ok());
  const double bound = 0.25 * 1.8e6 / 65535.0 / 2.0;
  QVERIFY(told(read->notes).find("rounded to 16 bits, by at most 3.4") != std::string::npos);
  for (std::size_t i = 0; i < wide.values.size(); ++i) {
    const double found = read->volume->slope * read->volume->voxels[i] + read->volume->intercept;
    QVERIFY(std::abs(found - 0.25 * wide.values[i]) <= bound * 1.0001);
  }
}

void ScansTest::surfaceLiesWhereIntensitiesCross_data() {
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<QString>("name");
  const WrittenVolume volume = ball();
  QTest::newRow("NIfTI") << niftiFile(volume, Number::int16) << "a.nii";
  QTest::newRow("NRRD RAS") << nrrdFile(volume, "RAS", "raw", Number::int16) << "a.nrrd";
  QTest::newRow("NRRD LPS") << nrrdFile(volume, "LPS", "gzip", Number::float32) << "a.nrrd";
  QTest::newRow("MetaImage") << metaImageFile(volume, false, Number::int16) << "a.mha";
}

/// Voxels are 2 mm wide; the surface lies where it was to a seventh of one, and at the patient's
/// left.
void ScansTest::surfaceLiesWhereIntensitiesCross() {
  QFETCH(QByteArray, bytes);
  QFETCH(QString, name);
  QTemporaryDir folder;
  const std::array inputs{written(folder, qPrintable(name), bytes)};
  for (const auto mode : {Smoothing::Mode::off, Smoothing::Mode::automatic}) {
    ImportOptions options = with({{"bone", 200.0, {}}});
    options.smoothing.mode = mode;
    const auto imported = importInputs(inputs, options);
    QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
    const Node& bone = named(imported->scene, "bone");
    QVERIFY(bone.mesh);
    for (const glm::vec3& p : bone.mesh->positions()) {
      const double off = glm::distance(glm::dvec3(p), ballCentre) - ballRadius;
      QVERIFY2(std::abs(off) < 0.3, qPrintable(QString::number(off)));
    }
    const double expected = 4.0 / 3.0 * 3.14159265 * ballRadius * ballRadius * ballRadius;
    QVERIFY(std::abs(volumeOf(*bone.mesh) / expected - 1.0) < 0.01);
    QVERIFY(bone.provenance.intensities && bone.provenance.intensities->low == 200.0f);
    QCOMPARE(bone.provenance.part, std::string("bone"));
  }
}

void ScansTest::boundsOnBothSides() {
  QTemporaryDir folder;
  const std::array inputs{written(folder, "a.nii", niftiFile(ball(), Number::int16))};
  const auto imported = importInputs(inputs, with({{"rind", 0.0, 500.0}}));
  QVERIFY(imported.ok());
  const Box box = named(imported->scene, "rind").mesh->bounds();
  QVERIFY(std::abs(double(box.size().x) - 2.0 * (ballRadius + 2.0)) < 0.6);
  const double inner = ballRadius - 3.0;
  const double outer = ballRadius + 2.0;
  const double expected = 4.18879 * (outer * outer * outer - inner * inner * inner);
  QVERIFY(std::abs(volumeOf(*named(imported->scene, "rind").mesh) / expected - 1.0) < 0.03);
}

void ScansTest::bodyAndItsParts() {
  QTemporaryDir folder;
  const std::array inputs{written(folder, "ct.nii.gz", gzipped(niftiFile(body(), Number::int16)))};
  const auto imported = importInputs(inputs, with({{"skin", {}, {}}, {"bone", {}, {}}}));
  QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
  const Mesh& skin = *named(imported->scene, "skin").mesh;
  QVERIFY2(skin.bounds().high.y < 33.0f, "the table is no skin");
  QVERIFY(std::abs(double(skin.bounds().size().x) - 80.0) < 3.0);
  // The lung reaches both ends of the volume and is filled all the same.
  const double expected = 3.14159265 * 40.0 * 30.0 * 50.0;
  QVERIFY(std::abs(volumeOf(skin) / expected - 1.0) < 0.05);
  const Mesh& bone = *named(imported->scene, "bone").mesh;
  const Box& found = bone.bounds();
  QVERIFY2(found.low.x > 1.0f && found.high.y < 18.0f,
           qPrintable(QString("%1 %2").arg(double(found.low.x)).arg(double(found.high.y))));
  const std::string notes = told(imported->report.notes);
  QVERIFY2(notes.find("\"bone\": 1 piece of") != std::string::npos, notes.c_str());
  QVERIFY2(notes.find("mm³ in all left out") != std::string::npos, notes.c_str());
  QVERIFY2(notes.find("only the largest is the body's") != std::string::npos, notes.c_str());
}

/// An MR image has no Hounsfield units: the value that separates body from air is found in it.
void ScansTest::withoutUnits() {
  WrittenVolume mr = body();
  for (std::size_t i = 0; i < mr.values.size(); ++i)
    mr.values[i] = (mr.values[i] < -900 ? 10 : mr.values[i] < 0 ? 30 : 400) + int(i * 7919 % 23);
  QTemporaryDir folder;
  const auto file = written(folder, "mr.nii", niftiFile(mr, Number::int16));
  const auto read = readGreyVolume(file, {});
  QVERIFY(read.ok() && !read->volume->hounsfield);
  const auto bounds = boundsOf({"skin", {}, {}}, *read->volume);
  QVERIFY(bounds.ok());
  QVERIFY2(*bounds->low > 60.0 && *bounds->low < 380.0, qPrintable(QString::number(*bounds->low)));
  const auto bone = boundsOf({"bone", {}, {}}, *read->volume);
  QVERIFY(!bone.ok() && bone.error().reason.find("Hounsfield") != std::string::npos);
  const auto imported = importInputs(std::array{file}, with({{"skin", {}, {}}}));
  QVERIFY(imported.ok());
  QVERIFY(named(imported->scene, "skin").mesh->bounds().high.y < 33.0f);
}

void ScansTest::whatIsRefused_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<double>("low");
  QTest::addColumn<QStringList>("fragments");
  QTest::newRow("no threshold") << "" << 0.0
                                << QStringList{"Give a threshold", "choose the segmentation"};
  QTest::newRow("nothing so bright") << "bone" << 5000.0 << QStringList{"5000 and more"};
}

void ScansTest::whatIsRefused() {
  QFETCH(QString, name);
  QFETCH(double, low);
  QFETCH(QStringList, fragments);
  QTemporaryDir folder;
  const std::array inputs{written(folder, "ct.nii", niftiFile(ball(), Number::int16))};
  ImportOptions options;
  if (!name.isEmpty())
    options.thresholds = {{name.toStdString(), low, {}}};
  const auto imported = importInputs(inputs, options);
  QVERIFY(!imported.ok());
  for (const QString& fragment : fragments)
    QVERIFY2(imported.error().text().find(fragment.toStdString()) != std::string::npos,
             imported.error().text().c_str());
}

void ScansTest::amongLabels() {
  QTemporaryDir folder;
  const glm::ivec3 size(20);
  written(folder, "ct.nii", niftiFile(ball(), Number::int16));
  written(folder, "liver.nii", niftiFile(sampled(size, gridOf(2.0, size), [](const glm::dvec3& p) {
            return glm::length(p) < 9.0 ? 1 : 0;
          })));
  const std::array inputs{std::filesystem::path(folder.path().toStdString())};
  const auto without = importInputs(inputs, {});
  QVERIFY(without.ok());
  QCOMPARE(without->scene.structuresBelow(rootId).size(), std::size_t(1));
  const auto ofScan = [](const ImportWarning& w) { return w.file == "ct.nii"; };
  const auto& told = without->report.warnings;
  QCOMPARE(std::count_if(told.begin(), told.end(), ofScan), 1);
  const auto both = importInputs(inputs, with({{"bone", {}, {}}}));
  QVERIFY(both.ok());
  QVERIFY(named(both->scene, "bone").mesh && named(both->scene, "liver").mesh);
  QCOMPARE(named(both->scene, "bone").provenance.file, std::string("ct.nii"));
}

void ScansTest::realCt() {
  const QString file = QStringLiteral(SLINE_TEST_DATA "/labelmap/totalsegmentator/ct_3mm.nii.gz");
  if (!QFile::exists(file))
    SLINE_ABSENT("the CT of TotalSegmentator is not there");
  const std::array inputs{std::filesystem::path(file.toStdString())};
  const auto imported = importInputs(inputs, with({{"bone", {}, {}}, {"skin", {}, {}}}));
  QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
  const Box skin = named(imported->scene, "skin").mesh->bounds();
  const Box bone = named(imported->scene, "bone").mesh->bounds();
  for (int axis = 0; axis < 3; ++axis) {
    QVERIFY(bone.low[axis] > skin.low[axis] - 3.0f);
    QVERIFY(bone.high[axis] < skin.high[axis] + 3.0f);
  }
  // The spine lies behind.
  QVERIFY(bone.centre().y > skin.centre().y);
}

SLINE_TEST(ScansTest)
#include "test_scans.moc"
