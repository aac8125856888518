// SPDX-License-Identifier: Apache-2.0
#include "model/scene/scene.h"

#include <QTest>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <set>

#include "model/scene/visible_structures.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::model {
namespace {

Node group(const char* name, NodeId parent = rootId) {
  Node node;
  node.name = name;
  node.parent = parent;
  return node;
}

Node structure(const char* name, NodeId parent, MeshPtr mesh) {
  Node node = group(name, parent);
  node.mesh = std::move(mesh);
  return node;
}

/// Holds trunk ( vessels ( "Left_renal artery", vein ), liver ), bladder.
struct Sample {
  Scene scene;
  NodeId trunk, vessels, artery, vein, liver, bladder;
  Sample() {
    const MeshPtr ball = test::sphere(1.0f, 0);
    trunk = scene.append(group("Trunk"));
    bladder = scene.append(structure("bladder", rootId, test::moved(*ball, 1, {100, 0, 0})));
    vessels = scene.append(group("Vessels", trunk));
    liver = scene.append(structure("Liver", trunk, test::moved(*ball, 1, {0, 50, 0})));
    artery = scene.append(structure("Left_renal artery", vessels, ball));
    vein = scene.append(structure("vein", vessels, test::moved(*ball, 1, {0, 0, -30})));
  }
};

}  // namespace

class SceneTest : public QObject {
  Q_OBJECT

 private slots:
  void keepsTreeOrder();
  void walksTheTree();
  void inheritsStyle();
  void hiddenGroupHidesAllBelow();
  void lockedGroupLocksAllBelow();
  void findsByName_data();
  void findsByName();
  void boundsOfWhatIsVisible();
  void fitsWhatIsVisibleBelow();
  void fitComesBackFromAnywhere_data();
  void fitComesBackFromAnywhere();
  void sidesHaveOneView();
  void idsAreNeverReused();
  void findsEachNodeOfALargeTree();
};

void SceneTest::keepsTreeOrder() {
  const Sample s;
  QStringList names;
  for (const Node& node : s.scene.nodes())
    names << QString::fromStdString(node.name);
  QCOMPARE(names,
           QStringList({"Trunk", "Vessels", "Left_renal artery", "vein", "Liver", "bladder"}));
}

void SceneTest::walksTheTree() {
  const Sample s;
  using Ids = std::vector<NodeId>;
  QVERIFY(s.scene.children(rootId) == (Ids{s.trunk, s.bladder}));
  QVERIFY(s.scene.children(s.trunk) == (Ids{s.vessels, s.liver}));
  QVERIFY(s.scene.children(s.liver).empty());
  QVERIFY(s.scene.structuresBelow(rootId) == (Ids{s.artery, s.vein, s.liver, s.bladder}));
  QVERIFY(s.scene.structuresBelow(s.vessels) == (Ids{s.artery, s.vein}));
  QVERIFY(s.scene.structuresBelow(s.vein) == Ids{s.vein});
  QVERIFY(s.scene.structuresBelow(NodeId{999}).empty());
  QVERIFY(s.scene.isBelow(s.vein, s.trunk));
  QVERIFY(s.scene.isBelow(s.vein, s.vein));
  QVERIFY(s.scene.isBelow(s.vein, rootId));
  QVERIFY(!s.scene.isBelow(s.trunk, s.vein));
  QVERIFY(!s.scene.isBelow(s.bladder, s.trunk));
  QCOMPARE(s.scene.groupPath(s.vein), std::string("Trunk / Vessels"));
  QCOMPARE(s.scene.groupPath(s.liver), std::string("Trunk"));
  QCOMPARE(s.scene.groupPath(s.bladder), std::string());
  QVERIFY(s.scene.find(rootId) == nullptr);
  QVERIFY(s.scene.find(NodeId{999}) == nullptr);
}

void SceneTest::inheritsStyle() {
  Sample s;
  std::vector<Node> nodes = s.scene.nodes();
  for (Node& node : nodes) {
    if (node.id == s.trunk) {
      node.style.gamma = Gamma::clamped(4.0f);
      node.style.colour = Colour{1, 2, 3};
      node.style.fill = Fill::paper;
      node.style.penWeight = 2.0f;
      node.style.hatchDensity = HatchDensity::clamped(0.5f);
      node.style.hatchTone = HatchTone::clamped(1.5f);
    }
    if (node.id == s.vessels)
      node.style.gamma = Gamma::clamped(1.0f);
    if (node.id == s.vein)
      node.style.opacity = Opacity::clamped(0.25f);
  }
  s.scene.setNodes(nodes);
  const ResolvedStyle vein = s.scene.resolve(s.vein);
  QCOMPARE(vein.gamma.value(), 1.0f);  // the nearest value wins
  QVERIFY((vein.colour == Colour{1, 2, 3}));
  QVERIFY(vein.fill == Fill::paper);
  QCOMPARE(vein.penWeight, 2.0f);
  QCOMPARE(vein.hatchDensity.value(), 0.5f);
  QCOMPARE(vein.hatchTone.value(), 1.5f);
  QCOMPARE(vein.opacity.value(), 0.25f);
  QCOMPARE(s.scene.resolve(s.artery).opacity.value(), 1.0f);
  QCOMPARE(s.scene.resolve(s.liver).gamma.value(), 4.0f);
  QVERIFY(s.scene.resolve(s.bladder) == ResolvedStyle{});
}

void SceneTest::hiddenGroupHidesAllBelow() {
  Sample s;
  std::vector<Node> nodes = s.scene.nodes();
  for (Node& node : nodes) {
    if (node.id == s.trunk)
      node.style.visible = false;
    if (node.id == s.vein)
      node.style.visible = true;  // does not help against the group
  }
  s.scene.setNodes(nodes);
  QVERIFY(!s.scene.resolve(s.vein).visible);
  QVERIFY(!s.scene.resolve(s.liver).visible);
  QVERIFY(s.scene.resolve(s.bladder).visible);
}

void SceneTest::lockedGroupLocksAllBelow() {
  Sample s;
  std::vector<Node> nodes = s.scene.nodes();
  for (Node& node : nodes)
    node.locked = node.id == s.vessels;
  s.scene.setNodes(nodes);
  QVERIFY(s.scene.isLocked(s.vessels) && s.scene.isLocked(s.vein));
  QVERIFY(!s.scene.isLocked(s.trunk) && !s.scene.isLocked(s.liver));
  QVERIFY(!s.scene.isLocked(rootId));
}

void SceneTest::findsByName_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<int>("found");
  QTest::newRow("as written") << "Left_renal artery" << 1;
  QTest::newRow("spaces") << "left renal artery" << 1;
  QTest::newRow("dashes and runs") << "LEFT - renal__ARTERY " << 1;
  QTest::newRow("group") << "vessels" << 1;
  QTest::newRow("part of a name") << "renal artery" << 0;
  QTest::newRow("run together") << "leftrenalartery" << 0;
  QTest::newRow("empty") << "" << 0;
}

void SceneTest::findsByName() {
  QFETCH(QString, name);
  QFETCH(int, found);
  const Sample s;
  QCOMPARE(int(s.scene.named(name.toStdString()).size()), found);
}

void SceneTest::boundsOfWhatIsVisible() {
  Sample s;
  QVERIFY(s.scene.visibleBounds().high.x > 100.0f);
  std::vector<Node> nodes = s.scene.nodes();
  for (Node& node : nodes)
    if (node.id == s.bladder)
      node.style.visible = false;
  s.scene.setNodes(nodes);
  QVERIFY(s.scene.visibleBounds().high.x < 2.0f);
  QVERIFY(s.scene.visibleBounds().high.y > 50.0f);
  QVERIFY(Scene{}.visibleBounds().empty());
}

void SceneTest::fitsWhatIsVisibleBelow() {
  Scene scene;
  const NodeId near = scene.append(group("near"));
  const MeshPtr ball = test::sphere(10.0f, 2);
  const auto add = [&](const char* name, NodeId parent, float x) {
    return scene.append(structure(name, parent, test::moved(*ball, 1.0f, {x, 0.0f, 0.0f})));
  };
  const NodeId first = add("first", near, 0.0f);
  add("second", near, 40.0f);
  add("far", rootId, 900.0f);
  const std::size_t points = ball->positions().size();
  QCOMPARE(visiblePoints(scene).size(), 3 * points);
  QCOMPARE(visiblePoints(scene, std::array{near}).size(), 2 * points);
  QCOMPARE(visiblePoints(scene, std::array{first}).size(), points);
  // What is named twice counts once.
  QCOMPARE(visiblePoints(scene, std::array{near, first}).size(), 2 * points);
  const Camera camera = fittedToVisible(scene, {}, 1.5f, {}, std::array{near});
  QVERIFY(std::abs(camera.target.x - 20.0f) < 0.1f);
  QCOMPARE(fittedToVisible(scene, camera, 1.5f, {}, {}), camera);
}

void SceneTest::fitComesBackFromAnywhere_data() {
  QTest::addColumn<Camera>("lost");
  QTest::addColumn<bool>("turned");  // the way that it looks is gone
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  QTest::newRow("NaN") << Camera{.eye = {nan, 0, 0}} << true;
  QTest::newRow("eye in the target") << Camera{.eye = {5, 5, 5}, .target = {5, 5, 5}} << true;
  QTest::newRow("beyond reach") << Camera{.eye = {3e38f, -3e38f, 0}} << true;
  QTest::newRow("as far as may be") << Camera{.eye = {1e11f, 0, 0}} << false;
  QTest::newRow("as near as may be")
      << Camera{.eye = {900.01f, 0, 0}, .target = {900, 0, 0}} << false;
  QTest::newRow("nothing high") << Camera{.projection = Projection::orthographic,
                                          .eye = {100, 0, 0},
                                          .heightMm = 1e-30f}
                                << true;
}

void SceneTest::fitComesBackFromAnywhere() {
  QFETCH(Camera, lost);
  QFETCH(bool, turned);
  Scene scene;
  scene.append(structure("ball", rootId, test::sphere(10.0f, 2)));
  const Camera found = fittedToVisible(scene, lost, 1.5f);
  QVERIFY(!cameraFault(found));
  QVERIFY(glm::length(found.target) < 1.0f);
  // The ball has nine tenths of the height, a little less for what bulges towards the eye.
  const float shown = millimetresPerPixel(found, {0, 0, 0}, 1.0f);
  QVERIFY2(shown > 20.0f && shown < 26.0f, qPrintable(QString::number(shown)));
  QVERIFY(glm::dot(cameraFrame(found).back, glm::vec3(turned ? 0 : 1, turned ? -1 : 0, 0)) > 0.99f);
}

void SceneTest::sidesHaveOneView() {
  const Sample s;
  const FreeSides sides{.left = 0.3, .right = 0.1, .top = 0.05, .bottom = 0.2};
  for (int i = 0; i < 6; ++i) {
    const auto view = AnatomicalView(i);
    const Camera camera = fittedView(s.scene, view, 1.5f, sides);
    QVERIFY(anatomicalViewOf(camera) == view);
    // It does not matter from where a camera of that direction came.
    Camera elsewhere = camera;
    const glm::vec3 away = 3.0f * (camera.eye - camera.target) + glm::vec3(7.0f, 8.0f, 9.0f);
    elsewhere.eye += away;
    elsewhere.target += away;
    const Camera again = fittedToVisible(s.scene, elsewhere, 1.5f, sides);
    QVERIFY(glm::distance(again.eye, camera.eye) <
            1e-3f * glm::distance(camera.eye, camera.target));
  }
}

void SceneTest::idsAreNeverReused() {
  Sample s;
  std::vector<Node> nodes = s.scene.nodes();
  nodes.pop_back();  // the bladder
  s.scene.setNodes(nodes);
  const NodeId fresh = s.scene.append(group("new"));
  for (const NodeId old : {s.trunk, s.vessels, s.artery, s.vein, s.liver, s.bladder})
    QVERIFY(fresh != old);
}

void SceneTest::findsEachNodeOfALargeTree() {
  const MeshPtr ball = test::sphere(1.0f, 0);
  Scene scene;
  std::vector<NodeId> groups{rootId};
  // Nodes mostly go to the last group, now and then to one before it.
  for (int i = 0; i < 600; ++i) {
    const NodeId parent = i % 7 == 0 ? groups[std::size_t(i * 31) % groups.size()] : groups.back();
    if (i % 10 == 0)
      groups.push_back(scene.append(group("group", parent)));
    else
      scene.append(structure("structure", parent, ball));
  }
  const auto consistent = [](const Scene& all) {
    std::set<NodeId> seen{rootId};
    for (const Node& node : all.nodes()) {
      QCOMPARE(all.find(node.id), &node);
      QVERIFY(seen.contains(node.parent));
      seen.insert(node.id);
    }
    QVERIFY(!all.find(rootId));
    QVERIFY(!all.find(NodeId{1'000'000}));
  };
  consistent(scene);
  const Scene copy = scene;
  consistent(copy);
  std::vector<Node> fewer;
  for (const Node& node : scene.nodes())
    if (node.isGroup())
      fewer.push_back(node);
  scene.setNodes(fewer);
  consistent(scene);
  scene.append(structure("last", groups[3], ball));
  consistent(scene);
  consistent(copy);
}

}  // namespace sline::model

SLINE_TEST(sline::model::SceneTest)
#include "scene_test.moc"
