// SPDX-License-Identifier: Apache-2.0
// Tests surfaces of programs for brains: of FreeSurfer, with the names of its numbers, and of
// GIFTI.
#include <QtTest>
#include <glm/matrix.hpp>

#include "model/import/plan/import.h"
#include "model/import/volumes/formats/free_surfer_labels.h"
#include "tests/model/import/readers/mesh_files.h"
#include "tests/model/import/volumes/plain_import.h"
#include "tests/model/import/volumes/written_brain.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

namespace {

namespace fs = std::filesystem;

}  // namespace

class BrainSurfacesTest : public QObject {
  Q_OBJECT
 private slots:
  void freeSurferNumbers();
  void freeSurferSurfaces();
  void giftiEncodings_data();
  void giftiEncodings();
  void giftiPlaces();
  void giftiRefused();
  void surfacesOfAFolder();
};

/// FreeSurfer's numbers are believed if the volume is FreeSurfer's, and nowhere else.
void BrainSurfacesTest::freeSurferNumbers() {
  const auto namesOf = [](std::initializer_list<int> values, const char* file) {
    LabelVolume volume;
    for (const int value : values)
      volume.labels.push_back({value, {}, {}, {}});
    return freeSurferLabels(volume, file);
  };
  QCOMPARE(namesOf({17}, "aseg.mgz").at(17).name, std::string("left hippocampus"));
  QCOMPARE(namesOf({1}, "sub_aparc+aseg.nii.gz").at(2035).name,
           std::string("right insular cortex"));
  QVERIFY(namesOf({1, 2, 3, 4, 5}, "labels.mgz").empty());
  QVERIFY(namesOf({2, 3, 41, 42, 99}, "labels.mgz").empty());
  QVERIFY(!namesOf({2, 3, 41, 42}, "ribbon.mgz").empty());
  QVERIFY(!namesOf({2, 41, 11'101}, "all.mgz").empty());
  // Every name with a side has the number of its side.
  const LabelNames all = namesOf({}, "aseg");
  QCOMPARE(all.size(), std::size_t(117));
  for (const auto& [number, label] : all) {
    QVERIFY2(label.colour, label.name.c_str());
    const bool left = label.name.starts_with("left ");
    if (left || label.name.starts_with("right "))
      QCOMPARE(left,
               number < 41 || number == 78 || number == 81 || (number > 1000 && number < 2000));
  }
}

/// A surface's places count from the middle of its volume, along the axes of coronal slices.
void BrainSurfacesTest::freeSurferSurfaces() {
  QTemporaryDir folder;
  const glm::dmat3 coronal({-1, 0, 0}, {0, 0, -1}, {0, 1, 0});
  const auto read = [&](const char* name, const QByteArray& bytes) {
    writeText(folder.filePath(name), bytes);
    return importOf({inFolder(folder, name)});
  };
  const auto middle = [](const Result<Imported>& imported, const char* name) {
    const MeshPtr mesh = named(imported->scene, name).mesh;
    return mesh ? mesh->bounds().centre() : glm::vec3(99.0f);
  };
  const Result<Imported> pial =
      read("lh.pial", freeSurferCube(freeSurferGeometry(coronal, {5, -7, 11})));
  QVERIFY2(pial.ok(), pial.ok() ? "" : pial.error().text().c_str());
  QCOMPARE(middle(pial, "left pial surface"), glm::vec3(-5.0f, 7.0f, 11.0f));
  QVERIFY2(pial->report.warnings.empty(), qPrintable(warningsOf(*pial)));
  // A volume turned by a quarter about the long axis turns its surface.
  QByteArray longCube = freeSurferCube();
  const glm::dmat3 turned({0, -1, 0}, {0, 0, -1}, {-1, 0, 0});
  const Result<Imported> turn = read("rh.white", longCube + freeSurferGeometry(turned, {0, 0, 0}));
  QCOMPARE(middle(turn, "right white matter surface"), glm::vec3(0.0f));
  const Result<Imported> placeless = read("rh.pial", longCube);
  QVERIFY(warningsOf(*placeless).contains("does not say where the volume lies"));
  QCOMPARE(middle(placeless, "right pial surface"), glm::vec3(0.0f));
  for (const auto& [bytes, told] :
       {std::pair<QByteArray, const char*>{QByteArray("\xff\xff\xff", 3) + longCube.mid(3),
                                           "quadrangles"},
        {"written by hand\n\n", "does not begin like"},
        {longCube.chopped(1), "triangles, more than"},
        {longCube.left(60), "vertices, more than"}}) {
    const Result<Imported> refused = read("lh.orig", bytes);
    QVERIFY2(!refused.ok(), told);
    QVERIFY2(refused.error().text().find(told) != std::string::npos,
             refused.error().text().c_str());
  }
}

void BrainSurfacesTest::giftiEncodings_data() {
  QTest::addColumn<QByteArray>("bytes");
  for (const char* encoding : {"ASCII", "Base64Binary", "GZipBase64Binary"})
    for (const std::endian order : {std::endian::little, std::endian::big})
      for (const bool columnsFirst : {false, true})
        QTest::addRow("%s %s %s", encoding, order == std::endian::big ? "big" : "little",
                      columnsFirst ? "columns" : "rows")
            << giftiCube({.encoding = encoding, .order = order, .columnsFirst = columnsFirst});
}

void BrainSurfacesTest::giftiEncodings() {
  QFETCH(QByteArray, bytes);
  QTemporaryDir folder;
  for (const auto& [name, stored] : {std::pair<const char*, QByteArray>{"a.surf.gii", bytes},
                                     {"a.surf.gii.gz", gzipped(bytes)}}) {
    const Result<RawMeshes> read = readBytes(folder, name, stored);
    QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
    const RawMesh& mesh = read->meshes.at(0);
    QVERIFY(std::equal(mesh.positions.begin(), mesh.positions.end(), cubePositions().begin(),
                       cubePositions().end()));
    QVERIFY(std::equal(mesh.triangles.begin(), mesh.triangles.end(), cubeTriangles().begin(),
                       cubeTriangles().end()));
    QCOMPARE(mesh.frame, std::optional(Frame::ras));
  }
}

/// Unknown coordinates follow a matrix to the scanner's; they follow none to an atlas, nor do known
/// ones follow any.
void BrainSurfacesTest::giftiPlaces() {
  QTemporaryDir folder;
  const QByteArray shift = "1 0 0 5 0 1 0 -7 0 0 1 11 0 0 0 1";
  const auto middle = [&](const GiftiForm& form) {
    const Result<RawMeshes> read = readBytes(folder, "a.surf.gii", giftiCube(form));
    Box box;
    for (const glm::vec3& p : read->meshes.at(0).positions)
      box.add(p);
    return box.centre();
  };
  QCOMPARE(middle({.space = "NIFTI_XFORM_UNKNOWN", .matrix = shift}), glm::vec3(5, -7, 11));
  QCOMPARE(
      middle({.space = "NIFTI_XFORM_UNKNOWN", .toSpace = "NIFTI_XFORM_TALAIRACH", .matrix = shift}),
      glm::vec3(0.0f));
  QCOMPARE(middle({.matrix = shift}), glm::vec3(0.0f));
  QCOMPARE(middle({.space = "NIFTI_XFORM_UNKNOWN", .matrix = "-" + shift}), glm::vec3(0.0f));
  for (const auto& [name, anatomy] :
       {std::pair<const char*, const char*>{"sub-01_hemi-L_pial.surf.gii", ""},
        {"lh.pial.gii", ""},
        {"100307.L.pial.32k_fs_LR.surf.gii", ""},
        {"pial.surf.gii", "CortexLeft"}}) {
    const Result<RawMeshes> read = readBytes(folder, name, giftiCube({.anatomy = anatomy}));
    QCOMPARE(read->meshes.at(0).name, std::string("left pial surface"));
  }
}

void BrainSurfacesTest::giftiRefused() {
  QTemporaryDir folder;
  const auto told = [&](const QByteArray& bytes) {
    const Result<RawMeshes> read = readBytes(folder, "a.gii", bytes);
    return read.ok() ? QString() : QString::fromStdString(read.error().text());
  };
  const QByteArray cube = giftiCube();
  QVERIFY(told(giftiCube({.intent = "NIFTI_INTENT_SHAPE"})).contains("without vertices"));
  QVERIFY(told("<GIFTI><DataArray Intent=\"NIFTI_INTENT_LABEL\"/></GIFTI>").contains("no surface"));
  QVERIFY(told(giftiCube({.encoding = "ExternalFileBinary"})).contains("file of its own"));
  QVERIFY(told(QByteArray(cube).replace("Dim0=\"8\"", "Dim0=\"8000000\"")).contains("promises"));
  QVERIFY(told(QByteArray(cube).replace("Dim1=\"3\"", "Dim1=\"2\"")).contains("three numbers"));
  QVERIFY(told(cube.left(cube.size() / 2)).contains("ends"));
  QVERIFY(told(QByteArray(cube).replace("FLOAT32", "RGB24")).contains("type"));
  QVERIFY(told("<x/>").contains("GIFTI"));
}

/// In a folder, surfaces that are no anatomy and other programs' files are passed over; a file that
/// is named is read.
void BrainSurfacesTest::surfacesOfAFolder() {
  QTemporaryDir folder;
  for (const char* name : {"lh.pial", "rh.pial", "lh.inflated", "rh.sphere"})
    writeText(folder.filePath(name), freeSurferCube(freeSurferGeometry(glm::dmat3(1.0), {})));
  writeText(folder.filePath("old.orig"), "a file that was kept");
  writeText(folder.filePath("a.L.white.surf.gii"), giftiCube());
  writeText(folder.filePath("a.L.very_inflated.surf.gii"), giftiCube());
  writeText(folder.filePath("a.L.aparc.label.gii"), "<GIFTI></GIFTI>");
  const Result<Imported> imported = importOf({folder.path().toStdString()});
  QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
  QCOMPARE(imported->scene.structuresBelow(rootId).size(), std::size_t(3));
  QVERIFY2(imported->report.warnings.empty(), qPrintable(warningsOf(*imported)));
  QVERIFY(importOf({inFolder(folder, "lh.inflated")}).ok());
}

SLINE_TEST(BrainSurfacesTest)
#include "test_brain_surfaces.moc"
