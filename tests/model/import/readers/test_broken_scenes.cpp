// SPDX-License-Identifier: Apache-2.0
// Tests VTK and glTF files broken on purpose: each must be refused by a message that says what is
// wrong.
#include <QTest>
#include <cstring>

#include "tests/model/import/readers/refusals.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

namespace {
QByteArray minimalGltf(const QByteArray& nodes, const QByteArray& rest) {
  return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[)" + nodes + "]" + rest +
         "}";
}

constexpr std::endian little = std::endian::little;
}  // namespace

class TestBrokenScenes : public QObject {
  Q_OBJECT

  static void addVtk() {
    for (const char* kind : {"vtk 4.2 text", "vtk 4.2 binary", "vtk 5.1 text", "vtk 5.1 binary"}) {
      const auto name = [&](const char* what) { return QString(kind) + ' ' + what; };
      for (const double part : {0.05, 0.15, 0.3, 0.5, 0.7})
        addRefusal(name("cut at ") + QString::number(part), ".vtk", cut(kind, part),
                   "the file ends|holds at most|does not begin");
      addRefusal(name("huge points"), ".vtk", edited(kind, "POINTS 8", "POINTS 3000000000"),
                 "promises 3000000000 POINTS");
      addRefusal(name("negative points"), ".vtk", edited(kind, "POINTS 8", "POINTS -8"),
                 "a count and a type");
      addRefusal(name("unknown type"), ".vtk", edited(kind, "8 float", "8 quad"),
                 "a type of number");
      addRefusal(name("fewer points"), ".vtk", edited(kind, "POINTS 8", "POINTS 7"),
                 "is not a section");
      addRefusal(name("other dataset"), ".vtk", edited(kind, "POLYDATA", "STRUCTURED_GRID"),
                 "'STRUCTURED_GRID', not POLYDATA");
    }
  }

  static void addVtkCells() {
    addRefusal("vtk huge cells", ".vtk", edited("vtk 4.2 binary", "12 48", "12 2000000000"),
               "the rest of the file holds");
    addRefusal("vtk more cells than numbers", ".vtk", edited("vtk 4.2 text", "12 48", "48 48"),
               "cell 12");
    addRefusal("vtk numbers left over", ".vtk", edited("vtk 4.2 text", "12 48", "11 48"),
               "take 44");
    addRefusal("vtk cell too long", ".vtk", edited("vtk 4.2 text", "3 0 2 1", "99 0 2 1"),
               "cell 0 of 12");
    addRefusal("vtk cell index beyond", ".vtk", edited("vtk 4.2 text", "3 0 2 1", "3 0 2 8"),
               "1 of 12 faces");
    addRefusal("vtk cell index negative", ".vtk", edited("vtk 4.2 text", "3 0 2 1", "3 0 2 -1"),
               "1 of 12 faces");
    addRefusal("vtk 5.1 huge offsets", ".vtk", edited("vtk 5.1 binary", "13 36", "2000000000 36"),
               "2000000000 OFFSETS");
    addRefusal("vtk 5.1 huge connectivity", ".vtk",
               edited("vtk 5.1 text", "13 36", "13 4000000000"), "4000000000 CONNECTIVITY");
    addRefusal("vtk 5.1 falling offsets", ".vtk", edited("vtk 5.1 text", "0 3 6", "0 6 3"),
               "do not fit its CONNECTIVITY");
    addRefusal("vtk 5.1 offsets beyond", ".vtk", edited("vtk 5.1 text", "33 36", "33 37"),
               "do not fit its CONNECTIVITY");
    addRefusal("vtk no dataset", ".vtk", edited("vtk 4.2 text", "DATASET POLYDATA\n", ""),
               "where DATASET should");
    addRefusal("vtk version 9", ".vtk", edited("vtk 4.2 text", "4.2", "9.9"), "not a version");
    addRefusal("vtk neither text nor binary", ".vtk", edited("vtk 4.2 text", "ASCII", "HEX"),
               "ASCII or BINARY");
    addRefusal("vtk unknown section", ".vtk", edited("vtk 4.2 text", "POLYGONS", "HEXAGONS"),
               "'HEXAGONS' is not a section");
    addRefusal("vtk points only", ".vtk",
               cubeFile("vtk 4.2 text").left(cubeFile("vtk 4.2 text").indexOf("POLYGONS")),
               "no POLYGONS");
    addRefusal("vtk cut in normals", ".vtk", cubeFile("vtk 4.2 binary").chopped(20),
               "within NORMALS");
    addRefusal("vtk huge field", ".vtk",
               edited("vtk 4.2 text", "POINTS 8", "FIELD f 1\na 1 2000000000 float\n1 2\nPOINTS 8"),
               "more values than the file holds");
  }

  static void addVtp() {
    for (const char* kind : {"vtp text", "vtp binary", "vtp appended"}) {
      const auto name = [&](const char* what) { return QString(kind) + ' ' + what; };
      for (const double part : {0.1, 0.4, 0.6, 0.8})
        addRefusal(name("cut at ") + QString::number(part), ".vtp", cut(kind, part),
                   "the file ends|block header|data end");
      addRefusal(name("huge points"), ".vtp",
                 edited(kind, "NumberOfPoints=\"8\"", "NumberOfPoints=\"4000000000\""),
                 "Points need");
      addRefusal(name("huge polygons"), ".vtp",
                 edited(kind, "NumberOfPolys=\"12\"", "NumberOfPolys=\"4000000000\""),
                 "Polys need");
      addRefusal(name("negative points"), ".vtp",
                 edited(kind, "NumberOfPoints=\"8\"", "NumberOfPoints=\"-8\""), "not a count");
      addRefusal(name("two components"), ".vtp",
                 edited(kind, "NumberOfComponents=\"3\"", "NumberOfComponents=\"2\""),
                 "components");
      addRefusal(name("strings for points"), ".vtp", edited(kind, "Float32", "String"),
                 "not a type for Points");
      addRefusal(name("other dataset"), ".vtp",
                 edited(kind, "type=\"PolyData\"", "type=\"ImageData\""),
                 "'ImageData', not PolyData");
      addRefusal(name("unknown compressor"), ".vtp",
                 edited(kind, "header_type", "compressor=\"zip\" header_type"), "not a compressor");
      if (std::strcmp(kind, "vtp text") != 0)
        addRefusal(name("claims compression"), ".vtp",
                   edited(kind, "header_type", "compressor=\"vtkZLibDataCompressor\" header_type"),
                   "block header");
    }
  }

  static void addVtpArrays() {
    addRefusal("vtp fewer points", ".vtp",
               edited("vtp text", "NumberOfPoints=\"8\"", "NumberOfPoints=\"7\""),
               "faces refer to vertices that do not exist");
    addRefusal("vtp index beyond", ".vtp", edited("vtp text", "0 2 1", "0 2 8"),
               "faces refer to vertices that do not exist");
    addRefusal("vtp index negative", ".vtp", edited("vtp text", "0 2 1", "0 2 -1"),
               "faces refer to vertices that do not exist");
    addRefusal("vtp falling offsets", ".vtp", edited("vtp text", "3 6 9", "3 9 6"),
               "the offsets of Polys fall");
    addRefusal("vtp offsets beyond", ".vtp", edited("vtp text", "33 36", "33 360"),
               "need 360 values");
    addRefusal("vtp huge last offset", ".vtp", edited("vtp text", "33 36", "33 2000000000"),
               "need 2000000000 values");
    addRefusal("vtp broken base64", ".vtp",
               edited("vtp binary", "format=\"binary\">\nYA", "format=\"binary\">\n*A"),
               "block header");
    addRefusal("vtp huge block", ".vtp",
               edited("vtp binary", "format=\"binary\">\nYAAA", "format=\"binary\">\n////"),
               "block header");
    addRefusal("vtp offset beyond", ".vtp",
               edited("vtp appended", "offset=\"0\"", "offset=\"99999\""), "appended data end");
    addRefusal("vtp no array", ".vtp", edited("vtp text", "Name=\"offsets\"", "Name=\"offset\""),
               "promises Polys");
    addRefusal("vtp entities", ".vtp",
               "<?xml version=\"1.0\"?>\n<!DOCTYPE a [<!ENTITY b \"c\">]>\n" + cubeFile("vtp text"),
               "document type");
    addRefusal("vtp unclosed", ".vtp", edited("vtp text", "</Points>", "</Polys>"), "well-formed");
    addRefusal("vtp deep", ".vtp",
               edited("vtp text", "<PolyData>", QByteArray("<a>").repeated(100000)),
               "nested too deeply");
    addRefusal("vtp vertex NaN", ".vtp", edited("vtp text", "0.5 -0.5", "nan -0.5"),
               "1 of 8 vertices are not finite");
  }

  static void addGltf() {
    for (const double part : {0.1, 0.5, 0.9, 0.999}) {
      addRefusal(QString("gltf cut at %1").arg(part), ".gltf", cut("gltf", part), "valid JSON");
      addRefusal(QString("glb cut at %1").arg(part), ".glb", cut("glb", part),
                 part < 0.015 ? "header" : "the header promises");
    }
    addRefusal("glb header only", ".glb", cubeFile("glb").left(12), "within the GLB header");
    addRefusal("glb version 1", ".glb", patched("glb", 4, raw(1u, little)), "version 1");
    addRefusal("glb huge chunk", ".glb", patched("glb", 12, raw(0xfffffff0u, little)),
               "a chunk of");
    addRefusal("glb wrong chunk", ".glb", patched("glb", 16, "XXXX"), "first chunk is not JSON");
    addRefusal("gltf version 1", ".gltf", edited("gltf", "\"2.0\"", "\"1.0\""), "version '1.0'");
    addRefusal("gltf no asset", ".gltf", "{\"a\": [1, 2, 3]}", "JSON but not glTF");
    addRefusal("gltf broken base64", ".gltf", edited("gltf", "base64,A", "base64,*"),
               "base64 text is broken");
    addRefusal("gltf short base64", ".gltf", edited("gltf", "base64,AAAA", "base64,"),
               "promises 168 bytes");
    for (const char* uri :
         {"../secret.bin", "a/../../secret.bin", "/etc/passwd", "%2e%2e/secret.bin",
          "file:///etc/passwd", "https://example.org/a.bin", "..\\\\secret.bin"})
      addRefusal(
          QString("gltf uri ") + uri, ".gltf",
          edited("gltf", "data:application/octet-stream;base64,", QByteArray(uri) + "\",\"x\":\""),
          "outside the file's folder");
    addRefusal("gltf absent buffer", ".gltf",
               edited("gltf", "data:application/octet-stream;base64,", "absent.bin\",\"x\":\""),
               "cannot be read");
  }

  static void addGltfContent() {
    addRefusal("gltf huge count", ".gltf", edited("gltf", "\"count\":8", "\"count\":4000000000"),
               "far more than a file of this size");
    addRefusal("gltf count beyond view", ".gltf", edited("gltf", "\"count\":36", "\"count\":39"),
               "more than its bufferView holds");
    addRefusal("gltf huge count without data", ".gltf",
               edited("gltf", "\"bufferView\":0,\"componentType\":5126,\"count\":8",
                      "\"componentType\":5126,\"count\":90000"),
               "holds no data");
    addRefusal("gltf negative count", ".gltf", edited("gltf", "\"count\":8", "\"count\":-8"),
               "count");
    addRefusal("gltf view beyond buffer", ".gltf",
               edited("gltf", "\"byteLength\":96", "\"byteLength\":960"),
               "reaches beyond its buffer");
    addRefusal("gltf view wraps", ".gltf",
               edited("gltf", "\"byteOffset\":96", "\"byteOffset\":18446744073709551600"),
               "reaches beyond its buffer");
    addRefusal("gltf index beyond", ".gltf", edited("gltf", "\"count\":8", "\"count\":7"),
               "is beyond its 7 vertices");
    addRefusal("gltf no position", ".gltf", edited("gltf", "POSITION", "NORMAL"), "no POSITION");
    addRefusal("gltf wrong type", ".gltf", edited("gltf", "VEC3", "VEC4"), "'VEC4', not VEC3");
    addRefusal("gltf unknown component", ".gltf", edited("gltf", "5126", "5999"), "componentType");
  }

  static void addGltfNodes() {
    addRefusal("gltf absent mesh", ".gltf", edited("gltf", "\"mesh\":0", "\"mesh\":7"),
               "mesh that does not");
    addRefusal("gltf absent node", ".gltf", edited("gltf", "\"children\":[1]", "\"children\":[9]"),
               "nodes[9]: does not exist");
    addRefusal("gltf circle", ".gltf", minimalGltf(R"({"children":[1]},{"children":[0]})", ""),
               "nodes[0]: is reached twice");
    addRefusal("gltf own child", ".gltf", minimalGltf(R"({"children":[0]})", ""), "reached twice");
    addRefusal("gltf no meshes", ".gltf", minimalGltf("{}", ""), "no meshes");
    addRefusal("gltf mode 9", ".gltf", edited("gltf", "\"indices\":1", "\"indices\":1,\"mode\":9"),
               "mode 9");
    addRefusal("gltf Draco without data", ".gltf",
               edited("gltf", "\"indices\":1",
                      R"("indices":1,"extensions":{"KHR_draco_mesh_compression":{}})"),
               "lacks the bufferView or the POSITION of its compressed mesh");
    addRefusal("gltf meshopt without data", ".gltf",
               edited("gltf", "\"byteOffset\":0,",
                      R"("byteOffset":0,"extensions":{"EXT_meshopt_compression":{}},)"),
               "refers to a buffer that does not exist");
    addRefusal("gltf deep JSON", ".gltf", "{\"asset\":" + QByteArray(200000, '['), "valid JSON");
    addRefusal("gltf deep and closed", ".gltf", QByteArray(200000, '[') + QByteArray(200000, ']'),
               "not glTF");
    addRefusal("gltf infinite matrix", ".gltf",
               edited("gltf", "\"name\":\"cube\"",
                      "\"scale\":[1e308,1e308,1e308],\"translation\":[0,0,0],\"name\":\"c\""),
               "not finite");
    QByteArray chain;
    for (int i = 0; i < 2000; ++i)
      chain += (i == 0 ? "" : ",") + ("{\"children\":[" + QByteArray::number(i + 1) + "]}");
    addRefusal("gltf 2000 levels", ".gltf", minimalGltf(chain + ",{}", ""), "256 levels");
    addRefusal(
        "gltf sparse beyond", ".gltf",
        edited(
            "gltf", "\"count\":8,",
            R"("count":8,"sparse":{"count":1,"indices":{"bufferView":1,"byteOffset":2,"componentType":5121},"values":{"bufferView":0}},)")
            .replace("\"componentType\":5121", "\"componentType\":5123")
            .replace("\"byteOffset\":2", "\"byteOffset\":0")
            .replace("\"count\":8,\"sparse\":{\"count\":1",
                     "\"count\":8,\"sparse\":{\"count\":999"),
        "more than its bufferView holds");
  }

 private slots:
  void refused_data() {
    addRefusalColumns();
    addVtk();
    addVtkCells();
    addVtp();
    addVtpArrays();
    addGltf();
    addGltfContent();
    addGltfNodes();
  }

  void refused() { checkRefusal(); }
};

SLINE_TEST_WITH_EVENTS(TestBrokenScenes)
#include "test_broken_scenes.moc"
