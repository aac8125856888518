// SPDX-License-Identifier: Apache-2.0
// Γ, colour and fill of groups; focus and context. The tree is A ( a b ) c.
#include <QTest>

#include "model/edit/emphasis.h"
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
    Scene scene = withGamma(m_scene, only, gamma(4.0f)).scene;
    QCOMPARE(gammaOf(scene, m_a), 4.0f);
    QCOMPARE(gammaOf(scene, m_b), 2.0f);
    QVERIFY((gammaRangeOf(scene, m_group) == GammaRange{gamma(2.0f), gamma(4.0f)}));
    scene = withGamma(scene, group, gamma(3.0f)).scene;
    QCOMPARE(gammaOf(scene, m_a), 3.0f);
    QVERIFY(!scene.find(m_a)->style.gamma.has_value());
    QVERIFY((gammaRangeOf(scene, m_group) == GammaRange{gamma(3.0f), gamma(3.0f)}));
    QVERIFY(!withGamma(scene, group, gamma(3.0f)).changed);
    scene = withColour(scene, group, {1, 2, 3}).scene;
    QVERIFY((scene.resolve(m_b).colour == Colour{1, 2, 3}));
    scene = withGammaInherited(scene, group).scene;
    QCOMPARE(gammaOf(scene, m_a), 2.0f);
    QVERIFY(!withGammaInherited(scene, group).changed);
  }

  void rangesPassOverWhatIsHidden() {
    const NodeId only[] = {m_a};
    Scene scene = withGamma(m_scene, only, gamma(4.0f)).scene;
    Style hidden;
    hidden.visible = false;
    scene = withStyle(scene, only, hidden).scene;
    QVERIFY((gammaRangeOf(scene, m_group) == GammaRange{gamma(2.0f), gamma(2.0f)}));
    const NodeId group[] = {m_group};
    scene = withStyle(scene, group, hidden).scene;
    QVERIFY((gammaRangeOf(scene, m_group) == GammaRange{gamma(2.0f), gamma(4.0f)}));
  }

  void focusAndContext() {
    const NodeId focus[] = {m_a};
    const Edited focused = withFocus(m_scene, focus);
    QVERIFY(focused.changed);
    QCOMPARE(gammaOf(focused.scene, m_a), 4.5f);
    QVERIFY(focused.scene.resolve(m_a).fill == Fill::paper);
    for (const NodeId other : {m_b, m_c}) {
      QCOMPARE(gammaOf(focused.scene, other), 1.0f);
      QVERIFY(focused.scene.resolve(other).fill == Fill::veil);
    }
    QVERIFY(!withFocus(focused.scene, focus).changed);
    QVERIFY(!withFocus(m_scene, {}).changed);

    const NodeId group[] = {m_group};
    const Edited context = withContext(focused.scene, group);
    QCOMPARE(gammaOf(context.scene, m_a), 1.0f);
    QCOMPARE(gammaOf(context.scene, m_b), 1.0f);
    const Edited grouped = withFocus(focused.scene, group);
    QCOMPARE(gammaOf(grouped.scene, m_a), 4.5f);
    QCOMPARE(gammaOf(grouped.scene, m_b), 4.5f);
    QCOMPARE(gammaOf(grouped.scene, m_c), 1.0f);
  }

  void ghostsAreOutlinesUnderAVeil() {
    const NodeId only[] = {m_a};
    const NodeId group[] = {m_group};
    Scene scene = withGamma(m_scene, only, gamma(4.0f)).scene;
    scene = withGhost(scene, group).scene;
    for (const NodeId id : {m_a, m_b}) {
      QCOMPARE(gammaOf(scene, id), 0.0f);
      QVERIFY(scene.resolve(id).fill == Fill::veil);
    }
    QVERIFY(scene.resolve(m_c) == m_scene.resolve(m_c));
    QVERIFY(!withGhost(scene, group).changed);
  }

  void inheritsFieldByField_data() {
    QTest::addColumn<int>("what");
    QTest::addColumn<bool>("gammaStays");
    QTest::addColumn<bool>("colourStays");
    QTest::addColumn<bool>("opacityStays");
    QTest::newRow("gamma") << int(Inherited::gamma) << false << true << true;
    QTest::newRow("colour") << int(Inherited::colour) << true << false << true;
    QTest::newRow("opacity") << int(Inherited::opacity) << true << true << false;
    QTest::newRow("all") << int(Inherited::all) << false << false << false;
  }
  void inheritsFieldByField() {
    QFETCH(int, what);
    QFETCH(bool, gammaStays);
    QFETCH(bool, colourStays);
    QFETCH(bool, opacityStays);
    const NodeId only[] = {m_a};
    Style own{.colour = Colour{1, 2, 3}, .gamma = gamma(4.0f), .opacity = Opacity::clamped(0.5f)};
    own.visible = false;
    const Scene scene = withStyle(m_scene, only, own).scene;
    const NodeId group[] = {m_group};
    for (const auto& named : {std::span<const NodeId>(only), std::span<const NodeId>(group)}) {
      const Scene after = withInherited(scene, named, Inherited(what)).scene;
      const Style& style = after.find(m_a)->style;
      QCOMPARE(style.gamma.has_value(), gammaStays);
      QCOMPARE(style.colour.has_value(), colourStays);
      QCOMPARE(style.opacity.has_value(), opacityStays);
      QVERIFY2(style.visible == false, "what is hidden stays hidden");
      QVERIFY(!withInherited(after, named, Inherited(what)).changed);
    }
  }
};

}  // namespace sline::model

SLINE_TEST(sline::model::EmphasisEditTest)
#include "emphasis_edit_test.moc"
