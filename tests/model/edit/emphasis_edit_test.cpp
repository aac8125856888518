// SPDX-License-Identifier: Apache-2.0
// Tests Γ, colour and fill of groups, context and ghosts. The tree is A ( a b ) c.
#include <QTest>

#include "model/edit/emphasis.h"
#include "model/edit/look.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::model {

class EmphasisEditTest : public QObject {
  Q_OBJECT

  Scene m_scene;
  NodeId m_group;
  NodeId m_a;
  NodeId m_b;
  NodeId m_c;

  static Gamma gamma(float value) { return Gamma::clamped(value); }
  static float gammaOf(const Scene& scene, NodeId id) { return scene.resolve(id).gamma.value(); }

 private slots:
  void init() {
    const MeshPtr ball = test::sphere(1.0f, 0);
    m_scene = {};
    m_group = m_scene.append({.name = "A"});
    m_a = m_scene.append({.parent = m_group, .name = "a", .mesh = ball});
    m_b = m_scene.append({.parent = m_group, .name = "b", .mesh = ball});
    m_c = m_scene.append({.name = "c", .mesh = ball});
  }

  void groupsSpeakForAllInThem() {
    const NodeId only[] = {m_a};
    const NodeId group[] = {m_group};
    Scene scene = withLook(m_scene, only, {.gamma = gamma(4.0f)}).scene;
    QCOMPARE(gammaOf(scene, m_a), 4.0f);
    QCOMPARE(gammaOf(scene, m_b), 2.0f);
    QVERIFY((gammaRangeOf(scene, m_group) == GammaRange{gamma(2.0f), gamma(4.0f)}));
    scene = withLook(scene, group, {.gamma = gamma(3.0f)}).scene;
    QCOMPARE(gammaOf(scene, m_a), 3.0f);
    QVERIFY(!scene.find(m_a)->style.gamma.has_value());
    QVERIFY((gammaRangeOf(scene, m_group) == GammaRange{gamma(3.0f), gamma(3.0f)}));
    QVERIFY(!withLook(scene, group, {.gamma = gamma(3.0f)}).changed);
    scene = withLook(scene, group, {.colour = Colour{1, 2, 3}}).scene;
    QVERIFY((scene.resolve(m_b).colour == Colour{1, 2, 3}));
    scene = withLookInherited(scene, group, {.gamma = Gamma()}).scene;
    QCOMPARE(gammaOf(scene, m_a), 2.0f);
    QVERIFY(!withLookInherited(scene, group, {.gamma = Gamma()}).changed);
  }

  void rangesPassOverWhatIsHidden() {
    const NodeId only[] = {m_a};
    Scene scene = withLook(m_scene, only, {.gamma = gamma(4.0f)}).scene;
    Style hidden;
    hidden.visible = false;
    scene = withLook(scene, only, hidden).scene;
    QVERIFY((gammaRangeOf(scene, m_group) == GammaRange{gamma(2.0f), gamma(2.0f)}));
    const NodeId group[] = {m_group};
    scene = withLook(scene, group, hidden).scene;
    QVERIFY((gammaRangeOf(scene, m_group) == GammaRange{gamma(2.0f), gamma(4.0f)}));
  }

  void contextIsContoursUnderAVeil() {
    const NodeId only[] = {m_a};
    const NodeId group[] = {m_group};
    const Scene shaded = withLook(m_scene, only, {.gamma = gamma(4.5f)}).scene;
    const Edited context = withContext(shaded, group);
    for (const NodeId id : {m_a, m_b}) {
      QCOMPARE(gammaOf(context.scene, id), 1.0f);
      QVERIFY(context.scene.resolve(id).fill == Fill::veil);
    }
    QVERIFY(context.scene.resolve(m_c) == m_scene.resolve(m_c));
    QVERIFY(!withContext(context.scene, group).changed);
  }

  void ghostsAreOutlinesUnderAVeil() {
    const NodeId only[] = {m_a};
    const NodeId group[] = {m_group};
    Scene scene = withLook(m_scene, only, {.gamma = gamma(4.0f)}).scene;
    scene = withGhost(scene, group).scene;
    for (const NodeId id : {m_a, m_b}) {
      QCOMPARE(gammaOf(scene, id), 0.0f);
      QVERIFY(scene.resolve(id).fill == Fill::veil);
    }
    QVERIFY(scene.resolve(m_c) == m_scene.resolve(m_c));
    QVERIFY(!withGhost(scene, group).changed);
  }

  void inheritsFieldByField_data() {
    QTest::addColumn<Style>("which");
    QTest::addColumn<bool>("gammaStays");
    QTest::addColumn<bool>("colourStays");
    QTest::addColumn<bool>("opacityStays");
    QTest::newRow("gamma") << Style{.gamma = Gamma()} << false << true << true;
    QTest::newRow("colour") << Style{.colour = Colour()} << true << false << true;
    QTest::newRow("opacity") << Style{.opacity = Opacity()} << true << true << false;
    QTest::newRow("all") << wholeLook() << false << false << false;
  }
  void inheritsFieldByField() {
    QFETCH(Style, which);
    QFETCH(bool, gammaStays);
    QFETCH(bool, colourStays);
    QFETCH(bool, opacityStays);
    const NodeId only[] = {m_a};
    Style own{.colour = Colour{1, 2, 3}, .gamma = gamma(4.0f), .opacity = Opacity::clamped(0.5f)};
    own.visible = false;
    const Scene scene = withLook(m_scene, only, own).scene;
    const NodeId group[] = {m_group};
    for (const auto& named : {std::span<const NodeId>(only), std::span<const NodeId>(group)}) {
      const Scene after = withLookInherited(scene, named, which).scene;
      const Style& style = after.find(m_a)->style;
      QCOMPARE(style.gamma.has_value(), gammaStays);
      QCOMPARE(style.colour.has_value(), colourStays);
      QCOMPARE(style.opacity.has_value(), opacityStays);
      QVERIFY2(style.visible == false, "what is hidden stays hidden");
      QVERIFY(!withLookInherited(after, named, which).changed);
    }
  }
};

}  // namespace sline::model

SLINE_TEST(sline::model::EmphasisEditTest)
#include "emphasis_edit_test.moc"
