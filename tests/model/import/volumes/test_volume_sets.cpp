// SPDX-License-Identifier: Apache-2.0
// Tests folders of one file per structure, as automatic segmentation writes them: together they are
// one volume.
#include <QtTest>
#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <set>

#include "model/import/plan/import.h"
#include "tests/model/import/volumes/written_volumes.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

namespace {

glm::dmat4 shifted(const glm::dvec3& by) {
  glm::dmat4 matrix(1.0);
  matrix[3] = glm::dvec4(by, 1.0);
  return matrix;
}

int ball(const glm::dvec3& p, const glm::dvec3& centre, double radius) {
  return int(glm::length(p - centre) < radius);
}

void writeMask(const QTemporaryDir& folder, const char* name,
               const std::function<int(const glm::dvec3&)>& inside,
               const glm::dvec3& origin = glm::dvec3(0.0)) {
  writeText(folder.filePath(name),
            gzipped(niftiFile(sampled(glm::ivec3(30), shifted(origin), inside))));
}

Result<Imported> importFolder(const QTemporaryDir& folder, const ImportOptions& options = {}) {
  return importInputs(std::array{std::filesystem::path(folder.path().toStdString())}, options);
}

/// Returns how many vertices two structures have at the same place.
std::size_t sharedVertices(const Scene& scene, const char* a, const char* b) {
  const auto places = [&](const char* name) {
    std::set<std::array<float, 3>> found;
    for (const glm::vec3& p : named(scene, name).mesh->positions())
      found.insert({p.x, p.y, p.z});
    return found;
  };
  const auto first = places(a);
  const auto second = places(b);
  return std::size_t(
      std::count_if(first.begin(), first.end(), [&](const auto& p) { return second.contains(p); }));
}

}  // namespace

class VolumeSetsTest : public QObject {
  Q_OBJECT
 private slots:
  void masks();
  void overlapping();
  void imageAmongThem();
  void surfacesBeside();
  void longNames();
  void nothingUsable();
};

/// Two halves of a ball in a file each touch without a gap; empty masks are reported once.
void VolumeSetsTest::masks() {
  QTemporaryDir folder;
  writeMask(folder, "liver.nii.gz",
            [](const glm::dvec3& p) { return ball(p, glm::dvec3(15.0), 9.0) * int(p.x < 15.0); });
  writeMask(folder, "kidney_right.nii.gz",
            [](const glm::dvec3& p) { return ball(p, glm::dvec3(15.0), 9.0) * int(p.x >= 15.0); });
  writeMask(folder, "spleen.nii.gz",
            [](const glm::dvec3& p) { return ball(p, glm::dvec3(4.0), 2.5); });
  writeMask(folder, "brain.nii.gz", [](const glm::dvec3&) { return 0; });
  writeMask(folder, "skull.nii.gz", [](const glm::dvec3&) { return 0; });
  const Result<Imported> imported = importFolder(folder);
  QVERIFY(imported.ok());
  QCOMPARE(imported->scene.structuresBelow(rootId).size(), std::size_t(3));
  QVERIFY(sharedVertices(imported->scene, "liver", "kidney right") > 200);
  QCOMPARE(named(imported->scene, "liver").provenance.file, std::string("liver.nii.gz"));
  QCOMPARE(named(imported->scene, "spleen").provenance.file, std::string("spleen.nii.gz"));
  QVERIFY(named(imported->scene, "liver").provenance.displacementMm > 0.1f);
  // The others are that organs are not as small as these, and that the liver lies at the left.
  QVERIFY2(imported->report.warnings.size() == std::size_t(3), qPrintable(warningsOf(*imported)));
  QVERIFY2(warningsOf(*imported).contains("other side"), qPrintable(warningsOf(*imported)));
  QVERIFY(warningsOf(*imported).contains("not as large as their names say"));
  QVERIFY(warningsOf(*imported).contains("2 masks hold nothing"));
}

/// Masks that overlap or lie on another grid are kept whole.
void VolumeSetsTest::overlapping() {
  QTemporaryDir folder;
  const auto whole = [](const glm::dvec3& p) { return ball(p, glm::dvec3(15.0), 9.0); };
  writeMask(folder, "liver.nii.gz", whole);
  writeMask(folder, "tumour.nii.gz",
            [](const glm::dvec3& p) { return ball(p, glm::dvec3(15.0), 4.0); });
  writeMask(folder, "cyst.nii.gz",
            [](const glm::dvec3& p) { return ball(p, glm::dvec3(14.0, 15.0, 20.0), 3.0); });
  writeMask(
      folder, "spleen.nii.gz",
      [](const glm::dvec3& p) { return ball(p, glm::dvec3(60.0, 15.0, 15.0), 8.0); },
      glm::dvec3(45.0, 0.0, 0.0));
  const Result<Imported> imported = importFolder(folder);
  QVERIFY(imported.ok());
  QCOMPARE(imported->scene.structuresBelow(rootId).size(), std::size_t(4));
  const auto extent = [&](const char* name) {
    return named(imported->scene, name).mesh->bounds().size();
  };
  QVERIFY(glm::length(extent("liver") - 18.0f) < 1.0f);
  QVERIFY(glm::length(extent("tumour") - 8.0f) < 1.0f);
  QVERIFY(named(imported->scene, "spleen").mesh->bounds().centre().x > 55.0f);
}

void VolumeSetsTest::imageAmongThem() {
  QTemporaryDir folder;
  writeMask(folder, "liver.nii.gz",
            [](const glm::dvec3& p) { return ball(p, glm::dvec3(15.0), 9.0); });
  writeMask(folder, "ct.nii.gz", [](const glm::dvec3& p) {
    return (int(p.x) * 31 + int(p.y) * 17 + int(p.z) * 7) % 255;
  });
  const Result<Imported> imported = importFolder(folder);
  QVERIFY(imported.ok());
  QCOMPARE(imported->scene.structuresBelow(rootId).size(), std::size_t(1));
  const auto& told = imported->report.warnings;
  QCOMPARE(std::count_if(told.begin(), told.end(),
                         [](const ImportWarning& each) { return each.file == "ct.nii.gz"; }),
           1);
  QVERIFY(warningsOf(*imported).contains("scan rather than a label volume"));
}

/// A structure that exists as a surface is not taken from the volume once more.
void VolumeSetsTest::surfacesBeside() {
  QTemporaryDir folder;
  writeMesh(folder.filePath("liver.stl"), *octahedron(glm::vec3(15.0f), 9.0f));
  writeMask(folder, "labels.nii.gz", [](const glm::dvec3& p) {
    return ball(p, glm::dvec3(15.0), 9.0) + 2 * ball(p, glm::dvec3(4.0), 2.5);
  });
  writeText(folder.filePath("labels.tsv"), "index\tname\n1\tLiver\n2\tspleen\n");
  const Result<Imported> imported = importFolder(folder);
  QVERIFY(imported.ok());
  QCOMPARE(imported->scene.structuresBelow(rootId).size(), std::size_t(2));
  QCOMPARE(named(imported->scene, "liver").mesh->triangleCount() > 0, true);
  QVERIFY(named(imported->scene, "spleen").mesh != nullptr);
  QVERIFY(warningsOf(*imported).contains("1 structure left out"));
}

/// Names are whole, or it is told that they are not.
void VolumeSetsTest::longNames() {
  const QByteArray letter("\xc3\xa4");
  for (const int bytes : {600, 1000, 1002, 9000}) {
    QTemporaryDir folder;
    writeMask(folder, "labels.nii.gz",
              [](const glm::dvec3& p) { return ball(p, glm::dvec3(15.0), 9.0); });
    const QByteArray name = letter.repeated(bytes / 2);
    writeText(folder.filePath("labels.tsv"), "index\tname\n1\t" + name + "\n");
    const Result<Imported> imported = importFolder(folder, {.keepFileNames = true});
    QVERIFY(imported.ok());
    QCOMPARE(named(imported->scene, name.left(1000).toStdString()).name.size(),
             std::size_t(std::min(bytes, 1000)));
    QCOMPARE(warningsOf(*imported).contains("longer than 1000 bytes"), bytes > 1000);
  }
}

void VolumeSetsTest::nothingUsable() {
  QTemporaryDir folder;
  writeText(folder.filePath("a.nii"), "nothing of the kind");
  writeText(folder.filePath("b.nrrd"), "nothing of the kind");
  const Result<Imported> imported = importFolder(folder);
  QVERIFY(!imported.ok());
  QVERIFY(!imported.error().reason.empty());
}

SLINE_TEST(VolumeSetsTest)
#include "test_volume_sets.moc"
