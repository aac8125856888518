// SPDX-License-Identifier: Apache-2.0
// Tests every file of the collection of formats through the import that users take: what it
// becomes, or why the message says it does not. A file of the collection without a row here is a
// failure.
#include <QDirIterator>
#include <QtTest>
#include <array>
#include <numeric>

#include "model/import/plan/import.h"
#include "tests/support/suite.h"

using namespace sline;

namespace {
QDir collection() {
  return QDir(QStringLiteral(SLINE_TEST_DATA "/formats"));
}

/// The number of triangles is then the smoothing's business, not the reader's.
constexpr int some = -1;

/// Expects that many structures and triangles; `told` is in a warning, or there is none.
void loads(const char* file, int structures, int triangles, const char* told = "") {
  QTest::newRow(file) << structures << triangles << 0 << QString(told);
}

/// Expects no surface, but that many annotations.
void marks(const char* file, int annotations, const char* told = "") {
  QTest::newRow(file) << 0 << 0 << annotations << QString(told);
}

/// Expects a refusal with a message that holds `told`.
void refused(const char* file, const char* told) {
  QTest::newRow(file) << 0 << 0 << 0 << QString(told);
}

/// Adds one surface in every encoding; test_same_mesh compares them vertex by vertex.
void sameMeshRows() {
  for (const char* encoding : {".obj",
                               ".off",
                               "_appended_lz4.vtp",
                               "_appended_lzma.vtp",
                               "_appended_none.vtp",
                               "_appended_zlib.vtp",
                               "_appended_zlib_be_uint64.vtp",
                               "_ascii.ply",
                               "_ascii.stl",
                               "_ascii_none.vtp",
                               "_binary.stl",
                               "_binary_be.ply",
                               "_binary_le.ply",
                               "_binary_lz4.vtp",
                               "_binary_lzma.vtp",
                               "_binary_none.vtp",
                               "_binary_zlib.vtp",
                               "_legacy42_ascii.vtk",
                               "_legacy42_binary.vtk",
                               "_legacy42_binary_strips_normals.vtk",
                               "_legacy51_ascii.vtk",
                               "_legacy51_binary.vtk"})
    loads((QByteArray("same_mesh/adrenal") + encoding).constData(), 1, 1538);
}

void meshRows() {
  refused("online3dviewer/CubeHierarchy.gltf", "'CubeHierarchy.bin', which cannot be read");
  loads("online3dviewer/SimpleMeshes.gltf", 2, 2);
  loads("online3dviewer/SimpleSparseAccessor.gltf", 1, 12);
  loads("online3dviewer/TriangleWithoutIndices.gltf", 1, 1);
  loads("online3dviewer/cube_meshlab_binary.ply", 1, 12);
  loads("online3dviewer/cube_rgb_binary.ply", 1, 12);
  loads("online3dviewer/cube_with_materials.obj", 1, 12);
  loads("online3dviewer/hundred_cubes.obj", 100, 1200);
  refused("online3dviewer/lines_in_meshes.obj", "only lines or points");
  loads("online3dviewer/properties.glb", 3, 36);
  loads("online3dviewer/rectangle_vertex_colors_float.off", 1, 2);
  loads("online3dviewer/rectangle_vertex_colors_int.off", 1, 2);
  loads("online3dviewer/rhombicuboctahedron.3mf", 1, 44);
  loads("online3dviewer/single_triangle_negative_indices.obj", 1, 1);
  loads("online3dviewer/single_triangle_no_normal.stl", 1, 1);
  loads("online3dviewer/single_triangle_with_comments.off", 1, 1);
  loads("online3dviewer/single_triangle_with_comments.ply", 1, 1);
  loads("online3dviewer/single_triangle_with_comments.stl", 1, 1);
  loads("online3dviewer/solids.obj", 5, 80);
  loads("online3dviewer/stl_ascii.stl", 1, 572);
  loads("online3dviewer/stl_binary.stl", 1, 728);
  loads("online3dviewer/two_meshes_with_same_name.obj", 2, 2);
  loads("pmp/edge_onering.off", 1, 10);
  loads("pmp/fandisk_quads.off", 1, 1528);
  loads("pmp/hole_capsule.off", 1, 152);
  loads("pmp/icosahedron_ascii.stl", 1, 20);
  loads("pmp/icosahedron_binary.stl", 1, 20);
}

void volumeRows() {
  loads("nrrd/BallBinary30x30x30.nhdr", 1, 8592);
  loads("nrrd/BallBinary30x30x30.nii.gz", 1, 8592);
  loads("nrrd/BallBinary30x30x30.nrrd", 1, 8592);
  refused("nrrd/BallBinary30x30x30.raw", "not supported");
  refused("nrrd/BallBinary30x30x30_byteskip_minus_five.nhdr",
          "'-5' is neither a number of bytes nor -1");
  loads("nrrd/BallBinary30x30x30_byteskip_minus_one.nhdr", 1, 8592);
  loads("nrrd/BallBinary30x30x30_byteskip_minus_one_nifti.nhdr", 1, 8592);
  loads("nrrd/BallBinary30x30x30_bz2.nrrd", 1, 8592);
  loads("nrrd/BallBinary30x30x30_gz.nrrd", 1, 8592);
  loads("nrrd/BallBinary30x30x30_gz_byteskip_minus_one.nrrd", 1, 8592);
  loads("nrrd/BallBinary30x30x30_gz_lineskip.nrrd", 1, 8592);
  loads("nrrd/BallBinary30x30x30_nifti.nhdr", 1, 8592, "header was passed over");
  refused("nrrd/test1d_ascii.nrrd", "has 1 axis");
  refused("nrrd/test2d_ascii.nrrd", "has 2 axes");
  refused("nrrd/test_customFields.nrrd", "has 1 axis");
  refused("nrrd/test_simple4d_raw.nrrd", "not whole numbers");
  refused("dicom/ct.0.dcm", "1 CT image holds no segmentation");
  refused("dicom/ct_image.dcm", "1 CT image holds no segmentation");
  loads("dicom/rtss.dcm", 9, some, "\"Areola\": has no contour");
  loads("dicom/seg_image_ct_binary.dcm", 1, some);
}

void slicerRows() {
  marks("slicer/AnnotationFiducialsTest.mrml", 7, "AnnotationROI were left out");
  refused("slicer/NonLinearTransformScene.mrml", "holds no model");
  refused("slicer/TestData/ColorTest.ctbl", "not supported");
  refused("slicer/TestData/PentaHexa.vtk", "'UNSTRUCTURED_GRID', not POLYDATA");
  loads("slicer/TestData/cube.vtk", 1, 12);
  loads("slicer/TestData/cube.vtp", 1, 12);
  refused("slicer/TestData/deform2x2x2_ras.nrrd", "holds 'vector' in each voxel");
  loads("slicer/TestData/sphere.vtk", 1, 96);
  loads("slicer/TestData/sphere.vtp", 1, 96);
  loads("slicer/backward_compat_light_box_scene.mrml", 1, 12);
  loads("slicer/clipCube.mrml", 1, 12);
  refused("slicer/cube-utf8.mrml", "holds no model");
  loads("slicer/cube.mrml", 1, 12);
  loads("slicer/cube_made_by_zipping.mrb", 1, 12);
  refused("slicer/helixMask3Labels.mrml", "holds no model");
  loads("slicer/hier_test.mrml", 1, 96);
  loads("slicer/modelHierarchy.mrml", 2, 108);
  refused("slicer/restoreSceneSnapshotCompareView.mrml", "holds no model");
  marks("slicer/slicer3.fcsv", 56);
  loads("slicer/vol_and_cube.mrml", 1, 12, "absent volumes");
  refused("slicer/volumetric_mesh.mrml", "'UNSTRUCTURED_GRID', not POLYDATA");
}

void textRows() {
  for (const char* file : {"README.txt", "LICENSE.txt", "dicom/LICENSE.txt", "nrrd/LICENSE.txt",
                           "online3dviewer/LICENSE.txt", "pmp/LICENSE.txt", "same_mesh/LICENSE.txt",
                           "slicer/LICENSE.txt"})
    refused(file, "not supported");
}

std::size_t triangleCount(const model::Scene& scene) {
  const auto& nodes = scene.nodes();
  return std::accumulate(nodes.begin(), nodes.end(), std::size_t(0),
                         [](std::size_t sum, const model::Node& node) {
                           return sum + (node.mesh ? node.mesh->triangleCount() : 0);
                         });
}

QString warnings(const model::Imported& imported) {
  QString text;
  for (const model::ImportWarning& warning : imported.report.warnings)
    text += QString::fromStdString(warning.file + ": " + warning.reason) + '\n';
  return text;
}
}  // namespace

class EveryFormatTest : public QObject {
  Q_OBJECT
 private slots:
  void formats_data() {
    QTest::addColumn<int>("structures");
    QTest::addColumn<int>("triangles");
    QTest::addColumn<int>("annotations");
    QTest::addColumn<QString>("told");
    sameMeshRows();
    meshRows();
    volumeRows();
    slicerRows();
    textRows();
    if (!collection().exists())
      return;
    QDirIterator it(collection().path(), QDir::Files, QDirIterator::Subdirectories);
    while (it.hasNext())
      m_there.insert(collection().relativeFilePath(it.next()));
  }

  void formats() {
    const QString name = QTest::currentDataTag();
    if (!collection().exists())
      SLINE_ABSENT("the folder formats of the test data is absent");
    QFETCH(int, structures);
    QFETCH(int, triangles);
    QFETCH(int, annotations);
    QFETCH(QString, told);
    QVERIFY2(m_there.remove(name), "the table has a file that is not there");
    const std::array inputs{std::filesystem::path(collection().filePath(name).toStdString())};
    model::ImportOptions options;
    options.smoothing.mode = model::Smoothing::Mode::off;
    const Result<model::Imported> imported = model::importInputs(inputs, options);
    if (structures + annotations == 0) {
      QVERIFY2(!imported.ok(), "it came in");
      const Error& error = imported.error();
      QVERIFY2(error.text().find(told.toStdString()) != std::string::npos, error.text().c_str());
      QVERIFY(!error.remedy.empty() || error.text().find(". ") != std::string::npos);
      return;
    }
    QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
    QCOMPARE(int(imported->scene.structuresBelow(model::rootId).size()), structures);
    QCOMPARE(int(imported->scene.annotations().size()), annotations);
    if (triangles == some)
      QVERIFY(triangleCount(imported->scene) > 0);
    else
      QCOMPARE(int(triangleCount(imported->scene)), triangles);
    const QString all = warnings(*imported);
    QVERIFY2(told.isEmpty() ? all.isEmpty() : all.contains(told), qPrintable(all));
  }

  void noneIsForgotten() {
    const QStringList left = m_there.values();
    QVERIFY2(left.isEmpty(), qPrintable("without a row: " + left.join(", ")));
  }

 private:
  QSet<QString> m_there;
};

SLINE_TEST_WITH_EVENTS(EveryFormatTest)
#include "test_every_format.moc"
