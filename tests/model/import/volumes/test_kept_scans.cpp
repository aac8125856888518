// SPDX-License-Identifier: Apache-2.0
// Tests scans that are kept with the scene, and structures made of them anew; cancelled readings
// and spoiled copies.
#include <QFile>
#include <QtTest>
#include <array>
#include <cmath>

#include "model/import/naming/laterality.h"
#include "model/import/plan/kept_scans.h"
#include "model/import/plan/plan.h"
#include "model/import/plan/reload.h"
#include "model/import/volumes/volume_readers.h"
#include "model/import/volumes/volume_surfaces.h"
#include "model/scene_file/scene_file.h"
#include "model/scene_json/scene_json.h"
#include "tests/model/import/readers/mesh_files.h"
#include "tests/model/import/volumes/scan_phantoms.h"
#include "tests/model/import/volumes/written_brain.h"
#include "tests/model/import/volumes/written_volumes.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/mutator.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

class KeptScansTest : public QObject {
  Q_OBJECT
 private slots:
  void keptWithTheScene();
  void liesWithItsStructures();
  void spoiledScenes();
  void plannedAnew();
  void reloaded();
  void cancelled();
  void spoiledCopies();
};

void KeptScansTest::keptWithTheScene() {
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

/// Whatever frame is chosen, also where a file leaves only the side open, a kept scan has the
/// intensity of bone in the middle of the bone that was made of it.
void KeptScansTest::liesWithItsStructures() {
  QTemporaryDir folder;
  const PairBytes pair = analyzePair(ball());
  writeText(folder.filePath("open.hdr"), pair.header);
  writeText(folder.filePath("open.img"), pair.image);
  const std::filesystem::path open = folder.filePath("open.hdr").toStdString();
  const std::filesystem::path told = written(folder, "ct.nii", niftiFile(ball(), Number::int16));
  for (const std::filesystem::path& file : {open, told})
    for (const FrameAxes& axes : frames) {
      if (axes.frame == Frame::file)
        continue;
      ImportOptions options = with({{"bone", {}, {}}});
      options.keepScans = true;
      options.frame = axes.frame;
      const auto imported = importInputs(std::array{file}, options);
      QVERIFY(imported.ok());
      const Scan& scan = imported->scene.scans().front();
      const glm::dvec4 middle(named(imported->scene, "bone").mesh->bounds().centre(), 1.0f);
      const glm::ivec3 at = glm::round(glm::dvec3(glm::inverse(scan.toLps) * middle));
      QVERIFY(glm::all(glm::greaterThanEqual(at, glm::ivec3(0))));
      QVERIFY(glm::all(glm::lessThan(at, scan.size)));
      const auto voxel = std::size_t((at.z * scan.size.y + at.y) * scan.size.x + at.x);
      QCOMPARE(scan.intensity((*scan.voxels)[voxel]), 900.0);
    }
}

/// Each fault is reported with its place.
void KeptScansTest::spoiledScenes() {
  QTemporaryDir folder;
  const std::array inputs{written(folder, "ct.nii", niftiFile(ball(), Number::int16))};
  ImportOptions options;
  options.keepScans = true;
  const auto imported = importInputs(inputs, options);
  QVERIFY(imported.ok());
  const std::string json = sceneJson(imported->scene);
  const VoxelsByName voxels{{"scans/1.scan", imported->scene.scans().front().voxels}};
  QVERIFY(sceneFromJson(*parseJson(json), {.voxels = voxels}).ok());
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
    const auto scene = sceneFromJson(*parseJson(spoiled), {.voxels = voxels});
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
void KeptScansTest::plannedAnew() {
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

void KeptScansTest::reloaded() {
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
  QVERIFY(std::abs(double(width) - 2.0 * (ballRadius + 2.0)) < 0.6);
}

void KeptScansTest::cancelled() {
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

void KeptScansTest::spoiledCopies() {
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

SLINE_TEST(KeptScansTest)
#include "test_kept_scans.moc"
