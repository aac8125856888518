// SPDX-License-Identifier: Apache-2.0
// Tests the parts of the readers one by one: strips, indices, groups, glTF's accessors and
// transforms.
#include <QDir>
#include <QFile>
#include <QTest>
#include <glm/geometric.hpp>

#include "tests/model/import/readers/mesh_files.h"
#include "tests/model/import/readers/read_triangles.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using model::Triangle;

namespace {
constexpr std::endian little = std::endian::little;

/// Returns four vertices and a list of strips as PLY text.
QByteArray plyStrips(const QByteArray& list) {
  return "ply\nformat ascii 1.0\nelement vertex 6\nproperty uchar red\nproperty double z\n"
         "property double x\nproperty double y\nelement extra 1\nproperty list uchar float f\n"
         "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
         "9 0 0 0\n9 0 1 0\n9 0 0 1\n9 0 1 1\n9 0 0 2\n9 0 1 2\n2 0.5 0.5\n" +
         list + '\n';
}

/// Returns one triangle of glTF with things added to its node, its material and its positions.
QByteArray gltfTriangle(const QByteArray& nodes, const QByteArray& primitive,
                        const QByteArray& extra = {}) {
  QByteArray buffer;
  for (const float x :
       {0.f, 0.f, 0.f, 9.f, 1.f, 0.f, 0.f, 9.f, 0.f, 1.f, 0.f, 9.f, 1.f, 1.f, 0.f, 9.f})
    append(buffer, x, little);
  return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[)" + nodes +
         R"(],"meshes":[{"name":"flat","primitives":[{"attributes":{"POSITION":0})" + primitive +
         R"(}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}],)"
         R"("bufferViews":[{"buffer":0,"byteLength":64,"byteStride":16}],)" +
         extra + R"("buffers":[{"byteLength":64,"uri":"data:;base64,)" + buffer.toBase64() +
         R"("}]})";
}
}  // namespace

class TestReaderDetails : public QObject {
  Q_OBJECT

 private slots:
  void plyTristrips() {
    const std::vector<Triangle> one = {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}};
    QCOMPARE(trianglesOf(".ply", plyStrips("6 0 1 2 3 4 5")), one);
    const std::vector<Triangle> two = {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}};
    QCOMPARE(trianglesOf(".ply", plyStrips("8 0 1 2 3 -1 2 3 4")), two);
    QCOMPARE(trianglesOf(".ply", plyStrips("9 -1 0 1 2 3 -1 2 3 4")), two);
  }

  void objIndices() {
    const QByteArray vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    const std::vector<Triangle> quad = {{0, 1, 2}, {0, 2, 3}};
    QCOMPARE(trianglesOf(".obj", vertices + "f 1 2 3 4\n"), quad);
    QCOMPARE(trianglesOf(".obj", vertices + "f -4 -3 -2 -1\n"), quad);
    QCOMPARE(trianglesOf(".obj", vertices + "f 1/1 2/1 3/1 4/1\n"), quad);
    QCOMPARE(trianglesOf(".obj", vertices + "f 1//1 2//1 3//1 4//-1 # quad\n"), quad);
    QCOMPARE(trianglesOf(".obj", vertices + "f 1/2/3 2/2/3 \\\n 3/2/3 4/2/3"), quad);
    QCOMPARE(trianglesOf(".obj", "f 1 2 3 4\n" + vertices), quad);
    QCOMPARE(trianglesOf(".obj", QByteArray(vertices + "f 1 2 3 4\n").replace("\n", "\r\n")), quad);
    QCOMPARE(trianglesOf(".obj", QByteArray(vertices + "f 1 2 3 4\n").replace("\n", "\r")), quad);
    QCOMPARE(trianglesOf(".obj", "\xef\xbb\xbf" + vertices + "\tf\t1 2 3  4  \n"), quad);
    // Relative indices count from the vertices read so far.
    const std::vector<Triangle> first = {{0, 1, 2}};
    QCOMPARE(trianglesOf(".obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 5 5 5\n"), first);
  }

  void objGroups() {
    QTemporaryDir folder;
    const auto read =
        readBytes(folder, "groups.obj",
                  "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 9 9 9\nv 0 0 1\nf 1 2 3\n"
                  "o body\ng left part\nf 3 2 5\ng\ng left part\nf 1 2 5\no other\nf 1 3 5\n");
    QVERIFY(read);
    QCOMPARE(read->meshes.size(), std::size_t(4));
    QVERIFY(read->meshes[0].name.empty() && read->meshes[0].groups.empty());
    QCOMPARE(read->meshes[1].name, std::string("left part"));
    QCOMPARE(read->meshes[1].groups, std::vector<std::string>{"body"});
    QCOMPARE(read->meshes[2].name, std::string("left part"));
    QCOMPARE(read->meshes[3].name, std::string("other"));
    QVERIFY(read->meshes[3].groups.empty());
    // A group has only the vertices that it uses, in the file's order.
    QCOMPARE(read->meshes[1].positions.size(), std::size_t(3));
    QCOMPARE(read->meshes[1].positions[0], glm::vec3(1, 0, 0));
    QCOMPARE(read->meshes[1].positions[2], glm::vec3(0, 0, 1));
    QCOMPARE(read->meshes[1].triangles[0], (Triangle{1, 0, 2}));
  }

  void stlSolids() {
    QTemporaryDir folder;
    const auto read =
        readBytes(folder, "two.stl",
                  cubeFile("stl text") + cubeFile("stl text").replace("cube", "box").toUpper());
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QCOMPARE(read->meshes.size(), std::size_t(2));
    QCOMPARE(read->meshes[0].name, std::string("cube"));
    QCOMPARE(read->meshes[1].name, std::string("BOX"));
    QCOMPARE(read->meshes[1].positions.size(), std::size_t(8));
  }

  void stlWeldsZeroes() {
    QTemporaryDir folder;
    const QByteArray facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
        "vertex 0 1 0\nendloop\nendfacet\n";
    QByteArray other = facet;
    other.replace("vertex 0 0 0", "vertex -0 -0 -0").replace("0 1 0", "0 -1 0");
    const auto read = readBytes(folder, "zero.stl", "solid\n" + facet + other + "endsolid\n");
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QCOMPARE(read->meshes[0].positions.size(), std::size_t(4));
  }

  void stlBinaryThatBeginsWithSolid() {
    const QByteArray bytes =
        QByteArray("solid facet").leftJustified(80) + cubeFile("stl binary").mid(80);
    QCOMPARE(trianglesOf(".stl", bytes).size(), std::size_t(12));
  }

  void vtkStrips() {
    const QByteArray head =
        "# vtk DataFile Version 3.0\nstrips\nASCII\nDATASET POLYDATA\nPOINTS 5 double\n"
        "0 0 0 1 0 0 0 1 0 1 1 0 0 2 0\n";
    const std::vector<Triangle> wanted = {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}};
    QCOMPARE(trianglesOf(".vtk", head + "TRIANGLE_STRIPS 1 6\n5 0 1 2 3 4\n"), wanted);
    QCOMPARE(
        trianglesOf(".vtk", head.toLower().replace("datafile version", "DataFile Version") +
                                "metadata\ninformation 0\n\ntriangle_strips 1 6\n5 0 1 2 3 4\n"),
        wanted);
  }

  void vtkAttributes_data() {
    QTest::addColumn<QByteArray>("attributes");
    QTest::newRow("scalars") << QByteArray("SCALARS s int 2\nLOOKUP_TABLE default\n") +
                                    QByteArray("1 2 ").repeated(8);
    QTest::newRow("scalars without table") << "SCALARS s float\n" + QByteArray("1 ").repeated(8);
    QTest::newRow("table") << QByteArray("LOOKUP_TABLE t 2\n0 0 0 1 1 1 1 1\n");
    QTest::newRow("colours") << "COLOR_SCALARS c 3\n" + QByteArray("0.1 ").repeated(24);
    QTest::newRow("textures") << "TEXTURE_COORDINATES t 2 float\n" +
                                     QByteArray("0.5 ").repeated(16);
    QTest::newRow("vectors") << "VECTORS v double\n" + QByteArray("0.5 ").repeated(24);
    QTest::newRow("tensors") << "TENSORS v double\n" + QByteArray("0.5 ").repeated(72);
    QTest::newRow("field") << "FIELD f 2\na 1 8 float\n" + QByteArray("0.5 ").repeated(8) +
                                  "\nb 1 2 string\none two\nthree\n";
  }

  /// Attributes are walked to their end: complete ones load, cut ones are refused.
  void vtkAttributes() {
    QFETCH(QByteArray, attributes);
    QTemporaryDir folder;
    const QByteArray whole = cubeFile("vtk 4.2 text") + "POINT_DATA 8\n" + attributes;
    const auto read =
        readBytes(folder, "whole.vtk",
                  whole + "\nCELL_DATA 12\nNORMALS n float\n" + QByteArray("0 0 1 ").repeated(12));
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QCOMPARE(triangleCount(*read), std::size_t(12));
    const auto half = readBytes(folder, "cut.vtk", whole.chopped(attributes.size() / 3));
    QVERIFY(!half);
    QVERIFY(half.error().reason.find("the file ends") != std::string::npos);
  }

  void gltfTransforms() {
    QTemporaryDir folder;
    const QByteArray nodes =
        R"({"name":"a","translation":[10,0,0],"children":[1]},)"
        R"({"name":"b","rotation":[0,0,0.70710678,0.70710678],"scale":[2,2,2],"children":[2]},{"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,-1,0,0,0,3,1]})";
    const auto read = readBytes(
        folder, "t.gltf",
        gltfTriangle(
            nodes, R"(,"mode":5,"material":0)",
            R"("materials":[{"alphaMode":"BLEND","pbrMetallicRoughness":{"baseColorFactor":[1,0.21404,0,0.5]}}],)"));
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    const model::RawMesh& mesh = read->meshes.front();
    QCOMPARE(mesh.name, std::string("flat"));
    QCOMPARE(mesh.groups, (std::vector<std::string>{"a", "b"}));
    // (1, 0, 0) → matrix (1, 0, 3) → scaled and turned by 90° about z (0, 2, 6) → moved.
    QVERIFY(glm::distance(mesh.positions[1], glm::vec3(10, 2, 6)) < 1e-5f);
    QVERIFY(glm::distance(mesh.positions[2], glm::vec3(8, 0, 6)) < 1e-5f);
    // The matrix mirrors: the strip's two triangles are turned to stay outward.
    const std::vector<Triangle> wanted = {{0, 2, 1}, {2, 3, 1}};
    QCOMPARE(mesh.triangles, wanted);
    QVERIFY(mesh.colour == (Colour{255, 127, 0}));
    QCOMPARE(mesh.opacity->value(), 0.5f);
  }

  void gltfFan() {
    const std::vector<Triangle> wanted = {{0, 1, 2}, {0, 2, 3}};
    QCOMPARE(trianglesOf(".gltf", gltfTriangle(R"({"mesh":0})", R"(,"mode":6)")), wanted);
  }

  void gltfSparse() {
    QByteArray bytes = cubeFile("gltf");
    // Vertices 0 and 2 (indices from the index buffer's first two entries) take the first two
    // positions.
    bytes.replace(
        R"("count":8,)",
        R"("count":8,"sparse":{"count":2,"indices":{"bufferView":1,"componentType":5123},"values":{"bufferView":0,"byteOffset":12}},)");
    QTemporaryDir folder;
    const auto read = readBytes(folder, "sparse.gltf", bytes);
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QCOMPARE(read->meshes[0].positions[0], cubePositions()[1]);
    QCOMPARE(read->meshes[0].positions[1], cubePositions()[1]);
    QCOMPARE(read->meshes[0].positions[2], cubePositions()[2]);
  }

  void gltfExternalBuffer() {
    QTemporaryDir folder;
    QByteArray json = cubeFile("gltf");
    const qsizetype start = json.indexOf("data:");
    const qsizetype end = json.indexOf('"', start);
    const QByteArray base64 = json.mid(start, end - start).split(',').back();
    json.replace(start, end - start, "sub%20folder/cube.bin");
    QVERIFY(QDir(folder.path()).mkdir("sub folder"));
    QFile file(folder.filePath("sub folder/cube.bin"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromBase64(base64));
    file.close();
    const auto read = readBytes(folder, "outer.gltf", json);
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QCOMPARE(volume(read->meshes.front()), 6.0);
    // The same bytes through a link that leads out of the folder are refused.
    QVERIFY(QDir(folder.path()).mkdir("inner"));
    QVERIFY(QFile::link(folder.filePath("sub folder"), folder.filePath("inner/sub folder")));
    const auto linked = readBytes(folder, "inner/inner.gltf", json);
    QVERIFY(!linked &&
            linked.error().reason.find("outside the file's folder") != std::string::npos);
  }

  void gltfInstancesStayBounded() {
    QByteArray nodes = R"({"children":[)";
    for (int i = 1; i < 60000; ++i)
      nodes += (i == 1 ? "" : ",") + QByteArray::number(i);
    nodes += "]}";
    for (int i = 1; i < 60000; ++i)
      nodes += R"(,{"mesh":0})";
    QByteArray json = cubeFile("gltf");
    const qsizetype start = json.indexOf("\"nodes\":[{\"name\"");
    const qsizetype end = json.indexOf("],\"meshes\"");
    json.replace(start, end - start, "\"nodes\":[" + nodes);
    QTemporaryDir folder;
    const auto read = readBytes(folder, "many.gltf", json);
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QCOMPARE(read->meshes.size(), std::size_t(59999));
  }
};

SLINE_TEST_WITH_EVENTS(TestReaderDetails)
#include "test_reader_details.moc"
