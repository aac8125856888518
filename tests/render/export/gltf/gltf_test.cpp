// SPDX-License-Identifier: Apache-2.0
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "model/import/plan/import.h"
#include "render/export/gltf/gltf_document.h"
#include "render/export/gltf/gltf_file.h"
#include "tests/render/export/gltf/gltf_sample.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;

namespace {

std::uint32_t number(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value |= std::uint32_t(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return value;
}

/// Returns the JSON chunk of a well-formed GLB.
QJsonObject jsonOf(const std::string& bytes) {
  if (bytes.size() < 20 || !bytes.starts_with("glTF") || number(bytes, 8) != bytes.size())
    return {};
  const auto json = QByteArray(bytes.data() + 20, qsizetype(number(bytes, 12)));
  return QJsonDocument::fromJson(json).object();
}

QJsonObject nodeNamed(const QJsonObject& root, const QString& name) {
  for (const QJsonValue& node : root["nodes"].toArray())
    if (node["name"].toString() == name)
      return node.toObject();
  return {};
}

glm::dvec3 pointIn(const QJsonValue& list) {
  return {list[0].toDouble(), list[1].toDouble(), list[2].toDouble()};
}

/// Returns the middle of the structure's bounds under the root's matrix, in metres in glTF's frame.
glm::dvec3 middleOf(const QJsonObject& root, const QString& name) {
  const QJsonValue node = nodeNamed(root, name);
  const QJsonValue primitive = root["meshes"][node["mesh"].toInt()]["primitives"][0];
  const QJsonValue accessor = root["accessors"][primitive["attributes"]["POSITION"].toInt()];
  glm::dmat4 matrix(1.0);
  const QJsonArray entries = root["nodes"][0]["matrix"].toArray();
  for (int i = 0; i < 16 && i < entries.size(); ++i)
    matrix[i / 4][i % 4] = entries[i].toDouble();
  const glm::dvec3 middle = 0.5 * (pointIn(accessor["min"]) + pointIn(accessor["max"]));
  return glm::dvec3(matrix * glm::dvec4(middle, 1.0));
}

/// Tells whether two places are the same to within that distance.
bool near(const glm::dvec3& a, const glm::dvec3& b, double within = 1e-5) {
  return glm::length(a - b) < within;
}

}  // namespace

class GltfTest : public QObject {
  Q_OBJECT

 private slots:
  void sidesStay();
  void coloursAreLinear();
  void saysHowItIsDrawn();
  void gammaStandsAtVertices();
  void annotationsAndCameras();
  void readsBack();
  void sameBytesAndPadding();
  void writesNothingPrivate();
  void stopsAndRefuses();

 private:
  QTemporaryDir m_folder;
};

void GltfTest::sidesStay() {
  const QJsonObject root = jsonOf(bytesOf(sample().scene));
  // LPS (100, 5, 3) mm becomes left +x, up +y and front +z, whatever stands there.
  QVERIFY(near(middleOf(root, "left ball"), {0.100, 0.003, -0.005}));
  QVERIFY(near(middleOf(root, "front ball"), {-0.007, 0.002, 0.080}));
  QVERIFY(near(middleOf(root, "top ball"), {-0.009, 0.150, -0.004}));
  QVERIFY(nodeNamed(root, "hidden ball").isEmpty());
  QCOMPARE(nodeNamed(root, "Organs")["children"].toArray().size(), 2);
}

void GltfTest::coloursAreLinear() {
  const QJsonObject root = jsonOf(bytesOf(sample().scene));
  const auto materialOf = [&root](const QString& name) {
    const QJsonValue mesh = root["meshes"][nodeNamed(root, name)["mesh"].toInt()];
    return root["materials"][mesh["primitives"][0]["material"].toInt()];
  };
  const QJsonValue left = materialOf("left ball");
  const QJsonArray factor = left["pbrMetallicRoughness"]["baseColorFactor"].toArray();
  QCOMPARE(factor[0].toDouble(), 1.0);
  // sRGB 128 is 0.2158605 in linear light.
  QVERIFY(std::abs(factor[1].toDouble() - 0.2158605) < 1e-6);
  QCOMPARE(factor[2].toDouble(), 0.0);
  QCOMPARE(factor[3].toDouble(), 0.5);
  QCOMPARE(left["alphaMode"].toString(), QString("BLEND"));
  QVERIFY(materialOf("front ball")["alphaMode"].isUndefined());
}

void GltfTest::saysHowItIsDrawn() {
  const Sample s = sample();
  const QJsonObject root = jsonOf(bytesOf(s.scene));
  const QJsonValue extras = nodeNamed(root, "left ball")["extras"];
  QCOMPARE(extras["gamma"].toDouble(), 3.5);
  QCOMPARE(extras["inkColour"].toString(), QString("#000080"));
  const QJsonValue plain = nodeNamed(root, "front ball")["extras"];
  QVERIFY(plain["inkColour"].isUndefined());
  const QJsonValue scene = root["scenes"][0]["extras"];
  QCOMPARE(scene["frame"].toString(), QString("LPS"));
  QCOMPARE(scene["sections"][0]["name"].toString(), QString("middle"));
  QCOMPARE(scene["sections"][0]["offset"].toDouble(), 10.0);
}

void GltfTest::gammaStandsAtVertices() {
  Sample s = sample();
  // Γ rises from 1 to 5 between 120 and 130 mm from the left ball.
  setStyle(s.scene, s.front,
           {.gamma = Gamma::clamped(1.0f),
            .gammaMap = model::GammaMap{.scalar = model::GammaScalar::distance,
                                        .targets = {s.left},
                                        .curve = {{120.0f, 0.0f}, {130.0f, 4.0f}}}});
  const std::string bytes = bytesOf(s.scene);
  const QJsonObject root = jsonOf(bytes);
  const auto attributesOf = [&root](const char* name) {
    return root["meshes"][nodeNamed(root, name)["mesh"].toInt()]["primitives"][0]["attributes"]
        .toObject();
  };
  QVERIFY(!attributesOf("top ball").contains("_GAMMA"));
  const QJsonValue extras = nodeNamed(root, "front ball")["extras"];
  QVERIFY(extras["gammaBy"].isUndefined());
  const QJsonValue accessor = root["accessors"][attributesOf("front ball")["_GAMMA"].toInt()];
  const model::Mesh& mesh = *s.scene.find(s.front)->mesh;
  QCOMPARE(accessor["count"].toInt(), int(mesh.vertexCount()));
  QCOMPARE(accessor["type"].toString(), QString("SCALAR"));
  const QJsonValue view = root["bufferViews"][accessor["bufferView"].toInt()];
  const std::size_t begin =
      20 + number(bytes, 12) + 8 + std::size_t(view["byteOffset"].toInteger());
  const glm::vec3 middle(100.0f, 5.0f, 3.0f);
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
    const float gamma = std::bit_cast<float>(number(bytes, begin + 4 * v));
    const float distance = glm::distance(mesh.positions()[v], middle) - 10.0f;
    const float expected = 1.0f + 4.0f * std::clamp((distance - 120.0f) / 10.0f, 0.0f, 1.0f);
    // The ball is of 80 triangles.
    QVERIFY2(std::abs(gamma - expected) < 0.4f,
             qPrintable(QStringLiteral("%1, not %2").arg(gamma).arg(expected)));
  }
}

void GltfTest::annotationsAndCameras() {
  const Sample s = sample();
  render::ExportOrder order = orderOf(s.scene);
  order.labels.language = "la";
  const QJsonObject root = jsonOf(*render::glbBytes(order, {}));
  const QJsonObject label = nodeNamed(root, "globulus");
  const glm::vec3 place = *s.scene.placeOf(s.scene.annotations().front().anchors.front());
  QVERIFY(near(pointIn(label["translation"]), glm::dvec3(place)));
  QCOMPARE(label["extras"]["text"].toString(), QString("Bällchen „links“"));
  QCOMPARE(label["extras"]["texts"]["la"].toString(), QString("globulus"));
  // The label goes where its structure goes.
  const QJsonArray nodes = root["nodes"].toArray();
  const QJsonArray children = nodeNamed(root, "left ball")["children"].toArray();
  QCOMPARE(children.size(), 1);
  QCOMPARE(nodes[children[0].toInt()].toObject(), label);
  QVERIFY(nodeNamed(root, "not seen").isEmpty());

  const QJsonObject view = nodeNamed(root, "Von vorn");
  const QJsonValue camera = root["cameras"][view["camera"].toInt()]["perspective"];
  QVERIFY(std::abs(camera["yfov"].toDouble() - 30.0 * 3.14159265 / 180.0) < 1e-6);
  QVERIFY(camera["zfar"].toDouble() > camera["znear"].toDouble());
  // The eye, 1000 mm before the patient, is 1 m along +z; nothing turns the camera there.
  QVERIFY(near(pointIn(view["translation"]), {0.0, 0.0, 1.0}));
  QVERIFY(std::abs(std::abs(view["rotation"][3].toDouble()) - 1.0) < 1e-6);
  const QJsonArray looks = view["extras"]["looks"].toArray();
  QCOMPARE(looks.size(), 1);  // the hidden ball is not in the file
  QCOMPARE(nodes[looks[0]["node"].toInt()]["name"].toString(), QString("front ball"));
  QCOMPARE(looks[0]["gamma"].toDouble(), 1.0);
  QCOMPARE(view["extras"]["title"]["text"].toString(), QString("Von vorn"));
  QCOMPARE(view["extras"]["title"]["texts"]["en"].toString(), QString("From the *front*"));
  QCOMPARE(view["extras"]["text"]["text"].toString(), QString("Die Bälle <b>"));
  QCOMPARE(view["extras"]["text"]["texts"]["la"].toString(), QString("Globuli"));
  QVERIFY(!QJsonDocument(root).toJson().contains("for nobody else"));
  const QJsonObject flat = nodeNamed(root, "Flach");
  const QJsonValue parallel = root["cameras"][flat["camera"].toInt()]["orthographic"];
  QVERIFY(std::abs(parallel["ymag"].toDouble() - 0.1) < 1e-6);
  QCOMPARE(flat["extras"]["sections"][0]["offset"].toDouble(), 20.0);
}

void GltfTest::readsBack() {
  const Sample s = sample();
  const QString file = m_folder.filePath("again.glb");
  QVERIFY(render::writeGltf(orderOf(s.scene), file.toStdString(), {}).ok());
  model::ImportOptions options;
  options.smoothing = {.mode = model::Smoothing::Mode::off};
  options.repair = false;
  options.keepFileNames = true;
  const std::array inputs{std::filesystem::path(file.toStdString())};
  const auto imported = model::importInputs(inputs, options);
  QVERIFY(imported.ok());
  const model::Scene& again = imported->scene;
  QCOMPARE(int(again.structuresBelow(model::rootId).size()), 4);
  for (const model::NodeId id : {s.left, s.front, s.top}) {
    const model::Node& node = *s.scene.find(id);
    const auto found = again.named(node.name);
    QVERIFY2(found.size() == 1, node.name.c_str());
    const model::Node& read = *again.find(found.front());
    const std::string path = again.groupPath(read.id);
    QVERIFY2(path == s.scene.groupPath(id), path.c_str());
    QCOMPARE(read.mesh->vertexCount(), node.mesh->vertexCount());
    QVERIFY(std::ranges::equal(read.mesh->triangles(), node.mesh->triangles()));
    for (std::size_t v = 0; v < node.mesh->vertexCount(); ++v)
      QVERIFY(glm::distance(read.mesh->positions()[v], node.mesh->positions()[v]) < 1e-4f);
  }
  const model::ResolvedStyle style = again.resolve(again.named("left ball").front());
  QVERIFY(style.colour == (Colour{255, 128, 0}));
  QCOMPARE(style.opacity.value(), 0.5f);
}

void GltfTest::sameBytesAndPadding() {
  const std::string bytes = bytesOf(sample().scene);
  QVERIFY(bytes == bytesOf(sample().scene));
  QCOMPARE(number(bytes, 8), std::uint32_t(bytes.size()));
  QCOMPARE(bytes.size() % 4, std::size_t(0));
  const std::uint32_t json = number(bytes, 12);
  QCOMPARE(json % 4, 0u);
  QCOMPARE(number(bytes, 20 + json) % 4, 0u);
  QCOMPARE(20 + json + 8 + number(bytes, 20 + json), std::uint32_t(bytes.size()));
  for (const QJsonValue& view : jsonOf(bytes)["bufferViews"].toArray())
    QCOMPARE(view["byteOffset"].toInt() % 4, 0);
}

void GltfTest::writesNothingPrivate() {
  model::Scene scene;
  model::Node node;
  node.name = "heart";
  node.mesh = test::sphere(10.0f, 1);
  node.provenance.file = "planted-name.stl";
  node.provenance.frameReason = "planted-reason";
  node.unread = R"({"planted-key": 1})";
  scene.append(node);
  model::View view{.name = "front", .camera = {}, .unread = R"({"planted-view": 1})"};
  scene.setViews({view});
  scene.setUnread(R"({"planted-scene": 1})");
  const std::string bytes = bytesOf(scene);
  QVERIFY(bytes.find("heart") != std::string::npos);
  QVERIFY(bytes.find("planted") == std::string::npos);
}

void GltfTest::stopsAndRefuses() {
  const render::ExportOrder order = orderOf(sample().scene);
  QTemporaryDir folder;
  const auto target = [&folder](const char* name) {
    return std::filesystem::path(folder.filePath(name).toStdString());
  };
  for (int calls = 0; calls < 5; ++calls) {
    int asked = 0;
    const Status stopped = render::writeGltf(
        order, target("stopped.glb"), [&](double, std::string_view) { return asked++ < calls; });
    QVERIFY(!stopped.ok());
    QCOMPARE(stopped.error().file, target("stopped.glb").string());
  }
  QVERIFY(QDir(folder.path()).mkdir("folder.glb"));
  for (const auto& bad :
       {target("nowhere/scene.glb"), target("folder.glb"),
        target((std::string(300, 'x') + ".glb").c_str()), std::filesystem::path("/dev/full")}) {
    if (bad == "/dev/full" && !std::filesystem::exists(bad))
      continue;
    const Status written = render::writeGltf(order, bad, {});
    QVERIFY2(!written.ok(), bad.c_str());
    QCOMPARE(written.error().file, bad.string());
    QVERIFY(!written.error().reason.empty() && !written.error().remedy.empty());
  }
  QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
           QStringList{"folder.glb"});
  QVERIFY(render::writeGltf(order, target("器官 ü.glb"), {}).ok());
}

SLINE_TEST_WITH_EVENTS(GltfTest)
#include "gltf_test.moc"
