// SPDX-License-Identifier: Apache-2.0
// Tests scans: intensities as they stand in files, structures made of them by thresholds, and scans
// that are kept with the scene.
#include <QElapsedTimer>
#include <QFile>
#include <QtTest>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/import/plan/kept_scans.h"
#include "model/import/plan/plan.h"
#include "model/import/plan/reload.h"
#include "model/import/volumes/threshold_presets.h"
#include "model/import/volumes/volume_readers.h"
#include "model/import/volumes/volume_surfaces.h"
#include "model/scene_file/scene_file.h"
#include "model/scene_file/scene_json.h"
#include "tests/model/import/readers/mesh_files.h"
#include "tests/model/import/volumes/written_volumes.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/mutator.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

namespace {

constexpr glm::dvec3 centre{12.0, 3.0, -2.0};
constexpr double radius = 11.3;

/// Returns a ball to the left, as dense as bone in soft tissue: its edge is as soft as a scanner
/// makes it.
int ballAt(const glm::dvec3& p) {
  const double out = glm::distance(p, centre) - radius;
  return int(std::lround(std::clamp(200.0 - 100.0 * out, -900.0, 900.0)));
}

glm::dmat4 gridOf(double side, const glm::ivec3& size) {
  glm::dmat4 grid(side);
  for (int i = 0; i < 3; ++i)
    grid[3][i] = -0.5 * side * double(size[i] - 1);
  grid[3][3] = 1.0;
  return grid;
}

WrittenVolume ball() {
  const glm::ivec3 size(32, 28, 26);
  return sampled(size, gridOf(2.0, size), ballAt);
}

/// Returns a body of fat and muscle around a lung, a bone in it, specks of bone, on a table apart
/// from it.
int bodyAt(const glm::dvec3& p) {
  const double out = std::hypot(p.x / 40.0, p.y / 30.0);
  if (std::abs(p.x) < 45.0 && p.y > 36.0 && p.y < 42.0)
    return 100;
  if (out > 1.0)
    return -1000;
  if (glm::distance(glm::dvec2(p), glm::dvec2(-15.0, 0.0)) < 10.0)
    return -850;
  if (glm::distance(glm::dvec2(p), glm::dvec2(18.0, 0.0)) < 16.0)
    return 700;
  if (glm::distance(p, glm::dvec3(1.0, 19.0, 10.0)) < 1.5)
    return 500;
  return 40;
}

WrittenVolume body() {
  const glm::ivec3 size(50, 50, 25);
  return sampled(size, gridOf(2.0, size), bodyAt);
}

std::filesystem::path written(const QTemporaryDir& folder, const char* name,
                              const QByteArray& bytes) {
  const QString path = folder.filePath(QLatin1String(name));
  writeText(path, bytes);
  return path.toStdString();
}

ImportOptions with(std::vector<Threshold> thresholds) {
  ImportOptions options;
  options.thresholds = std::move(thresholds);
  return options;
}

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
  void keptWithTheScene();
  void spoiledScenes();
  void plannedAnew();
  void reloaded();
  void cancelled();
  void spoiledCopies();
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
      const double off = glm::distance(glm::dvec3(p), centre) - radius;
      QVERIFY2(std::abs(off) < 0.3, qPrintable(QString::number(off)));
    }
    const double expected = 4.0 / 3.0 * 3.14159265 * radius * radius * radius;
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
  QVERIFY(std::abs(double(box.size().x) - 2.0 * (radius + 2.0)) < 0.6);
  const double inner = radius - 3.0;
  const double outer = radius + 2.0;
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
  QTest::newRow("no threshold") << "" << 0.0 << QStringList{"--threshold", "bone, skin or vessels"};
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
  QCOMPARE(without->report.warnings.size(), std::size_t(1));
  const auto both = importInputs(inputs, with({{"bone", {}, {}}}));
  QVERIFY(both.ok());
  QVERIFY(named(both->scene, "bone").mesh && named(both->scene, "liver").mesh);
  QCOMPARE(named(both->scene, "bone").provenance.file, std::string("ct.nii"));
}

void ScansTest::keptWithTheScene() {
  QTemporaryDir folder;
  const WrittenVolume volume = ball();
  const std::array inputs{written(folder, "ct.nii.gz", gzipped(niftiFile(volume, Number::int16)))};
  ImportOptions options = with({{"bone", {}, {}}});
  options.keepScans = true;
  const auto imported = importInputs(inputs, options);
  QVERIFY(imported.ok());
  QCOMPARE(QString::fromStdString(scanText(imported->scene.scans().front())),
           QString("CT, 32 × 28 × 26 voxels of 2 × 2 × 2 mm, 0.1 MB unpacked"));
  const auto bytes = sceneFileBytes({.scene = imported->scene});
  QVERIFY(bytes.ok());
  const auto again = documentFromBytes(*bytes);
  QVERIFY2(again.ok(), again.ok() ? "" : again.error().text().c_str());
  QVERIFY(again->others.empty());
  QCOMPARE(again->scene.scans().size(), std::size_t(1));
  const Scan& scan = again->scene.scans().front();
  QVERIFY(*scan.voxels == *imported->scene.scans().front().voxels);
  QVERIFY(scan.toLps == imported->scene.scans().front().toLps);
  QVERIFY(scan.size == volume.size && scan.hounsfield);
  QCOMPARE(scan.name, std::string("CT"));
  QCOMPARE(scan.file, std::string("ct.nii.gz"));
  // A voxel's middle is the place where the intensity was sampled.
  const glm::dvec4 p = scan.toLps * glm::dvec4(20, 15, 12, 1);
  QCOMPARE(
      scan.intensity((*scan.voxels)[std::size_t((12 * volume.size.y + 15) * volume.size.x + 20)]),
      double(ballAt(glm::dvec3(p))));
  Scene without = imported->scene;
  without.setScans({});
  const std::size_t scanBytes = bytes->size() - sceneFileBytes({.scene = without})->size();
  QVERIFY2(scanBytes < scan.voxels->size(), "half of what its numbers take");
  QCOMPARE(*sceneFileBytes(*again), *bytes);
  // A frame chosen by the user turns both the structure and the scan.
  options.frame = Frame::lps;
  const auto turned = importInputs(inputs, options);
  const glm::dvec4 q = turned->scene.scans().front().toLps * glm::dvec4(20, 15, 12, 1);
  QVERIFY(std::abs(q.x + p.x) < 1e-4 && std::abs(q.y + p.y) < 1e-4 && q.z == p.z);
  QVERIFY(named(turned->scene, "bone").mesh->bounds().high.x < 0.0f);
  // Scenes that are put together have both scans.
  const auto file = folder.filePath("a.sline").toStdString();
  QVERIFY(writeSceneFile(file, {.scene = imported->scene}).ok());
  const auto together =
      importInputs(std::array<std::filesystem::path, 2>{file, inputs[0]}, options);
  QVERIFY(together.ok());
  QCOMPARE(together->scene.scans().size(), std::size_t(2));
}

/// Each fault is reported with its place.
void ScansTest::spoiledScenes() {
  QTemporaryDir folder;
  const std::array inputs{written(folder, "ct.nii", niftiFile(ball(), Number::int16))};
  ImportOptions options;
  options.keepScans = true;
  const auto imported = importInputs(inputs, options);
  QVERIFY(imported.ok());
  const std::string json = sceneJson(imported->scene);
  const VoxelsByName voxels{{"scans/1.scan", imported->scene.scans().front().voxels}};
  QVERIFY(sceneFromJson(*parseJson(json), {}, voxels).ok());
  struct Row {
    const char* before;
    const char* after;
    const char* reason;
  };
  for (const Row& row :
       {Row{"32,\n", "33,\n", "as many voxels"}, Row{"\"slope\": 1.0", "\"slope\": 0.0", "scale"},
        Row{"scans/1.scan", "scans/2.scan", "no such member"},
        Row{"\"size\": [", "\"size\": [1, ", "3 numbers"}}) {
    std::string spoiled = json;
    const std::size_t at = spoiled.find(row.before);
    QVERIFY2(at != std::string::npos, row.before);
    spoiled.replace(at, std::strlen(row.before), row.after);
    const auto scene = sceneFromJson(*parseJson(spoiled), {}, voxels);
    QVERIFY2(!scene.ok() && scene.error().reason.find(row.reason) != std::string::npos, row.after);
    QVERIFY(scene.error().where.starts_with("scans[0]"));
  }
  const std::string bytes = *sceneFileBytes({.scene = imported->scene});
  Mutator mutated(17, {});
  int read = 0;
  for (int i = 0; i < 200; ++i) {
    const QByteArray copy = mutated(QByteArray::fromStdString(bytes));
    const auto document =
        documentFromBytes(std::string_view(copy.data(), std::size_t(copy.size())));
    read += document.ok();
    QVERIFY(document.ok() || !document.error().reason.empty());
  }
  QVERIFY(read < 200);
}

/// Structures made from a scan in memory need no second reading.
void ScansTest::plannedAnew() {
  QTemporaryDir folder;
  const std::array inputs{written(folder, "ct.nii", niftiFile(body(), Number::int16))};
  auto plan = planImport(inputs, {});
  QVERIFY2(plan.ok(), plan.ok() ? "" : plan.error().text().c_str());
  QVERIFY(plan->scene.nodes().empty());
  QVERIFY2(!checkChoices(*plan).ok(), "nothing is made of it yet");
  QVERIFY(QFile::remove(QString::fromStdString(inputs[0].string())));
  plan->options.thresholds = {{"bone", {}, {}}, {"skin", {}, {}}};
  plan = planAgain(*plan);
  QVERIFY2(plan.ok(), plan.ok() ? "" : plan.error().text().c_str());
  QCOMPARE(plan->parts.size(), std::size_t(2));
  plan->choices[plan->scene.named("bone").front()].name = "rib";
  plan->options.thresholds.pop_back();
  plan = planAgain(*plan);
  QVERIFY(plan.ok());
  QCOMPARE(plan->parts.size(), std::size_t(1));
  plan->options.keepScans = true;
  const auto imported = carryOut(*plan);
  QVERIFY(imported.ok());
  QVERIFY(named(imported->scene, "rib").mesh);
  QCOMPARE(imported->scene.scans().size(), std::size_t(1));
}

void ScansTest::reloaded() {
  QTemporaryDir folder;
  const std::array inputs{written(folder, "ct.nii", niftiFile(ball(), Number::int16))};
  const auto imported = importInputs(inputs, with({{"bone", 200.0, {}}}));
  QVERIFY(imported.ok());
  WrittenVolume brighter = ball();
  for (int& value : brighter.values)
    value = std::min(900, value + 200);
  written(folder, "ct.nii", niftiFile(brighter, Number::int16));
  const Reloaded again = reload(imported->scene, inputs);
  QVERIFY2(again.changed, again.files.empty() ? "" : again.files.front().reason.c_str());
  const float width = named(again.scene, "bone").mesh->bounds().size().x;
  QVERIFY(std::abs(double(width) - 2.0 * (radius + 2.0)) < 0.6);
}

void ScansTest::cancelled() {
  QTemporaryDir folder;
  const auto file = written(folder, "ct.nii", niftiFile(body(), Number::int16));
  const auto read = readGreyVolume(file, {});
  QVERIFY(read.ok());
  for (const int after : {0, 1, 5, 30}) {
    int asked = 0;
    ReadOptions options{.goesOn = [&] { return asked++ < after; },
                        .thresholds = {{"skin", {}, {}}}};
    const auto made = scanSurfaces({"ct.nii", read->volume}, options);
    QVERIFY(!made.ok());
    QVERIFY(made.error().reason.find("cancelled") != std::string::npos);
  }
}

void ScansTest::spoiledCopies() {
  QTemporaryDir folder;
  const glm::ivec3 size(15);
  const WrittenVolume volume = sampled(size, gridOf(4.0, size), ballAt);
  struct Row {
    const char* name;
    QByteArray bytes;
  };
  for (const Row& row : {Row{"s.nii", niftiFile(volume, Number::int16)},
                         Row{"s.nrrd", nrrdFile(volume, "LPS", "gzip", Number::float32)},
                         Row{"s.mha", metaImageFile(volume, true, Number::int32)}}) {
    Mutator mutated(7, {});
    for (int i = 0; i < 200; ++i) {
      const auto file = written(folder, row.name, mutated(row.bytes));
      const ReadOptions options{.thresholds = {{"bone", {}, {}}, {"skin", {}, {}}}};
      const auto read = readSurfaces(file, options);
      QVERIFY(read.ok() ? !read->meshes.empty()
                        : !read.error().file.empty() && !read.error().remedy.empty());
    }
  }
}

void ScansTest::realCt() {
  const QString file = QStringLiteral(SLINE_TEST_DATA "/labelmap/totalsegmentator/ct_3mm.nii.gz");
  if (!QFile::exists(file))
    SLINE_ABSENT("the CT of TotalSegmentator is not there");
  QElapsedTimer timer;
  timer.start();
  const std::array inputs{std::filesystem::path(file.toStdString())};
  const auto imported = importInputs(inputs, with({{"bone", {}, {}}, {"skin", {}, {}}}));
  QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
  QVERIFY(timer.elapsed() < 60'000);
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
