// SPDX-License-Identifier: Apache-2.0
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "model/demo/pelvis/pelvis.h"
#include "model/import/plan/import.h"
#include "render/export/gltf/gltf_document.h"
#include "render/export/gltf/gltf_file.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;

namespace {

model::NodeId add(model::Scene& scene, const std::string& name, model::NodeId parent,
                  const model::MeshPtr& mesh = nullptr) {
  model::Node node;
  node.name = name;
  node.parent = parent;
  node.mesh = mesh;
  return scene.append(std::move(node));
}

model::MeshPtr meshOf(std::vector<glm::vec3> positions, std::vector<model::Triangle> triangles) {
  return std::make_shared<const model::Mesh>(
      std::move(model::Mesh::create(std::move(positions), std::move(triangles))).value());
}

void setStyle(model::Scene& scene, model::NodeId id, const model::Style& style) {
  std::vector<model::Node> nodes = scene.nodes();
  for (model::Node& node : nodes)
    if (node.id == id)
      node.style = style;
  scene.setNodes(std::move(nodes));
}

/// Holds a scene that differs from its mirror image, with something of all that a scene can have.
struct Sample {
  model::Scene scene;
  model::NodeId left;
  model::NodeId front;
  model::NodeId top;
  model::NodeId hidden;
};

Sample sample() {
  Sample s;
  const auto organs = add(s.scene, "Organs", model::rootId);
  const auto ball = test::sphere(10.0f, 1);
  s.left = add(s.scene, "left ball", organs, test::moved(*ball, 1.0f, {100.0f, 5.0f, 3.0f}));
  s.front = add(s.scene, "front ball", organs, test::moved(*ball, 0.5f, {-7.0f, -80.0f, 2.0f}));
  const auto more = add(s.scene, "More of them", model::rootId);
  s.top = add(s.scene, "top ball", more, test::moved(*ball, 2.0f, {-9.0f, 4.0f, 150.0f}));
  add(s.scene, "low ball", more, test::moved(*ball, 1.0f, {20.0f, 0.0f, -120.0f}));
  s.hidden = add(s.scene, "hidden ball", organs, test::moved(*ball, 1.0f, {0.0f, 0.0f, -90.0f}));
  setStyle(s.scene, s.left,
           {.colour = Colour{255, 128, 0},
            .inkColour = Colour{0, 0, 128},
            .gamma = Gamma::clamped(3.5f),
            .opacity = Opacity::clamped(0.5f)});
  setStyle(s.scene, s.hidden, {.visible = false});
  model::Annotation label;
  label.text = "Bällchen „links“";
  label.texts["la"] = "globulus";
  label.anchors = {model::SurfacePoint{s.left, 3, {0.25f, 0.25f}}};
  const auto shown = s.scene.appendAnnotation(label);
  model::Annotation distance;
  distance.kind = model::AnnotationKind::distance;
  distance.anchors = {glm::vec3(1.0f, 2.0f, 3.0f), glm::vec3(4.0f, 5.0f, 6.0f)};
  s.scene.appendAnnotation(distance);
  label.text = "not seen";
  label.visible = false;
  s.scene.appendAnnotation(label);
  model::View view{.name = "Von vorn", .camera = {}};
  view.looks = {{s.front, {.gamma = Gamma::clamped(1.0f)}, {}}, {s.hidden, {.visible = true}, {}}};
  view.annotations = {shown};
  model::View flat{.name = "Flach", .camera = {.projection = model::Projection::orthographic}};
  flat.sections = {{.name = "cut", .plane = {{1.0f, 0.0f, 0.0f}, 20.0f}}};
  s.scene.setViews({view, flat});
  s.scene.appendSection({.name = "middle", .plane = {{0.0f, 1.0f, 0.0f}, 10.0f}});
  return s;
}

render::ExportOrder orderOf(model::Scene scene) {
  render::ExportOrder order;
  order.scene = std::move(scene);
  return order;
}

std::string bytesOf(const model::Scene& scene) {
  const auto bytes = render::glbBytes(orderOf(scene), {});
  return bytes.ok() ? *bytes : std::string();
}

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

QByteArray readAll(const QString& file) {
  QFile source(file);
  return source.open(QIODevice::ReadOnly) ? source.readAll() : QByteArray();
}

}  // namespace

class GltfTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void validates_data();
  void validates();
  void validatesTheAbdomen();
  void validatorFindsFaults();
  void sidesStay();
  void coloursAreLinear();
  void saysHowItIsDrawn();
  void annotationsAndCameras();
  void readsBack();
  void sameBytesAndPadding();
  void writesNothingPrivate();
  void stopsAndRefuses();

 private:
  /// Returns the report of Khronos's validator on the bytes; an empty object if it did not run.
  QJsonObject judged(const std::string& bytes);
  QString m_node;
  QString m_why;  ///< why there is no validator
  QTemporaryDir m_folder;
};

void GltfTest::initTestCase() {
  m_node = QStandardPaths::findExecutable("node");
  const QString npm = QStandardPaths::findExecutable("npm");
  if (m_node.isEmpty() || npm.isEmpty()) {
    m_why = "Node.js and npm are not installed: nobody asked Khronos's validator";
    return;
  }
  const QDir folder(SLINE_VALIDATOR_FOLDER);
  QVERIFY(folder.mkpath("."));
  bool same = folder.exists("node_modules/gltf-validator/package.json");
  for (const char* file : {"package.json", "package-lock.json"}) {
    const QString source = QString(SLINE_VALIDATOR_FILES) + "/" + file;
    same = same && readAll(folder.filePath(file)) == readAll(source);
    QFile::remove(folder.filePath(file));
    QVERIFY(QFile::copy(source, folder.filePath(file)));
  }
  if (same)
    return;
  QProcess install;
  install.setWorkingDirectory(folder.path());
  install.start(npm, {"ci", "--no-audit", "--no-fund", "--ignore-scripts"});
  if (!install.waitForFinished(120'000) || install.exitCode() != 0) {
    install.kill();
    install.waitForFinished();
    m_why = "npm cannot fetch Khronos's validator: " + install.readAllStandardError();
  }
}

QJsonObject GltfTest::judged(const std::string& bytes) {
  const QString file = m_folder.filePath("scene.glb");
  QFile out(file);
  if (!out.open(QIODevice::WriteOnly) || out.write(bytes.data(), qint64(bytes.size())) < 0)
    return {};
  out.close();
  QProcess validator;
  validator.setWorkingDirectory(SLINE_VALIDATOR_FOLDER);
  validator.start(m_node, {QString(SLINE_VALIDATOR_FILES) + "/validate.cjs", file});
  if (!validator.waitForFinished(120'000))
    return {};
  if (const QByteArray complaint = validator.readAllStandardError(); !complaint.isEmpty())
    qWarning("%s", complaint.constData());
  return QJsonDocument::fromJson(validator.readAllStandardOutput()).object();
}

void GltfTest::validates_data() {
  QTest::addColumn<model::Scene>("scene");
  QTest::addColumn<int>("triangles");
  QTest::newRow("all there is") << sample().scene << 4 * 80;
  QTest::newRow("empty") << model::Scene() << 0;
  model::Scene hidden;
  setStyle(hidden, add(hidden, "ball", model::rootId, test::sphere(10.0f, 1)), {.visible = false});
  QTest::newRow("all hidden") << hidden << 0;
  hidden.setViews({{.name = "A view of nothing", .camera = {}}});
  QTest::newRow("a view of nothing") << hidden << 0;
  model::Scene names;
  const auto group = add(names, "器官 / \"органы\"", model::rootId);
  add(names, "Ä\u0301\n\t\\ 🫀", group, test::sphere(1.0f, 0));
  add(names, std::string("no UTF-8: \xff\xc3"), group, test::sphere(2.0f, 0));
  add(names, "", group, test::sphere(3.0f, 0));
  QTest::newRow("names") << names << 60;
  model::Scene triangle;
  add(triangle, "triangle", model::rootId,
      meshOf({{0, 0, 0}, {10, 0, 0}, {0, 10, 0}}, {{0, 1, 2}}));
  QTest::newRow("one triangle") << triangle << 1;
  model::Scene odd;
  add(odd, "a vertex of none, one without area", model::rootId,
      meshOf({{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {5, 5, 5}, {6, 6, 6}}, {{0, 1, 2}, {3, 3, 3}}));
  add(odd, "no triangles", model::rootId, meshOf({{0, 0, 0}}, {}));
  QTest::newRow("odd meshes") << odd << 2;
  QTest::newRow("pelvis") << model::pelvisDemo(model::Sex::female) << 377370;
}

void GltfTest::validates() {
  if (!m_why.isEmpty())
    QSKIP(qPrintable(m_why));
  QFETCH(model::Scene, scene);
  const QJsonObject verdict = judged(bytesOf(scene));
  const QByteArray messages = QJsonDocument(verdict["messages"].toArray()).toJson();
  QVERIFY2(verdict["errors"].toInt(-1) == 0 && verdict["warnings"].toInt(-1) == 0,
           messages.constData());
  QTEST(verdict["triangles"].toInt(), "triangles");
}

void GltfTest::validatesTheAbdomen() {
  if (!m_why.isEmpty())
    QSKIP(qPrintable(m_why));
  const std::filesystem::path data = std::filesystem::path(SLINE_TEST_DATA) / "abdomen";
  if (!std::filesystem::exists(data))
    SLINE_ABSENT("no data of the abdomen");
  model::ImportOptions options;
  options.smoothing = {.mode = model::Smoothing::Mode::off};
  const std::array inputs{data};
  const auto imported = model::importInputs(inputs, options);
  QVERIFY(imported.ok());
  const QJsonObject verdict = judged(bytesOf(imported->scene));
  QCOMPARE(verdict["errors"].toInt(-1), 0);
  QCOMPARE(verdict["warnings"].toInt(-1), 0);
  QVERIFY(verdict["triangles"].toInt() > 1'000'000);
}

/// Without this the validator's silence would mean nothing.
void GltfTest::validatorFindsFaults() {
  if (!m_why.isEmpty())
    QSKIP(qPrintable(m_why));
  std::string bytes = bytesOf(sample().scene);
  const std::size_t at = bytes.find("\"NORMAL\"");
  QVERIFY(at != std::string::npos);
  bytes.replace(at, 8, "\"NORMAA\"");
  QVERIFY(judged(bytes)["errors"].toInt() > 0);
}

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
