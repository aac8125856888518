// SPDX-License-Identifier: Apache-2.0
// Tests the parts of the readers one by one: strips, indices, polygons, numbers, frames, glTF's
// accessors and transforms.
#include <QDir>
#include <QFile>
#include <QTest>
#include <clocale>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "model/import/source/base64.h"
#include "model/import/source/polygon.h"
#include "model/import/source/source.h"
#include "model/import/source/surface_assembly.h"
#include "model/import/source/text_cursor.h"
#include "tests/model/import/readers/mesh_files.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using model::Triangle;

namespace {
constexpr std::endian little = std::endian::little;

std::vector<Triangle> trianglesOf(const QString& extension, const QByteArray& bytes) {
  QTemporaryDir folder;
  const Result<model::RawMeshes> read = readBytes(folder, "detail" + extension, bytes);
  if (!read)
    qWarning("%s", read.error().text().c_str());
  return read ? read->meshes.front().triangles : std::vector<Triangle>();
}

double area(std::span<const glm::vec3> p, const std::vector<Triangle>& triangles) {
  double sum = 0.0;
  for (const auto& [a, b, c] : triangles)
    sum +=
        0.5 * double((p[b].x - p[a].x) * (p[c].y - p[a].y) - (p[b].y - p[a].y) * (p[c].x - p[a].x));
  return sum;
}

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
  void stripsAlternate() {
    model::FaceList faces;
    const std::uint32_t strip[] = {0, 1, 2, 3, 3, 4, 5};
    model::addStrip(strip, faces, nullptr);
    std::vector<std::vector<std::uint32_t>> found;
    for (std::size_t i = 0; i < faces.size(); ++i)
      found.emplace_back(faces.face(i).begin(), faces.face(i).end());
    const std::vector<std::vector<std::uint32_t>> wanted = {{0, 1, 2}, {2, 1, 3}, {3, 4, 5}};
    QCOMPARE(found, wanted);
  }

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

  void polygons_data() {
    QTest::addColumn<QList<QPointF>>("corners");
    QTest::addColumn<double>("wanted");
    QTest::newRow("square") << QList<QPointF>{{0, 0}, {1, 0}, {1, 1}, {0, 1}} << 1.0;
    QTest::newRow("arrow") << QList<QPointF>{{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}} << 1.0;
    QTest::newRow("arrow from its notch")
        << QList<QPointF>{{0.5, 0.5}, {0, 2}, {0, 0}, {2, 0}} << 1.0;
    QTest::newRow("L") << QList<QPointF>{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}} << 3.0;
    QTest::newRow("with middles of sides")
        << QList<QPointF>{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}, {0, 1}} << 3.0;
    QList<QPointF> comb;
    for (int i = 0; i < 100; ++i)
      comb << QPointF(100 - i, 1.0) << QPointF(99.5 - i, 0.1);
    comb << QPointF(0, 0) << QPointF(100, 0);
    QTest::newRow("comb") << comb << -1.0;
  }

  /// No triangle of a cut turns over, and together they cover the polygon.
  void polygons() {
    QFETCH(QList<QPointF>, corners);
    QFETCH(double, wanted);
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> loop;
    for (const QPointF& p : corners) {
      loop.push_back(std::uint32_t(positions.size()));
      positions.emplace_back(p.x(), p.y(), 7.0);
    }
    double outline = 0.0;
    for (qsizetype i = 0; i < corners.size(); ++i) {
      const QPointF& a = corners[i];
      const QPointF& b = corners[(i + 1) % corners.size()];
      outline += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    if (wanted > 0.0)
      QCOMPARE(outline, wanted);
    for (int turn = 0; turn < 2; ++turn) {
      std::vector<Triangle> triangles;
      model::cutPolygon(loop, positions, triangles);
      QCOMPARE(triangles.size(), loop.size() - 2);
      double unsignedArea = 0.0;
      for (const Triangle& t : triangles)
        unsignedArea += std::abs(area(positions, {t}));
      const double sign = turn == 0 ? 1.0 : -1.0;
      QVERIFY(std::abs(area(positions, triangles) - sign * outline) < 1e-4);
      QVERIFY(std::abs(unsignedArea - std::abs(outline)) < 1e-4);
      std::reverse(loop.begin(), loop.end());
    }
  }

  void longPolygonsEndSoon() {
    QByteArray text = "OFF\n40000 1 0\n";
    QByteArray face = "40000";
    for (int i = 0; i < 40000; ++i) {
      text += QByteArray::number(std::cos(i * 0.1) * (1 + i % 2)) + ' ' +
              QByteArray::number(std::sin(i * 0.1)) + " 0\n";
      face += ' ' + QByteArray::number(i);
    }
    QCOMPARE(trianglesOf(".off", text + face + '\n').size(), std::size_t(39998));
  }

  void numbers_data() {
    QTest::addColumn<bool>("good");
    QTest::addColumn<float>("value");
    const auto row = [](const char* text, bool good, float value = 0.0f) {
      QTest::newRow(text) << good << value;
    };
    row("1", true, 1.0f);
    row("+1.5", true, 1.5f);
    row("-.5e1", true, -5.0f);
    row("1.", true, 1.0f);
    row("1e-60", true, 0.0f);
    row("0.00000000000000000000000000000000000000000000000000000000000001", true, 0.0f);
    row("16777217", true, 16777216.0f);
    row("1,5", false);
    row("1.5x", false);
    row("+-1", false);
    row("--1", false);
    row("", false);
    row("one", false);
    row("0x10", false);
  }

  void numbers() {
    QFETCH(bool, good);
    const std::string text = QTest::currentDataTag();
    model::TextCursor at(text);
    float value = 0.0f;
    QCOMPARE(at.number(value), good);
    if (good) {
      QTEST(value, "value");
      QVERIFY(at.atEnd());
    } else {
      QVERIFY(at.at() == text.data());
    }
  }

  void notFinite_data() {
    QTest::addColumn<bool>("dummy");
    for (const char* text : {"nan", "NaN", "-nan", "inf", "-Inf", "+inf", "INFINITY", "1e39",
                             "-1e400", "1.#INF", "-1.#IND", "1.#QNAN"})
      QTest::newRow(text) << true;
  }

  void notFinite() {
    model::TextCursor at{std::string_view(QTest::currentDataTag())};
    float value = 0.0f;
    QVERIFY(at.number(value));
    QVERIFY(!std::isfinite(value));
    QVERIFY(at.atEnd());
  }

  void localeChangesNothing() {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    bool found = false;
    for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE", "fr_FR", "ru_RU.UTF-8"})
      found = found || std::setlocale(LC_ALL, name) != nullptr;
    if (!found)
      QSKIP("no locale with decimal commas is installed");
    for (const MeshFile& file : cubeFiles()) {
      QTemporaryDir folder;
      const auto read = readBytes(folder, QString("cube") + file.extension, file.bytes);
      QVERIFY2(read && volume(read->meshes.front()) == 6.0, file.kind);
    }
    std::setlocale(LC_ALL, before.c_str());
  }

  void base64() {
    QCOMPARE(model::decodeBase64("U2xpbmU="), std::optional<std::string>("Sline"));
    QCOMPARE(model::decodeBase64("U2xp\n bmU"), std::optional<std::string>("Sline"));
    QCOMPARE(model::decodeBase64(""), std::optional<std::string>(""));
    QVERIFY(!model::decodeBase64("U2xp*mU="));
    QVERIFY(!model::decodeBase64("U2xpb"));
    QVERIFY(!model::decodeBase64("U2=xpbmU"));
    QCOMPARE(model::decodeBase64Prefix("U2xpbmU=####", 5), std::optional<std::string>("Sline"));
    QVERIFY(!model::decodeBase64Prefix("U2xpbmU=", 6));
  }

  void frames_data() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("obj") << ".obj"
                         << "# SPACE=@\n" + cubeFile("obj");
    QTest::newRow("stl text")
        << ".stl" << cubeFile("stl text").replace("solid cube", "solid 3D Slicer output. SPACE=@");
    QTest::newRow("stl binary") << ".stl"
                                << QByteArray("3D Slicer output. SPACE=@").leftJustified(78) +
                                       cubeFile("stl binary").mid(80);
    QTest::newRow("ply")
        << ".ply"
        << cubeFile("ply big endian")
               .replace("ply\n", "ply\ncomment SPACE=@\n")
               .replace("comment SPACE=@\nformat binary_big_endian 1.0",
                        "format binary_big_endian 1.0\ncomment 3D Slicer output. SPACE=@");
    QTest::newRow("off") << ".off" << cubeFile("off").replace("OFF\n", "OFF\n# SPACE=@\n");
    QTest::newRow("vtk title")
        << ".vtk" << cubeFile("vtk 4.2 text").replace("\ncube\n", "\n3D Slicer output. SPACE=@\n");
    QTest::newRow("vtk field")
        << ".vtk"
        << cubeFile("vtk 4.2 text")
               .replace("POINTS 8",
                        "FIELD FieldData 2\na 2 2 int\n1 2 3 4\nSPACE 1 1 string\n@\nPOINTS 8");
    QTest::newRow("vtk binary field")
        << ".vtk"
        << cubeFile("vtk 5.1 binary")
               .replace("POINTS 8",
                        QByteArray("FIELD FieldData 1\nSPACE 1 1 string\n\xc3@\nPOINTS 8"));
    QTest::newRow("vtp") << ".vtp"
                         << cubeFile("vtp binary")
                                .replace(
                                    "<PolyData>",
                                    "<PolyData><FieldData><DataArray type=\"Float32\" Name=\"t\" "
                                    "NumberOfTuples=\"1\" format=\"ascii\">1</DataArray>"
                                    "<Array type=\"String\" Name=\"SPACE\" NumberOfTuples=\"1\" "
                                    "format=\"ascii\">#</Array></FieldData>");
  }

  void frames() {
    QFETCH(QString, extension);
    QFETCH(QByteArray, bytes);
    QTemporaryDir folder;
    for (const auto& [name, codes, frame] : {std::tuple("LPS", "76 80 83 0", model::Frame::lps),
                                             std::tuple("RAS", "82 65 83 0", model::Frame::ras)}) {
      QByteArray named = bytes;
      named.replace("SPACE=@", QByteArray("SPACE=") + name)
          .replace("\n@\n", QByteArray("\n") + name + "\n");
      named.replace("\xc3@\n", QByteArray("\xc3") + name + "\n")
          .replace(">#<", QByteArray(">") + codes + "<");
      const auto read = readBytes(folder, "frame" + extension, named);
      QVERIFY2(read, read ? "" : read.error().text().c_str());
      QVERIFY(read->meshes.front().frame == frame);
      QVERIFY(read->meshes.front().frameReason.starts_with("SPACE in"));
      QCOMPARE(read->meshes.front().triangles.size(), std::size_t(12));
    }
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
