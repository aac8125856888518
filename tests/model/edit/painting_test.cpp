// SPDX-License-Identifier: Apache-2.0
// Tests painting on structures.
#include "model/edit/painting.h"

#include <QtTest>
#include <array>

#include "model/edit/locks.h"
#include "model/edit/look.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

struct Ball {
  Scene scene;
  NodeId id;

  explicit Ball(float gamma = 1.0f) {
    id = scene.append(
        {.name = "ball", .style = {.gamma = Gamma::clamped(gamma)}, .mesh = test::sphere(10, 2)});
  }
  PaintPtr paint(std::uint8_t first) const {
    Paint values(scene.find(id)->mesh->vertexCount(), 0);
    values[0] = first;
    return std::make_shared<const Paint>(std::move(values));
  }
};

}  // namespace

class PaintingTest : public QObject {
  Q_OBJECT
 private slots:
  void gammaFollowsFromTheFirstStrokeOn();
  void whatIsShadedStandsOutFromTheRest();
  void theCurveOfAPersonStays();
  void nothingIsNoChange();
  void lockedStructuresStay();
};

void PaintingTest::gammaFollowsFromTheFirstStrokeOn() {
  const Ball ball;
  const Edited edited = withPaint(ball.scene, ball.id, ball.paint(255));
  QVERIFY(edited.changed);
  const ResolvedStyle style = edited.scene.resolve(ball.id);
  QCOMPARE(style.gammaMap.scalar, GammaScalar::painted);
  QVERIFY(!gammaMapFault(style.gammaMap));
  QCOMPARE(style.gammaMap.offsetAt(0.0f), 0.0f);
  QVERIFY(style.gamma.value() + style.gammaMap.offsetAt(1.0f) > 4.0f);
  QVERIFY(edited.scene.find(ball.id)->paint);
  QVERIFY(!ball.scene.find(ball.id)->paint);
}

void PaintingTest::whatIsShadedStandsOutFromTheRest() {
  for (const float gamma : {3.0f, 3.5f, 4.3f, 5.0f}) {
    const Ball ball(gamma);
    const GammaMap map =
        withPaint(ball.scene, ball.id, ball.paint(255)).scene.resolve(ball.id).gammaMap;
    QVERIFY(!gammaMapFault(map));
    QVERIFY(gamma + map.offsetAt(1.0f) > 4.0f);
    QCOMPARE(map.offsetAt(0.0f), -3.0f);
  }
}

void PaintingTest::theCurveOfAPersonStays() {
  const Ball ball;
  const GammaMap drawn{
      .scalar = GammaScalar::painted, .targets = {}, .curve = {{0.2f, -1.0f}, {0.7f, 2.0f}}};
  const Scene scene = withLook(ball.scene, std::array{ball.id}, {.gammaMap = drawn}).scene;
  const Edited edited = withPaint(scene, ball.id, ball.paint(9));
  QVERIFY(edited.changed);
  QVERIFY(edited.scene.resolve(ball.id).gammaMap == drawn);
}

void PaintingTest::nothingIsNoChange() {
  const Ball ball;
  QVERIFY(!withPaint(ball.scene, ball.id, nullptr).changed);
  QVERIFY(!withPaint(ball.scene, ball.id, ball.paint(0)).changed);
  QVERIFY(!withPaint(ball.scene, NodeId{77}, nullptr).changed);
  const Scene painted = withPaint(ball.scene, ball.id, ball.paint(255)).scene;
  QVERIFY(!withPaint(painted, ball.id, ball.paint(255)).changed);
  const Edited erased = withPaint(painted, ball.id, ball.paint(0));
  QVERIFY(erased.changed && !erased.scene.find(ball.id)->paint);
}

void PaintingTest::lockedStructuresStay() {
  const Ball ball;
  const Scene locked = withLocked(ball.scene, std::array{ball.id}, true).scene;
  QVERIFY(!withPaint(locked, ball.id, ball.paint(255)).changed);
}

SLINE_TEST(PaintingTest)
#include "painting_test.moc"
