// SPDX-License-Identifier: Apache-2.0
#include "model/files/scene_store.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <cstring>
#include <limits>

#include "model/files/cache_folder.h"
#include "model/files/ply_writer.h"
#include "model/files/whole_file.h"
#include "tests/support/shapes.h"

using namespace sline;

namespace {
constexpr std::string_view key = "test-v1";

/// Every field that can be stored differs from its default somewhere.
model::Scene sample() {
  model::Scene scene;
  const model::NodeId vessels = scene.append({.name = "Vessels"});
  const model::NodeId arteries = scene.append({.parent = vessels, .name = "Arteries"});
  model::Node artery{.parent = arteries, .name = "Ärterie", .mesh = test::sphere(7.3f, 2)};
  artery.style = {.colour = Colour{1, 2, 3},
                  .inkColour = Colour{250, 251, 252},
                  .gamma = Gamma::clamped(3.3f),
                  .opacity = Opacity::clamped(0.7f),
                  .fill = model::Fill::tint,
                  .visible = false,
                  .penWeight = 1.7f};
  artery.provenance = {"a.ply", "LPS", "said so", 3, 2, 1, 0.25f};
  scene.append(artery);
  scene.append({.name = "loose", .style = {.visible = true}, .mesh = test::torus(9, 2, 12, 8)});
  scene.setViews({{.name = "Overview",
                   .camera = {.projection = model::Projection::orthographic,
                              .eye = {1, -500, 0.1f},
                              .target = {0.3f, 0, 2},
                              .up = {0, 0.1f, 1},
                              .fovyDegrees = 21.5f,
                              .heightMm = 333.25f}}});
  return scene;
}

/// Bit for bit; `Scene` itself compares meshes by whether they are the same object.
void compare(const model::Scene& a, const model::Scene& b) {
  QVERIFY(a.views() == b.views());
  QCOMPARE(a.nodes().size(), b.nodes().size());
  for (std::size_t i = 0; i < a.nodes().size(); ++i) {
    model::Node x = a.nodes()[i];
    model::Node y = b.nodes()[i];
    QCOMPARE(x.isGroup(), y.isGroup());
    if (!x.isGroup())
      QVERIFY(*x.mesh == *y.mesh);
    x.mesh = y.mesh = nullptr;
    QVERIFY2(x == y, x.name.c_str());
  }
}

/// As if written by a program that does not check: changed bytes under a right checksum cannot be
/// made from outside, so the tests change what is stored and store it again.
std::string storedWith(const std::function<void(model::Node&)>& change) {
  model::Scene scene = sample();
  std::vector<model::Node> nodes = scene.nodes();
  change(nodes[2]);
  model::Scene changed;
  changed.setNodes(std::move(nodes));
  return model::storedScene(changed, key);
}
}  // namespace

class SceneStoreTest : public QObject {
  Q_OBJECT
 private slots:
  void roundTrip();
  void freshIdsAfterReading();
  void everyCutIsRefused();
  void everyChangedByteIsRefused();
  void refuses_data();
  void refuses();
  void files();
  void plyIsExact();
  void cacheFolder();
};

void SceneStoreTest::roundTrip() {
  const model::Scene scene = sample();
  const auto again = model::sceneFromStore(model::storedScene(scene, key), key);
  QVERIFY(again.ok());
  compare(scene, *again);
  const auto empty = model::sceneFromStore(model::storedScene({}, key), key);
  QVERIFY(empty.ok() && empty->nodes().empty());
}

void SceneStoreTest::freshIdsAfterReading() {
  auto again = model::sceneFromStore(model::storedScene(sample(), key), key);
  QVERIFY(again.ok());
  const model::NodeId added = again->append({.name = "new"});
  const model::Scene before = sample();
  for (const model::Node& node : before.nodes())
    QVERIFY(node.id != added);
}

void SceneStoreTest::everyCutIsRefused() {
  const std::string bytes = model::storedScene(sample(), key);
  for (std::size_t size = 0; size < bytes.size(); size += size < 400 ? 1 : 131)
    QVERIFY2(!model::sceneFromStore(std::string_view(bytes).substr(0, size), key).ok(),
             std::to_string(size).c_str());
  QVERIFY(!model::sceneFromStore(bytes + "x", key).ok());
}

void SceneStoreTest::everyChangedByteIsRefused() {
  std::string bytes = model::storedScene(sample(), key);
  for (std::size_t at = 0; at < bytes.size(); at += at < 400 ? 1 : 131) {
    bytes[at] = char(bytes[at] ^ 0x40);
    QVERIFY2(!model::sceneFromStore(bytes, key).ok(), std::to_string(at).c_str());
    bytes[at] = char(bytes[at] ^ 0x40);
  }
  QVERIFY(model::sceneFromStore(bytes, key).ok());
}

void SceneStoreTest::refuses_data() {
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<QString>("reason");
  const auto row = [](const char* name, const std::string& bytes, const char* reason) {
    QTest::newRow(name) << QByteArray::fromStdString(bytes) << QString(reason);
  };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  row("nothing", "", "no stored scene");
  row("a foreign file", "PK\3\4 some archive that is long enough to be one", "no stored scene");
  row("another key", model::storedScene(sample(), "test-v2"), "another scene");
  row("a number that is none", storedWith([&](auto& n) { n.style.penWeight = nan; }), "not finite");
  row("a displacement that is none",
      storedWith([&](auto& n) { n.provenance.displacementMm = nan; }), "not finite");
  row("a fill that is none", storedWith([](auto& n) { n.style.fill = model::Fill(9); }), "fill");
  row("a text too long", storedWith([](auto& n) { n.name = std::string(5000, 'a'); }), "too long");
#ifdef NDEBUG  // setNodes asserts what these rows break
  row("a parent that is none", storedWith([](auto& n) { n.parent.value = 77; }), "out of order");
  row("an id twice", storedWith([](auto& n) { n.id.value = 1; }), "out of order");
#endif
}

void SceneStoreTest::refuses() {
  QFETCH(QByteArray, bytes);
  QFETCH(QString, reason);
  const auto scene = model::sceneFromStore(bytes.toStdString(), key);
  QVERIFY(!scene.ok());
  QVERIFY2(QString::fromStdString(scene.error().reason).contains(reason),
           scene.error().reason.c_str());
}

void SceneStoreTest::files() {
  const QTemporaryDir folder;
  const std::filesystem::path place =
      std::filesystem::path(folder.path().toStdString()) / "new" / "a.scene";
  QVERIFY(!model::readSceneStore(place, key).ok());
  QVERIFY(model::writeSceneStore(place, sample(), key).ok());
  const auto again = model::readSceneStore(place, key);
  QVERIFY(again.ok());
  compare(sample(), *again);
  // Nothing temporary stays behind.
  QCOMPARE(std::distance(std::filesystem::directory_iterator(place.parent_path()), {}), 1);
  const auto other = model::readSceneStore(place, "another");
  QVERIFY(!other.ok() && other.error().file == place.string());
}

void SceneStoreTest::plyIsExact() {
  const auto mesh = test::sphere(3.1f, 1);
  const std::string text = model::plyText(*mesh, "SPACE=LPS");
  QVERIFY(text.starts_with("ply\nformat binary_little_endian 1.0\ncomment SPACE=LPS\n"));
  const std::size_t body = text.find("end_header\n") + 11;
  QCOMPARE(text.size(), body + 12 * mesh->vertexCount() + 13 * mesh->triangleCount());
  QVERIFY(std::memcmp(text.data() + body, mesh->positions().data(), 12 * mesh->vertexCount()) == 0);
  const char* faces = text.data() + body + 12 * mesh->vertexCount();
  for (std::size_t i = 0; i < mesh->triangleCount(); ++i) {
    QCOMPARE(int(faces[13 * i]), 3);
    QVERIFY(std::memcmp(faces + 13 * i + 1, &mesh->triangles()[i], 12) == 0);
  }
}

void SceneStoreTest::cacheFolder() {
  const QByteArray cache = qgetenv("XDG_CACHE_HOME");
  const QByteArray home = qgetenv("HOME");
  qputenv("HOME", "/home/someone");
  qputenv("XDG_CACHE_HOME", "/somewhere");
  QCOMPARE(model::userCacheFolder().string(), std::string("/somewhere/sline"));
  qputenv("XDG_CACHE_HOME", "relative");
  QCOMPARE(model::userCacheFolder().string(), std::string("/home/someone/.cache/sline"));
  qunsetenv("XDG_CACHE_HOME");
  QCOMPARE(model::userCacheFolder().string(), std::string("/home/someone/.cache/sline"));
  qunsetenv("HOME");
  QVERIFY(model::userCacheFolder().empty());
  qputenv("XDG_CACHE_HOME", cache);
  qputenv("HOME", home);
}

QTEST_APPLESS_MAIN(SceneStoreTest)
#include "scene_store_test.moc"
