// SPDX-License-Identifier: Apache-2.0
// Tests files broken on purpose: each must be refused, or mended with a warning, by a message that
// says what is wrong.
#include <QDir>
#include <QFile>
#include <QTest>
#include <limits>

#include "tests/model/import/readers/refusals.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

namespace {
/// Returns a flat grid of 16 × 16 quads with one vertex and one kind of face to spoil.
QByteArray gridOff(const QByteArray& oneVertex, const QByteArray& oneFace) {
  QByteArray text = "OFF\n289 512 0\n";
  for (int i = 0; i < 289; ++i)
    text +=
        i == 0 ? oneVertex : QByteArray::number(i % 17) + ' ' + QByteArray::number(i / 17) + " 0\n";
  for (int i = 0; i < 256; ++i) {
    const int v = i % 16 + i / 16 * 17;
    const auto face = [](int a, int b, int c) {
      return "3 " + QByteArray::number(a) + ' ' + QByteArray::number(b) + ' ' +
             QByteArray::number(c) + '\n';
    };
    text += face(v, v + 1, v + 18);
    text += i == 255 ? oneFace : face(v, v + 18, v + 17);
  }
  return text;
}

constexpr std::endian little = std::endian::little;
constexpr std::endian big = std::endian::big;
const float notANumber = std::numeric_limits<float>::quiet_NaN();
}  // namespace

class TestBrokenFiles : public QObject {
  Q_OBJECT

  static void addGeneral() {
    struct Row {
      const char* extension;
      const char* zeros;
      const char* prose;
    };
    static const Row rows[] = {{".obj", "not a statement of an OBJ", "not a statement of an OBJ"},
                               {".stl", "no triangles", "neither begins with 'solid' nor"},
                               {".ply", "does not begin with 'ply'", "does not begin with 'ply'"},
                               {".off", "does not begin with 'OFF'", "does not begin with 'OFF'"},
                               {".vtk", "does not begin with '# vtk", "does not begin with '# vtk"},
                               {".vtp", "no element VTKFile", "no element VTKFile"},
                               {".gltf", "not valid JSON", "not valid JSON"},
                               {".glb", "not valid JSON", "not valid JSON"}};
    for (const auto& [extension, zeros, prose] : rows) {
      addRefusal(QString("empty ") + extension, extension, {}, "is empty");
      addRefusal(QString("a picture as ") + extension, extension,
                 QByteArray("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\1\0\0\0\1\0\x08\x02\0\0\0", 26) +
                     QByteArray(200, '\x5a'),
                 "looks like PNG");
      addRefusal(QString("zeros as ") + extension, extension, QByteArray(4096, '\0'), zeros);
      addRefusal(QString("prose as ") + extension, extension,
                 QByteArray("It was the best of times,\nit was the worst of times.\n").repeated(20),
                 prose);
    }
    addRefusal("ply as obj", ".obj", cubeFile("ply text"), "looks like PLY");
    addRefusal("obj as off", ".off", cubeFile("obj").mid(7), "looks like OBJ");
    addRefusal("vtk as vtp", ".vtp", cubeFile("vtk 4.2 text"), "looks like legacy VTK");
    addRefusal("vtp as vtk", ".vtk", cubeFile("vtp text"), "looks like VTP");
    addRefusal("text stl as ply", ".ply", cubeFile("stl text"), "looks like STL");
    addRefusal("glb as stl", ".stl", cubeFile("glb"), "looks like GLB");
    addRefusal("off as gltf", ".gltf", cubeFile("off"), "looks like OFF");
    addRefusal("gltf as obj", ".obj", cubeFile("gltf"), "looks like glTF");
    addRefusal("no extension", "", cubeFile("obj"), "looks like OBJ");
    addRefusal("unknown extension", ".max", cubeFile("obj"), "'.max' are not supported");
  }

  static void addObj() {
    addRefusal("obj vertices only", ".obj", cut("obj", 0.5), "no faces");
    addRefusal("obj two coordinates", ".obj", edited("obj", "v 0.5 -0.5 -0.5", "v 0.5 -0.5"),
               "three numbers");
    addRefusal("obj decimal comma", ".obj", edited("obj", "v 0.5 -0.5", "v 0,5 -0.5"),
               "'0,5' is not a number");
    addRefusal("obj index zero", ".obj", edited("obj", "f 1 3 2", "f 0 3 2"), "do not exist");
    addRefusal("obj index beyond", ".obj", edited("obj", "f 1 3 2", "f 1 3 9"), "1 of 12 faces");
    addRefusal("obj index far beyond", ".obj",
               edited("obj", "f 1 3 2", "f 1 3 99999999999999999999"), "do not exist");
    addRefusal("obj negative beyond", ".obj", edited("obj", "f 1 3 2", "f -9 3 2"), "do not exist");
    addRefusal("obj index is a word", ".obj", edited("obj", "f 1 3 2", "f a b c"),
               "'a' is not a vertex");
    addRefusal("obj index is a real", ".obj", edited("obj", "f 1 3 2", "f 1.5 3 2"),
               "not a vertex of a face");
    addRefusal("obj all vertices NaN", ".obj", cubeFile("obj").replace("0.5", "nan"), "not finite");
    addRefusal("obj ends in a face", ".obj", cubeFile("obj") + "f 1 2", "ends within a face");
    addRefusal("obj comments only", ".obj", "# nothing\n# here\n", "no vertices");
  }

  static void addStl() {
    for (const double part : {0.02, 0.3, 0.6, 0.97})
      addRefusal(QString("stl text cut at %1").arg(part), ".stl", cut("stl text", part), "line ");
    addRefusal("obj of the MNI", ".obj", "P 0.3 0.3 0.4 10 1 3\n 0 0 0\n 1 0 0\n 0 1 0\n", "MNI");
    addRefusal("vtk without title and points", ".vtk",
               "# vtk DataFile Version 1.0\nBINARY\nDATASET POLYDATA\nPOINTS 0 float", "is empty");
    addRefusal("stl text cut before endsolid", ".stl", edited("stl text", "endsolid cube\n", ""),
               "the file ends where 'facet' or 'endsolid'");
    addRefusal("stl binary header only", ".stl", cubeFile("stl binary").left(84),
               "promises 12 triangles");
    addRefusal("stl binary half a header", ".stl", cubeFile("stl binary").left(60), "header of 84");
    addRefusal("stl binary cut", ".stl", cut("stl binary", 0.9),
               "promises 12 triangles, the file ends");
    addRefusal("stl binary huge count", ".stl", patched("stl binary", 80, raw(0xffffffffu, little)),
               "promises 4294967295 triangles");
    addRefusal("stl binary no triangles", ".stl", QByteArray(84, '\0'), "no triangles");
    addRefusal("stl binary all NaN", ".stl",
               patched("stl binary", 96, raw(notANumber, little).repeated(9)) + QByteArray(),
               "not finite");
    addRefusal("stl text no triangles", ".stl", "solid empty\nendsolid empty\n", "no triangles");
    addRefusal("stl text two corners", ".stl",
               "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n",
               "a third 'vertex'");
    addRefusal("stl text word as number", ".stl", edited("stl text", "vertex -0.5", "vertex minus"),
               "'minus' stands where a number should");
  }

  static void addPly() {
    for (const char* kind : {"ply text", "ply little endian", "ply big endian"}) {
      const auto name = [&](const char* what) { return QString(kind) + ' ' + what; };
      addRefusal(name("cut in header"), ".ply",
                 cubeFile(kind).left(cubeFile(kind).indexOf("end_header")),
                 "the header has no 'end_header'");
      addRefusal(name("header only"), ".ply",
                 cubeFile(kind).left(cubeFile(kind).indexOf("end_header\n") + 11),
                 "promises 8 of 'vertex'");
      addRefusal(name("cut in vertices"), ".ply", cut(kind, 0.65),
                 kind[4] == 't' ? "ends after 5 of 8 of 'vertex'" : "promises 12 of 'face'");
      addRefusal(name("cut in faces"), ".ply", cut(kind, 0.95), "'face'");
      addRefusal(name("huge vertices"), ".ply", edited(kind, "vertex 8", "vertex 4000000000"),
                 "promises 4000000000 of 'vertex'");
      addRefusal(name("huge faces"), ".ply", edited(kind, "face 12", "face 9223372036854775807"),
                 "'face'");
      addRefusal(name("negative count"), ".ply", edited(kind, "vertex 8", "vertex -8"),
                 "a name and a count");
      addRefusal(name("no z"), ".ply", edited(kind, "property float z\n", "property float w\n"),
                 "x, y and z");
      addRefusal(name("no index list"), ".ply",
                 edited(kind, "element face 12\nproperty list uchar int vertex_indices",
                        "element face 12\nproperty list uchar int indices"),
                 "no list 'vertex_indices'");
    }
    addRefusal("ply unknown type", ".ply", edited("ply text", "float x", "quad x"),
               "'quad' is not a type");
    addRefusal("ply unknown format", ".ply", edited("ply text", "ascii", "utf8"),
               "'utf8' is not a format");
    addRefusal("ply no faces", ".ply",
               "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
               "property float y\nproperty float z\nend_header\n0 0 0\n",
               "no element 'face'");
    addRefusal("ply index beyond", ".ply", edited("ply text", "3 0 2 1", "3 0 2 8"),
               "1 of 12 faces");
    addRefusal("ply list longer than file", ".ply", patched("ply little endian", -156, "\xff"),
               "a list is longer");
    addRefusal("ply index negative", ".ply", patched("ply big endian", -4, raw(-5, big)),
               "do not exist");
    addRefusal("ply vertex NaN", ".ply",
               patched("ply little endian", -156 - 96, raw(notANumber, little)),
               "1 of 8 vertices are not finite");
  }

  static void addOff() {
    addRefusal("off no counts", ".off", "OFF\n", "number of vertices is missing");
    addRefusal("off one count", ".off", "OFF\n8\n", "number of faces is missing");
    addRefusal("off header only", ".off", "OFF\n8 12 0\n", "more than a file of");
    addRefusal("off cut in vertices", ".off", cut("off", 0.4), "where a coordinate should");
    addRefusal("off cut in faces", ".off", cut("off", 0.8), "12 faces, the file ends after");
    addRefusal("off huge vertices", ".off", edited("off", "8 12 0", "2000000000 12 0"),
               "promises 2000000000 vertices");
    addRefusal("off huge faces", ".off", edited("off", "8 12 0", "8 2000000000 0"),
               "promises 2000000000 faces");
    addRefusal("off huge face", ".off", edited("off", "3 0 2 1", "300000000 0 2 1"), "corners");
    addRefusal("off negative count", ".off", edited("off", "8 12 0", "-8 12 0"), "promises -8");
    addRefusal("off too few vertices", ".off", edited("off", "8 12 0", "7 12 0"), "line ");
    addRefusal("off index beyond", ".off", edited("off", "3 0 2 1", "3 0 2 8"), "1 of 12 faces");
    addRefusal("off binary", ".off", "OFF BINARY\n" + QByteArray(100, '\0'), "binary OFF");
    addRefusal("off in four dimensions", ".off", edited("off", "OFF", "4OFF"), "three dimensions");
    addRefusal("off vertex is a word", ".off", edited("off", "0.5 -0.5", "zero -0.5"),
               "'-zero' stands where a coordinate");
  }

 private slots:
  void refused_data() {
    addRefusalColumns();
    addGeneral();
    addObj();
    addStl();
    addPly();
    addOff();
  }

  void refused() { checkRefusal(); }

  void mended_data() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<int>("triangles");
    QTest::addColumn<QString>("fragment");
    const auto row = [](const char* what, const char* extension, const QByteArray& bytes,
                        int triangles, const char* fragment) {
      QTest::newRow(what) << QString(extension) << bytes << triangles << QString(fragment);
    };
    const QByteArray goodVertex = "0 0 0\n";
    const QByteArray goodFace = "3 0 1 2\n";
    row("one index beyond", ".off", gridOff(goodVertex, "3 0 1 289\n"), 511,
        "1 of 512 faces refer to vertices that do not exist");
    row("one negative index", ".off", gridOff(goodVertex, "3 0 1 -1\n"), 511, "1 of 512 faces");
    row("one vertex is no number", ".off", gridOff("nan 0 0\n", goodFace), 509,
        "1 of 289 vertices are not finite");
    row("one vertex is infinite", ".off", gridOff("0 -INF 0\n", goodFace), 509, "not finite");
    row("one vertex beyond float", ".off", gridOff("1e300 0 0\n", goodFace), 509, "not finite");
    row("one NaN as Microsoft writes it", ".off", gridOff("-1.#IND 0 0\n", goodFace), 509,
        "not finite");
    row("a face of two corners", ".off", gridOff(goodVertex, "2 0 1\n"), 511,
        "1 of 512 faces have fewer than three corners");
    row("faces without area", ".off", gridOff(goodVertex, "3 5 5 5\n"), 512, "");
    row("obj unknown statement", ".obj",
        cubeFile("obj").repeated(1) + QByteArray(200, '\n') +
            QByteArray("vn 0 0 1\n").repeated(200) + "xyzzy 1\n",
        12, "1 statements are unknown");
    row("obj lines beside faces", ".obj", cubeFile("obj") + "l 1 2\n", 12,
        "line and point elements");
    row("stl bytes behind the end", ".stl", cubeFile("stl binary") + "tail", 12,
        "4 bytes after the last triangle");
    row("vtk lines beside polygons", ".vtk", cubeFile("vtk 4.2 text") + "LINES 1 3\n2 0 1\n", 12,
        "VERTICES and LINES");
    row("gltf primitive of lines", ".gltf",
        edited("gltf", R"("indices":1})", R"("indices":1},{"mode":1,"attributes":{"POSITION":0}})"),
        12, "made of points or lines");
  }

  void mended() {
    QFETCH(QString, extension);
    QFETCH(QByteArray, bytes);
    QFETCH(int, triangles);
    QFETCH(QString, fragment);
    QTemporaryDir folder;
    const Result<model::RawMeshes> read = readBytes(folder, "mended" + extension, bytes);
    QVERIFY2(read, read ? "" : read.error().text().c_str());
    QVERIFY(isSound(*read));
    QCOMPARE(int(triangleCount(*read)), triangles);
    QCOMPARE(read->warnings.empty(), fragment.isEmpty());
    QVERIFY2(warningText(*read).contains(fragment), qPrintable(warningText(*read)));
  }

  void places_data() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("where");
    QTest::newRow("obj") << ".obj" << edited("obj", "v 0.5 ", "v half ") << "line 3";
    QTest::newRow("obj continued")
        << ".obj" << QByteArray("v 0 0 0\nv 1 \\\n0 0\nv 0 1\n") << "line 4";
    QTest::newRow("obj old Macintosh")
        << ".obj" << QByteArray("v 0 0 0\rv 1 0 0\rv 0 1\r") << "line 3";
    QTest::newRow("obj index") << ".obj" << cubeFile("obj") + "f 1 2 9\n"
                               << "line 22";
    QTest::newRow("off") << ".off" << edited("off", "3 0 2 1", "3 0 2") << "line 11";
    QTest::newRow("ply") << ".ply" << edited("ply text", "3 0 2 1", "x 0 2 1") << "line 18";
    QTest::newRow("stl") << ".stl" << edited("stl text", "outer", "inner") << "line 3";
    QTest::newRow("vtk") << ".vtk" << edited("vtk 4.2 text", "0.5 -0.5", "O.5 -0.5") << "line 6";
    QTest::newRow("stl binary") << ".stl" << cut("stl binary", 0.5) << "byte 342";
    QTest::newRow("gltf") << ".gltf" << edited("gltf", R"("count":8)", R"("count":9)")
                          << "accessors[0]";
  }

  void places() {
    QFETCH(QString, extension);
    QFETCH(QByteArray, bytes);
    QTemporaryDir folder;
    const Result<model::RawMeshes> read = readBytes(folder, "broken" + extension, bytes);
    QVERIFY(!read);
    QTEST(QString::fromStdString(read.error().where), "where");
  }

  void unreadable() {
    QTemporaryDir folder;
    const auto reasonOf = [](const QString& path) {
      const Result<model::RawMeshes> read = model::readSurfaces(path.toStdString());
      return read ? QString() : QString::fromStdString(read.error().reason);
    };
    QVERIFY(QDir(folder.path()).mkdir("folder.obj"));
    QVERIFY(reasonOf(folder.filePath("folder.obj")).contains("is a folder"));
    QVERIFY(reasonOf(folder.filePath("absent.obj")).contains("no such file"));
    QVERIFY(reasonOf(folder.filePath("absent")).contains("no such file"));
    QVERIFY(reasonOf("/dev/null").contains("device"));
    QVERIFY(QFile::link("nowhere.ply", folder.filePath("link.ply")));
    QVERIFY(reasonOf(folder.filePath("link.ply")).contains("no such file"));
  }

  void limits() {
    QTemporaryDir folder;
    model::ReadLimits limits;
    limits.fileBytes = 100;
    const auto small = readBytes(folder, "cube.obj", cubeFile("obj"), limits);
    QVERIFY(!small && small.error().reason.find("the limit is 100") != std::string::npos);
    limits = {};
    limits.triangles = 11;
    const auto few = readBytes(folder, "cube.obj", cubeFile("obj"), limits);
    QVERIFY(!few && few.error().reason.find("more than the limit") != std::string::npos);
  }
};

SLINE_TEST_WITH_EVENTS(TestBrokenFiles)
#include "test_broken_files.moc"
