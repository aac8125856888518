// SPDX-License-Identifier: Apache-2.0
// Tests focus by nearness: what is shaded, what falls off and what is in the way.
#include "model/focus/nearness.h"

#include <QtTest>
#include <array>

#include "model/edit/locks.h"
#include "model/edit/look.h"
#include "model/edit/sections.h"
#include "model/focus/context.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

/// Returns balls one behind the other as seen from the front, and one beside them.
struct Row {
  Scene scene;
  NodeId front, target, behind, beside;
  Camera camera;

  Row() {
    const auto ball = [this](const char* name, const glm::vec3& at) {
      return scene.append({.name = name, .mesh = test::moved(*test::sphere(10, 3), 1.0f, at)});
    };
    front = ball("front", {0, -50, 0});
    target = ball("target", {0, 0, 0});
    behind = ball("behind", {0, 50, 0});
    beside = ball("beside", {80, 0, 0});
    camera.eye = {0, -800, 0};
  }
  NearFocus onTarget(float falloff = 60.0f) const {
    return {.targets = {target}, .nearness = {.place = {}, .falloffMm = falloff}};
  }
  NearFocus onPlace(const glm::vec3& place) const {
    return {.targets = {}, .nearness = {.place = place, .falloffMm = 60.0f}};
  }
  std::set<NodeId> before(const NearFocus& focus) const {
    MeshTrees trees;
    return structuresBefore(scene, focus, camera, trees);
  }
  Scene focused(const NearFocus& focus) const {
    return withNearFocus(scene, focus, before(focus)).scene;
  }
};

}  // namespace

class NearnessTest : public QObject {
  Q_OBJECT
 private slots:
  void gammaFallsOff();
  void theReachSuitsTheScene();
  void targetsAreShaded();
  void whatIsInTheWayIsAnOutline();
  void placesLieOnWhatTheyTouch();
  void sectionsClearTheWay();
  void handsAndLocksCount();
  void theSceneSaysSo();
  void anotherFocusReplacesIt();
};

void NearnessTest::gammaFallsOff() {
  const std::vector<GammaPoint> curve = falloffCurve(60.0f);
  QVERIFY(!curveFault(curve));
  const GammaMap map{.scalar = GammaScalar::distance, .targets = {}, .curve = curve};
  QVERIFY(map.offsetAt(0.0f) > 4.0f);                                 // shaded
  QVERIFY(map.offsetAt(20.0f) > 2.5f && map.offsetAt(20.0f) < 4.0f);  // hatched
  QCOMPARE(map.offsetAt(60.0f), 0.0f);                                // a silhouette
  float last = 5.0f;
  for (float d = 0.0f; d < 80.0f; d += 1.0f) {
    QVERIFY(map.offsetAt(d) <= last);
    last = map.offsetAt(d);
  }
  QVERIFY(!curveFault(falloffCurve(1.0f)) && !curveFault(falloffCurve(2000.0f)));
}

void NearnessTest::theReachSuitsTheScene() {
  const Row row;
  QVERIFY(usualFalloffMm(row.scene) > 10.0f && usualFalloffMm(row.scene) < 60.0f);
  Scene body;
  body.append({.name = "skin", .mesh = test::sphere(400, 2)});
  QVERIFY(usualFalloffMm(body) > 3.0f * usualFalloffMm(row.scene));
  QVERIFY(nearnessFalloffs.contain(usualFalloffMm(Scene())));
}

void NearnessTest::targetsAreShaded() {
  Row row;
  // What another focus has left without hatching has it again.
  row.scene =
      withLook(row.scene, std::array{row.behind}, {.hatchTone = HatchTone::clamped(0.0f)}).scene;
  const Scene scene = row.focused(row.onTarget());
  QVERIFY(scene.resolve(row.target).gamma.value() > 4.0f);
  QVERIFY(scene.resolve(row.target).gammaMap == GammaMap());
  for (const NodeId id : {row.behind, row.beside}) {
    const ResolvedStyle style = scene.resolve(id);
    QCOMPARE(style.gamma.value(), 0.0f);
    QCOMPARE(style.gammaMap.scalar, GammaScalar::distance);
    QVERIFY(style.gammaMap.targets == std::vector{row.target});
    QCOMPARE(style.fill, Fill::paper);
    QCOMPARE(style.hatchTone.value(), 1.0f);
  }
}

void NearnessTest::whatIsInTheWayIsAnOutline() {
  const Row row;
  QVERIFY(row.before(row.onTarget()) == std::set{row.front});
  const ResolvedStyle style = row.focused(row.onTarget()).resolve(row.front);
  QCOMPARE(style.fill, Fill::none);
  QCOMPARE(style.gamma.value(), 0.0f);
  QVERIFY(style.gammaMap == GammaMap());
  Row turned;
  turned.camera.eye = {0, 800, 0};
  QVERIFY(turned.before(turned.onTarget()) == std::set{turned.behind});
  turned.camera.projection = Projection::orthographic;
  QVERIFY(turned.before(turned.onTarget()) == std::set{turned.behind});
}

void NearnessTest::placesLieOnWhatTheyTouch() {
  const Row row;
  // On the front of the target; the ball before it is in the way, the target itself is not.
  QVERIFY(row.before(row.onPlace({0, -10, 0})) == std::set{row.front});
  QVERIFY(row.before(row.onPlace({0, -60, 0})).empty());
  // On its back, the way leads through both.
  QVERIFY(row.before(row.onPlace({0, 10, 0})) == std::set{row.front});
  QVERIFY((row.before(row.onPlace({0, 30, 0})) == std::set{row.front, row.target}));
  const Scene scene = row.focused(row.onPlace({0, -10, 0}));
  const GammaMap map = scene.resolve(row.target).gammaMap;
  QVERIFY(map.place == glm::vec3(0, -10, 0) && map.targets.empty());
  QVERIFY(!gammaMapFault(map));
}

void NearnessTest::sectionsClearTheWay() {
  Row row;
  row.scene.appendSection(
      {.name = "cut", .plane = {.normal = {0, -1, 0}, .offset = 30}, .scope = row.front});
  QVERIFY(row.before(row.onTarget()).empty());
}

void NearnessTest::handsAndLocksCount() {
  Row row;
  row.scene = withLook(row.scene, std::array{row.beside}, {.visible = false}).scene;
  row.scene = withLocked(row.scene, std::array{row.behind}, true).scene;
  row.scene = withLook(row.scene, std::array{row.target}, {.visible = false}).scene;
  const Scene scene = row.focused(row.onTarget());
  QVERIFY(!scene.resolve(row.beside).visible);
  QVERIFY(scene.find(row.behind)->style == row.scene.find(row.behind)->style);
  QVERIFY(scene.resolve(row.target).visible);
}

void NearnessTest::theSceneSaysSo() {
  const Row row;
  const Scene scene = row.focused(row.onTarget(25.0f));
  const auto said = nearFocusOf(scene);
  QVERIFY(said && said->targets == std::vector{row.target});
  QCOMPARE(said->nearness.falloffMm, 25.0f);
  QVERIFY(!withNearFocus(scene, *said, row.before(*said)).changed);
  QVERIFY(!nearFocusOf(row.scene));
}

void NearnessTest::anotherFocusReplacesIt() {
  const Row row;
  const Scene scene = row.focused(row.onTarget());
  const Scene bare = withoutNearness(scene).scene;
  QVERIFY(!nearFocusOf(bare));
  for (const Node& node : bare.nodes())
    QVERIFY(!node.style.gammaMap);
  QVERIFY(!withoutNearness(row.scene).changed);
  FormIndex forms;
  const std::array targets{row.target};
  const auto analysis = analysed(scene, {targets, row.camera}, forms);
  QVERIFY(analysis);
  const Edited focused = withFocusAndContext(scene, *analysis, ContextAmount::clamped(0.7f));
  QVERIFY(focused.changed && !focused.scene.focus().nearness);
  QVERIFY(focused.scene.resolve(row.beside).gammaMap == GammaMap());
}

SLINE_TEST(NearnessTest)
#include "nearness_test.moc"
