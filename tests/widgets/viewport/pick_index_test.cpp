// SPDX-License-Identifier: Apache-2.0
#include <QTest>

#include "tests/support/shapes.h"
#include "widgets/viewport/pick_index.h"

using namespace sline;
using namespace sline::widgets;

class PickIndexTest : public QObject {
  Q_OBJECT
 private slots:
  /// What a section takes away cannot be picked; its cut face can.
  void sectionsLetThrough_data() {
    QTest::addColumn<float>("at");
    QTest::addColumn<float>("picked");
    QTest::newRow("before all") << -200.0f << -30.0f;
    QTest::newRow("through the first") << 10.0f << 10.0f;
    QTest::newRow("between the two") << 50.0f << 70.0f;
    QTest::newRow("through the second") << 95.0f << 95.0f;
  }
  void sectionsLetThrough() {
    QFETCH(float, at);
    QFETCH(float, picked);
    model::Scene scene;
    for (const float y : {0.0f, 100.0f})
      scene.append(
          {.name = "ball", .mesh = test::moved(*test::sphere(30.0f, 4), 1.0f, {0.0f, y, 0.0f})});
    model::Section section;
    section.plane = {.normal = {0.0f, -1.0f, 0.0f}, .offset = -at};
    scene.appendSection(section);
    PickIndex index;
    const auto pick = index.pick(scene, {.origin = {1, -500, 2}, .direction = {0, 1, 0}});
    QVERIFY(pick);
    QVERIFY(std::abs(pick->position.y - picked) < 1.0f);
  }

  /// Three spheres in a row along the ray, the first at y = −100.
  void nearestThatIsSeen_data() {
    QTest::addColumn<QList<float>>("gammas");
    QTest::addColumn<QString>("fills");
    QTest::addColumn<QString>("hidden");
    QTest::addColumn<int>("picked");
    using Gammas = QList<float>;
    QTest::newRow("the first") << Gammas{2, 2, 2} << "nnn"
                               << "" << 0;
    QTest::newRow("through an outline") << Gammas{0, 2, 2} << "nnn"
                                        << "" << 1;
    QTest::newRow("through two") << Gammas{1, 0, 5} << "nnn"
                                 << "" << 2;
    QTest::newRow("an outline that hides") << Gammas{1, 2, 2} << "pnn"
                                           << "" << 0;
    QTest::newRow("outlines alone") << Gammas{1, 1, 1} << "nnn"
                                    << "" << 0;
    QTest::newRow("hidden") << Gammas{2, 2, 2} << "nnn"
                            << "01" << 2;
    QTest::newRow("nothing") << Gammas{2, 2, 2} << "nnn"
                             << "012" << -1;
  }
  void nearestThatIsSeen() {
    QFETCH(QList<float>, gammas);
    QFETCH(QString, fills);
    QFETCH(QString, hidden);
    QFETCH(int, picked);
    model::Scene scene;
    std::vector<model::NodeId> ids;
    for (int i = 0; i < 3; ++i) {
      model::Style style;
      style.gamma = Gamma::clamped(gammas[i]);
      style.fill = fills[i] == 'p' ? model::Fill::paper : model::Fill::none;
      style.visible = !hidden.contains(QString::number(i));
      const glm::vec3 place(0.0f, -100.0f + 100.0f * float(i), 0.0f);
      ids.push_back(scene.append({.name = "ball",
                                  .style = style,
                                  .mesh = test::moved(*test::sphere(30.0f, 3), 1.0f, place)}));
    }
    PickIndex index;
    const model::Ray ray{.origin = {1.0f, -500.0f, 2.0f}, .direction = {0.0f, 1.0f, 0.0f}};
    const std::optional<Pick> pick = index.pick(scene, ray);
    QCOMPARE(pick.has_value(), picked >= 0);
    if (!pick)
      return;
    QVERIFY(pick->id == ids[std::size_t(picked)]);
    QVERIFY(std::abs(pick->position.y - (-130.0f + 100.0f * float(picked))) < 1.0f);
    QVERIFY(!index.pick(scene, {.origin = {200.0f, -500.0f, 0.0f}, .direction = {0, 1, 0}}));
    // Another scene, another answer: nothing is remembered of the first.
    QVERIFY(!index.pick({}, ray));
  }
};

QTEST_APPLESS_MAIN(PickIndexTest)
#include "pick_index_test.moc"
