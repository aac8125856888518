// SPDX-License-Identifier: Apache-2.0
// Tests files of other programs' test suites, and whole sets of real anatomy.
#include <QDir>
#include <QTest>

#include "tests/model/import/readers/mesh_files.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

class TestForeignFiles : public QObject {
  Q_OBJECT

  static QString dataFile(const char* name) {
    return QString(SLINE_TEST_DATA) + "/formats/" + name;
  }

 private slots:
  void readable_data() {
    QTest::addColumn<int>("meshes");
    QTest::addColumn<int>("vertices");
    QTest::addColumn<int>("triangles");
    QTest::addColumn<QString>("name");
    const auto row = [](const char* file, int meshes, int vertices, int triangles,
                        const char* name = "") {
      QTest::newRow(file) << meshes << vertices << triangles << QString(name);
    };
    row("online3dviewer/SimpleMeshes.gltf", 2, 6, 2);
    row("online3dviewer/SimpleSparseAccessor.gltf", 1, 14, 12);
    row("online3dviewer/TriangleWithoutIndices.gltf", 1, 3, 1);
    row("online3dviewer/cube_meshlab_binary.ply", 1, 8, 12);
    row("online3dviewer/cube_rgb_binary.ply", 1, 8, 12);
    row("online3dviewer/cube_with_materials.obj", 1, 8, 12, "Cube");
    row("online3dviewer/hundred_cubes.obj", 100, 800, 1200, "Mesh001");
    row("online3dviewer/properties.glb", 3, 72, 36, "Cube 1 Node");
    row("online3dviewer/rectangle_vertex_colors_float.off", 1, 4, 2);
    row("online3dviewer/rectangle_vertex_colors_int.off", 1, 4, 2);
    row("online3dviewer/single_triangle_negative_indices.obj", 1, 3, 1);
    row("online3dviewer/single_triangle_no_normal.stl", 1, 3, 1, "MeshName");
    row("online3dviewer/single_triangle_with_comments.off", 1, 3, 1);
    row("online3dviewer/single_triangle_with_comments.ply", 1, 3, 1);
    row("online3dviewer/single_triangle_with_comments.stl", 1, 3, 1, "MeshName");
    row("online3dviewer/rhombicuboctahedron.3mf", 1, 24, 44, "Rhombicuboctahedron (color)");
    // The Platonic solids as triangles give 4 + 12 + 8 + 36 + 20.
    row("online3dviewer/solids.obj", 5, 50, 80, "Tetrahedron");
    row("online3dviewer/stl_ascii.stl", 1, 304, 572, "Untitled-5427e5af");
    row("online3dviewer/stl_binary.stl", 1, 378, 728);
    row("online3dviewer/two_meshes_with_same_name.obj", 2, 6, 2, "MeshName");
    row("pmp/edge_onering.off", 1, 10, 10);
    row("pmp/fandisk_quads.off", 1, 766, 1528);
    row("pmp/hole_capsule.off", 1, 89, 152);
    row("pmp/icosahedron_ascii.stl", 1, 12, 20, "vcg");
    row("pmp/icosahedron_binary.stl", 1, 12, 20);
    row("slicer/TestData/cube.vtk", 1, 24, 12);
    row("slicer/TestData/cube.vtp", 1, 24, 12);
    row("slicer/TestData/sphere.vtk", 1, 50, 96);
    row("slicer/TestData/sphere.vtp", 1, 50, 96);
  }

  void readable() {
    const QString path = dataFile(QTest::currentDataTag());
    if (!QFile::exists(path))
      SLINE_ABSENT("the folder formats of the test data is absent");
    QFETCH(int, meshes);
    QFETCH(int, vertices);
    QFETCH(int, triangles);
    QFETCH(QString, name);
    const Result<model::RawMeshes> read = model::readSurfaces(path.toStdString());
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QCOMPARE(int(read->meshes.size()), meshes);
    QCOMPARE(int(vertexCount(*read)), vertices);
    QCOMPARE(int(triangleCount(*read)), triangles);
    QCOMPARE(QString::fromStdString(read->meshes.front().name), name);
    QVERIFY2(read->warnings.empty(), qPrintable(warningText(*read)));
    QVERIFY(isSound(*read));
    const bool slicer = path.contains("/slicer/");
    QCOMPARE(read->meshes.front().frame == model::Frame::ras, slicer);
    const bool gltf = path.endsWith(".gltf") || path.endsWith(".glb");
    QCOMPARE(read->meshes.front().frameReason.empty(), !slicer && !gltf);
  }

  void refused_data() {
    QTest::addColumn<QString>("fragment");
    QTest::newRow("online3dviewer/CubeHierarchy.gltf")
        << "'CubeHierarchy.bin', which cannot be read";
    QTest::newRow("online3dviewer/lines_in_meshes.obj") << "only lines or points";
    QTest::newRow("slicer/TestData/PentaHexa.vtk") << "'UNSTRUCTURED_GRID', not POLYDATA";
    QTest::newRow("slicer/TestData/deform2x2x2_ras.nrrd") << "which is neither label nor intensity";
    QTest::newRow("slicer/TestData/ColorTest.ctbl") << "'.ctbl' are not supported";
    QTest::newRow("slicer/cube.mrml") << "content looks like a 3D Slicer scene";
    QTest::newRow("nrrd") << "is a folder";
  }

  void refused() {
    const QString path = dataFile(QTest::currentDataTag());
    if (!QFile::exists(path))
      SLINE_ABSENT("the folder formats of the test data is absent");
    QFETCH(QString, fragment);
    const Result<model::RawMeshes> read = model::readSurfaces(path.toStdString());
    QVERIFY(!read);
    QVERIFY2(read.error().text().find(fragment.toStdString()) != std::string::npos,
             read.error().text().c_str());
    QVERIFY(!read.error().remedy.empty());
  }

  void folder_data() {
    QTest::addColumn<int>("files");
    QTest::addColumn<int>("triangles");
    // The makers of these sets give these sums.
    QTest::newRow("abdomen/Data") << 94 << 1200358;
    QTest::newRow("pelvis/bodyparts3d") << 40 << 42369;
    QTest::newRow("pelvis/hra_vh_male") << 6 << 401817;
    QTest::newRow("large") << 1 << 1074432;
  }

  void folder() {
    const QDir directory(QString(SLINE_TEST_DATA) + '/' + QTest::currentDataTag());
    if (!directory.exists())
      SLINE_ABSENT("this folder of the test data is absent");
    int files = 0;
    std::size_t triangles = 0;
    for (const QFileInfo& info : directory.entryInfoList(QDir::Files)) {
      const std::string path = info.filePath().toStdString();
      if (!model::isSurfaceFile(path) || model::isVolumeFile(path))
        continue;
      const Result<model::RawMeshes> read = model::readSurfaces(path);
      QVERIFY2(read, read ? "" : read.error().text().c_str());
      QVERIFY(isSound(*read));
      ++files;
      triangles += triangleCount(*read);
    }
    QTEST(files, "files");
    QTEST(int(triangles), "triangles");
  }
};

SLINE_TEST_WITH_EVENTS(TestForeignFiles)
#include "test_foreign_files.moc"
