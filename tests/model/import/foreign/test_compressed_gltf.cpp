// SPDX-License-Identifier: Apache-2.0
// Tests glTF with meshes compressed by Draco or meshoptimizer, or with positions as small whole
// numbers; the test packs them with the libraries themselves.
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>

#include <QtTest>
#include <algorithm>

#include "model/import/foreign/foreign.h"
#include "model/import/kinds/file_kinds.h"
#include "model/import/readers/gltf/gltf.h"
#include "model/import/readers/gltf/gltf_decoders.h"
#include "model/import/readers/readers.h"
#include "model/import/readers/vtk/vtk_readers.h"
#include "model/import/readers/x3d/x3d.h"
#include "tests/model/import/foreign/written_scenes.h"
#include "tests/model/import/readers/mesh_files.h"
#include "tests/model/import/worker/spoiled_copies.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

namespace {

constexpr const char* scene =
    "'scenes':[{'nodes':[0]}],'nodes':[{'name':'Abdomen','children':[1,2]},"
    "{'name':'left kidney','mesh':0,'translation':[10,0,0]},"
    "{'name':'right kidney','mesh':0,'translation':[-10,0,0],'scale':[-1,1,1]}],"
    "'materials':[{'pbrMetallicRoughness':{'baseColorFactor':[1,0,0,1]}}]";

/// Returns a GLB of `binary`, with these members besides the scene; ' stands for ".
QByteArray glbOf(const QByteArray& members, const QByteArray& binary) {
  QByteArray json = QByteArray("{'asset':{'version':'2.0'},") + scene +
                    ",'buffers':[{'byteLength':" + QByteArray::number(binary.size()) + "}]," +
                    members + "}";
  return glb(json.replace('\'', '"'), binary);
}

QByteArray accessors(const char* positionType, const char* normalized) {
  return QByteArray("'accessors':[{'bufferView':0,'componentType':") + positionType + normalized +
         ",'count':4,'type':'VEC3','min':[0,0,0],'max':[1,2,3]},"
         "{'bufferView':1,'componentType':5125,'count':12,'type':'SCALAR'}]";
}

constexpr const char* plainMesh =
    "'meshes':[{'name':'kidney','primitives':[{'attributes':{'POSITION':0},'indices':1,"
    "'material':0}]}],";

QByteArray dracoGlb() {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(int(kidneyTriangles().size()));
  const int id = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  for (std::size_t i = 0; i < kidneyTriangles().size(); ++i) {
    const model::Triangle& t = kidneyTriangles()[i];
    builder.SetAttributeValuesForFace(id, draco::FaceIndex(std::uint32_t(i)),
                                      &kidneyPositions()[t[0]].x, &kidneyPositions()[t[1]].x,
                                      &kidneyPositions()[t[2]].x);
  }
  const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  draco::Encoder encoder;
  draco::EncoderBuffer buffer;
  if (!encoder.EncodeMeshToBuffer(*mesh, &buffer).ok())
    qFatal("Draco does not encode");
  const QByteArray packed(buffer.data(), qsizetype(buffer.size()));
  return glbOf(
      "'extensionsUsed':['KHR_draco_mesh_compression'],"
      "'extensionsRequired':['KHR_draco_mesh_compression'],"
      "'meshes':[{'name':'kidney','primitives':[{'attributes':{'POSITION':0},"
      "'indices':1,'material':0,'extensions':{'KHR_draco_mesh_compression':"
      "{'bufferView':0,'attributes':{'POSITION':" +
          QByteArray::number(mesh->attribute(id)->unique_id()) +
          "}}}}]}],'bufferViews':[{'buffer':0,'byteLength':" + QByteArray::number(packed.size()) +
          "}],'accessors':[{'componentType':5126,'count':4,'type':'VEC3'},"
          "{'componentType':5125,'count':12,'type':'SCALAR'}]",
      packed);
}

QByteArray packedView(qsizetype at, qsizetype bytes, int count, int stride, const char* mode) {
  const auto number = [](qsizetype n) { return QByteArray::number(n); };
  return "{'buffer':0,'byteLength':" + number(qsizetype(count) * stride) +
         ",'extensions':{'EXT_meshopt_compression':{'buffer':0,'byteOffset':" + number(at) +
         ",'byteLength':" + number(bytes) + ",'byteStride':" + number(stride) +
         ",'count':" + number(count) + ",'mode':'" + mode + "'}}}";
}

/// Returns a GLB as gltfpack writes it: positions as four shorts, the last one for padding.
QByteArray meshoptGlb() {
  std::vector<std::uint16_t> shorts;
  for (const glm::vec3& p : kidneyPositions())
    for (const float value : {p.x, p.y, p.z, 0.0f})
      shorts.push_back(std::uint16_t(value));
  std::vector<unsigned> corners;
  for (const model::Triangle& t : kidneyTriangles())
    corners.insert(corners.end(), t.begin(), t.end());
  std::vector<unsigned char> vertices(meshopt_encodeVertexBufferBound(4, 8));
  vertices.resize(
      meshopt_encodeVertexBuffer(vertices.data(), vertices.size(), shorts.data(), 4, 8));
  std::vector<unsigned char> indices(meshopt_encodeIndexBufferBound(12, 4));
  meshopt_encodeIndexVersion(1);
  indices.resize(
      meshopt_encodeIndexBuffer(indices.data(), indices.size(), corners.data(), corners.size()));
  QByteArray binary(reinterpret_cast<const char*>(vertices.data()), qsizetype(vertices.size()));
  const qsizetype second = (binary.size() + 3) / 4 * 4;
  binary.append(second - binary.size(), '\0');
  binary.append(reinterpret_cast<const char*>(indices.data()), qsizetype(indices.size()));
  return glbOf(
      QByteArray("'extensionsUsed':['EXT_meshopt_compression','KHR_mesh_quantization'],"
                 "'extensionsRequired':['EXT_meshopt_compression','KHR_mesh_quantization'],") +
          plainMesh + "'bufferViews':[" +
          packedView(0, qsizetype(vertices.size()), 4, 8, "ATTRIBUTES") + "," +
          packedView(second, qsizetype(indices.size()), 12, 4, "TRIANGLES") + "]," +
          accessors("5123", ""),
      binary);
}

/// Returns a GLB with KHR_mesh_quantization alone: a third of the range of 16 bits is one unit.
QByteArray quantizedGlb() {
  QByteArray binary;
  for (const glm::vec3& p : kidneyPositions())
    for (const float value : {p.x, p.y, p.z, 0.0f})
      append(binary, std::uint16_t(value * 21845.0f), std::endian::little);
  for (const model::Triangle& t : kidneyTriangles())
    for (const std::uint32_t v : t)
      append(binary, v, std::endian::little);
  QByteArray members = QByteArray(
                           "'extensionsUsed':['KHR_mesh_quantization'],"
                           "'extensionsRequired':['KHR_mesh_quantization'],") +
                       plainMesh +
                       "'bufferViews':[{'buffer':0,'byteLength':32,'byteStride':8},"
                       "{'buffer':0,'byteOffset':32,'byteLength':48}]," +
                       accessors("5123", ",'normalized':true");
  QByteArray file = glbOf(members, binary);
  // The scene is the same, with its meshes three times as large.
  return file.replace("\"translation\":[10,0,0]", "\"translation\":[10,0,0],\"scale\":[3,3,3]")
      .replace("\"scale\":[-1,1,1]", "\"scale\":[-3,3,3]");
}

/// Returns the corners in ten-thousandths, so that there is no rounding.
std::vector<std::array<long, 3>> places(std::span<const glm::vec3> positions) {
  std::vector<std::array<long, 3>> all;
  for (const glm::vec3& p : positions)
    all.push_back({std::lround(p.x * 1e4f), std::lround(p.y * 1e4f), std::lround(p.z * 1e4f)});
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

class CompressedGltfTest : public QObject {
  Q_OBJECT

 private slots:
  void spoiledOnes() {
    judgeSpoiledCopies("draco.glb", dracoGlb());
    judgeSpoiledCopies("meshopt.glb", meshoptGlb());
  }

  void kidneys_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<bool>("compressed");
    QTest::newRow("Draco") << dracoGlb() << true;
    QTest::newRow("meshoptimizer") << meshoptGlb() << true;
    QTest::newRow("quantized") << quantizedGlb() << false;
  }

  void kidneys() {
    QFETCH(QByteArray, bytes);
    QFETCH(bool, compressed);
    // The scene's JSON has to be as long as GLB says; a replaced text may have changed it.
    if (!compressed) {
      const qsizetype jsonBytes = bytes.indexOf("BIN\0") - 4 - 20;
      QByteArray json = bytes.mid(20, jsonBytes).trimmed();
      bytes = glb(json, bytes.mid(20 + jsonBytes + 8));
    }
    const QTemporaryDir folder;
    const Result<model::RawMeshes> read = readBytes(folder, "kidneys.glb", bytes);
    QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
    QCOMPARE(model::isCompressedGltf(folder.filePath("kidneys.glb").toStdString()), compressed);
    QCOMPARE(int(read->meshes.size()), 2);
    QVERIFY2(read->warnings.empty(), qPrintable(warningText(*read)));
    for (const model::RawMesh& mesh : read->meshes) {
      const bool left = mesh.name == "left kidney";
      QVERIFY(left || mesh.name == "right kidney");
      QVERIFY(places(mesh.positions) == places(left ? leftKidney() : rightKidney()));
      QCOMPARE(int(mesh.triangles.size()), 4);
      QVERIFY(std::abs(volume(mesh) - 6.0) < 1e-2);
      QCOMPARE(mesh.groups, std::vector<std::string>{"Abdomen"});
      QVERIFY(mesh.colour == (Colour{255, 0, 0}));
      QVERIFY(mesh.yUp && mesh.frame == model::Frame::lps);
      QCOMPARE(mesh.millimetresPerUnit, 1000.0f);
    }
  }

  /// The reader itself, without decoders, names the extension that it cannot unpack.
  void withoutDecoders() {
    const QTemporaryDir folder;
    for (const auto& [bytes, told] : {std::pair(dracoGlb(), "KHR_draco_mesh_compression"),
                                      std::pair(meshoptGlb(), "EXT_meshopt_compression")}) {
      QVERIFY(readBytes(folder, "kidneys.glb", bytes).ok());
      const Result<model::RawMeshes> read =
          model::readGltf(folder.filePath("kidneys.glb").toStdString(), {});
      QVERIFY(!read.ok());
      QVERIFY2(read.error().text().find(told) != std::string::npos, read.error().text().c_str());
    }
  }

  /// Only compressed meshes are left out.
  void leftOutWithoutDecoders() {
    const QTemporaryDir folder;
    QByteArray bytes = cubeFile("gltf");
    bytes.replace(R"("indices":1})", R"("indices":1},{"attributes":{"POSITION":0},)"
                                     R"("extensions":{"KHR_draco_mesh_compression":{}}})");
    (void)readBytes(folder, "cube.gltf", bytes);
    const Result<model::RawMeshes> read =
        model::readGltf(folder.filePath("cube.gltf").toStdString(), {});
    QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
    QCOMPARE(int(triangleCount(*read)), 12);
    QVERIFY(warningText(*read).contains("KHR_draco_mesh_compression"));
  }

  void refusals_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("told");
    QByteArray broken = dracoGlb();
    broken.replace("DRACO", "DRACQ");
    QTest::newRow("Draco data that are none") << broken << "Draco data cannot be unpacked";
    QTest::newRow("another attribute")
        << dracoGlb().replace("\"POSITION\":0}}}", "\"POSITION\":7}}}")
        << "no positions under the number";
    QTest::newRow("another mode") << meshoptGlb().replace("TRIANGLES", "TRIANGLEZ")
                                  << "do not fit each other";
    broken = meshoptGlb();
    broken[broken.indexOf("BIN") + 4] = '\0';
    QTest::newRow("meshopt data that are none") << broken << "compressed data are broken";
  }

  void refusals() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, told);
    const QTemporaryDir folder;
    const Result<model::RawMeshes> read = readBytes(folder, "kidneys.glb", bytes);
    QVERIFY(!read.ok());
    QVERIFY2(QString::fromStdString(read.error().text()).contains(told),
             read.error().text().c_str());
  }
};

SLINE_TEST_WITH_EVENTS(CompressedGltfTest)
#include "test_compressed_gltf.moc"
