// SPDX-License-Identifier: Apache-2.0
// Tests numbers of looks that are moved together. The tree is A ( a b ) c.
#include "model/edit/moved_look.h"

#include <QTest>
#include <cmath>

#include "model/edit/locks.h"
#include "model/edit/look.h"
#include "model/edit/visibility.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::model {

class MovedLookTest : public QObject {
  Q_OBJECT

  Scene m_scene;
  NodeId m_group;
  NodeId m_a;
  NodeId m_b;
  NodeId m_c;
  LookNumber m_gamma = lookNumber<style_fields::gamma>();

  static float gammaOf(const Scene& scene, NodeId id) { return scene.resolve(id).gamma.value(); }
  void set(NodeId id, float gamma) {
    m_scene = withLook(m_scene, {&id, 1}, {.gamma = Gamma::clamped(gamma)}).scene;
  }
  Edited moved(std::vector<NodeId> ids, float from, float to) const {
    return withLookMoved(m_scene, ids, m_gamma, from, to);
  }

 private slots:
  void init() {
    const MeshPtr ball = test::sphere(1.0f, 0);
    m_scene = {};
    m_group = m_scene.append({.name = "A"});
    m_a = m_scene.append({.parent = m_group, .name = "a", .mesh = ball});
    m_b = m_scene.append({.parent = m_group, .name = "b", .mesh = ball});
    m_c = m_scene.append({.name = "c", .mesh = ball});
    set(m_group, 1.0f);
    set(m_a, 3.0f);
  }

  void differencesStay_data() {
    QTest::addColumn<float>("to");
    QTest::addColumn<float>("a");
    QTest::addColumn<float>("b");
    QTest::newRow("up") << 2.55f << 3.55f << 1.55f;
    QTest::newRow("down") << 1.5f << 2.5f << 0.5f;
    QTest::newRow("as far as it goes up") << 5.0f << 5.0f << 3.0f;
    QTest::newRow("as far as it goes down") << 0.0f << 2.0f << 0.0f;
  }
  void differencesStay() {
    QFETCH(float, to);
    QFETCH(float, a);
    QFETCH(float, b);
    const Edited edited = moved({m_group}, 2.0f, to);
    QVERIFY(edited.changed);
    QCOMPARE(gammaOf(edited.scene, m_a), a);
    QCOMPARE(gammaOf(edited.scene, m_b), b);
    QVERIFY2(!edited.scene.find(m_b)->style.gamma, "it goes on inheriting");
    QCOMPARE(gammaOf(edited.scene, m_c), gammaOf(m_scene, m_c));
  }

  /// A selection moves as a group does, and what stands below one of its own is moved once.
  void severalMoveOnce() {
    const Scene after = moved({m_group, m_a, m_c}, 2.0f, 2.5f).scene;
    QCOMPARE(gammaOf(after, m_a), 3.5f);
    QCOMPARE(gammaOf(after, m_b), 1.5f);
    QCOMPARE(gammaOf(after, m_c), gammaOf(m_scene, m_c) + 0.5f);
  }

  /// Where all agree there is nothing to keep: the group says it for them.
  void theSameIsSet() {
    set(m_a, 1.0f);
    const Scene after = moved({m_group}, 1.0f, 4.0f).scene;
    QCOMPARE(gammaOf(after, m_a), 4.0f);
    QVERIFY(!after.find(m_a)->style.gamma);
    QVERIFY(!withLookMoved(after, std::vector{m_group}, m_gamma, 4.0f, 4.0f).changed);
  }

  /// What cannot move, and what nobody sees, keeps the others from nothing.
  void lockedAndHiddenAreNoLimit() {
    set(m_a, 5.0f);
    QCOMPARE(roomToMove(m_scene, std::vector{m_group}, m_gamma, 2.0f), 0.0f);
    Scene scene = withLocked(m_scene, std::vector{m_a}, true).scene;
    QCOMPARE(roomToMove(scene, std::vector{m_group}, m_gamma, 2.0f), 2.0f);
    scene = withLookMoved(scene, std::vector{m_group}, m_gamma, 3.0f, 5.0f).scene;
    QCOMPARE(gammaOf(scene, m_a), 5.0f);
    QCOMPARE(gammaOf(scene, m_b), 3.0f);
    scene = withHidden(m_scene, std::vector{m_a}).scene;
    QCOMPARE(roomToMove(scene, std::vector{m_group}, m_gamma, 2.0f), 2.0f);
  }

  /// There and back is where one was, whatever the numbers are.
  void thereAndBack() {
    for (int i = 1; i < 60; ++i) {
      const float by = 0.017f * float(i);
      const Scene there = moved({m_group}, 2.0f, 2.0f + by).scene;
      const Scene back = withLookMoved(there, std::vector{m_group}, m_gamma, 2.0f + by, 2.0f).scene;
      QVERIFY(std::abs(gammaOf(back, m_a) - 3.0f) < 2e-4f);
      QVERIFY(std::abs(gammaOf(back, m_b) - 1.0f) < 2e-4f);
    }
  }
};

}  // namespace sline::model

SLINE_TEST(sline::model::MovedLookTest)
#include "moved_look_test.moc"
