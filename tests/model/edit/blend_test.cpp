// SPDX-License-Identifier: Apache-2.0
// Tests blending from one look of a scene to another.
#include "model/edit/blend.h"

#include <QtTest>
#include <array>

#include "model/edit/look.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {

struct Pair {
  Scene from;
  Scene to;
  NodeId group, ball;

  Pair() {
    group = from.append({.name = "G"});
    ball = from.append({.parent = group,
                        .name = "ball",
                        .style = {.colour = Colour{0, 100, 200},
                                  .gamma = Gamma::clamped(1),
                                  .opacity = Opacity::clamped(1),
                                  .fill = Fill::paper,
                                  .lineThresholds = ThresholdValues{{"laplacian.slope", 1.0f}},
                                  .penWeight = 1.0f},
                        .mesh = test::sphere(10, 2)});
    to = from;
  }
  void change(NodeId id, const Style& style) { to = withLook(to, std::array{id}, style).scene; }
};

}  // namespace

class BlendTest : public QObject {
  Q_OBJECT
 private slots:
  void endsAreTheEnds();
  void looksChangeEvenly();
  void whatAppearsFadesIn_data();
  void whatAppearsFadesIn();
  void whatStaysHiddenStays();
  void sectionsSlide();
  void newStructuresAreThereAtOnce();
};

void BlendTest::endsAreTheEnds() {
  Pair p;
  p.change(p.ball, {.gamma = Gamma::clamped(4)});
  const SceneBlend blend(p.from, p.to);
  QVERIFY(blend.at(1.0) == p.to);
  QVERIFY(blend.at(7.0) == p.to);
  QCOMPARE(blend.at(0.0).resolve(p.ball), p.from.resolve(p.ball));
  QCOMPARE(blend.at(-1.0).resolve(p.ball), p.from.resolve(p.ball));
}

void BlendTest::looksChangeEvenly() {
  Pair p;
  p.change(p.group, {.gamma = Gamma::clamped(0)});  // overridden below
  p.change(p.ball, {.colour = Colour{200, 100, 0},
                    .gamma = Gamma::clamped(4),
                    .opacity = Opacity::clamped(0.5f),
                    .fill = Fill::none,
                    .lineThresholds =
                        ThresholdValues{{"laplacian.slope", 3.0f}, {"ridges.curvature", 4.0f}},
                    .penWeight = 3.0f,
                    .gammaMap = GammaMap{.scalar = GammaScalar::occlusion,
                                         .curve = {{0.0f, 0.0f}, {1.0f, 3.0f}}}});
  const SceneBlend blend(p.from, p.to);
  const ResolvedStyle middle = blend.at(0.5).resolve(p.ball);
  QCOMPARE(middle.gamma.value(), 2.5f);
  QCOMPARE(middle.opacity.value(), 0.75f);
  QCOMPARE(middle.penWeight, 2.0f);
  QVERIFY(middle.lineThresholds.of("laplacian.slope") == 2.0f);
  QVERIFY(!blend.at(0.4).resolve(p.ball).lineThresholds.of("ridges.curvature"));
  QVERIFY(blend.at(0.6).resolve(p.ball).lineThresholds.of("ridges.curvature") == 4.0f);
  QCOMPARE(middle.gammaMap.offsetAt(1.0f), 1.5f);
  QCOMPARE(middle.colour, (Colour{100, 100, 100}));
  QCOMPARE(blend.at(0.4).resolve(p.ball).fill, Fill::paper);
  QCOMPARE(blend.at(0.6).resolve(p.ball).fill, Fill::none);
  float last = 1.0f;
  for (int step = 1; step <= 20; ++step) {
    const float gamma = blend.at(double(step) / 20.0).resolve(p.ball).gamma.value();
    QVERIFY(gamma > last);
    last = gamma;
  }
}

void BlendTest::whatAppearsFadesIn_data() {
  QTest::addColumn<bool>("appears");
  QTest::addColumn<bool>("byItsGroup");
  for (const bool appears : {true, false})
    for (const bool group : {true, false})
      QTest::addRow("%s by %s", appears ? "appears" : "leaves", group ? "its group" : "itself")
          << appears << group;
}

void BlendTest::whatAppearsFadesIn() {
  QFETCH(bool, appears);
  QFETCH(bool, byItsGroup);
  Pair p;
  p.change(byItsGroup ? p.group : p.ball, {.visible = false});
  const SceneBlend blend = appears ? SceneBlend(p.to, p.from) : SceneBlend(p.from, p.to);
  const ResolvedStyle early = blend.at(0.25).resolve(p.ball);
  const ResolvedStyle late = blend.at(0.75).resolve(p.ball);
  for (const ResolvedStyle& style : {early, late}) {
    QVERIFY(style.visible);
    QVERIFY(style.opacity.value() > 0.0f && style.opacity.value() < 1.0f);
    QVERIFY(style.penWeight > 0.0f && style.penWeight < 1.0f);
    QCOMPARE(style.gamma.value(), 1.0f);
  }
  QCOMPARE(early.opacity < late.opacity, appears);
  QCOMPARE(blend.at(1.0).resolve(p.ball).visible, appears);
}

void BlendTest::whatStaysHiddenStays() {
  Pair p;
  p.from = withLook(p.from, std::array{p.group}, {.visible = false}).scene;
  p.change(p.ball, {.visible = false});
  QVERIFY(!SceneBlend(p.from, p.to).at(0.5).resolve(p.ball).visible);
}

void BlendTest::sectionsSlide() {
  Pair p;
  p.from.appendSection({.name = "a", .plane = {.normal = {1, 0, 0}, .offset = 0}});
  p.to.appendSection({.name = "a", .plane = {.normal = {1, 0, 0}, .offset = 10}});
  p.to.appendSection({.name = "b", .plane = {.normal = {0, 1, 0}, .offset = 7}});
  const Scene middle = SceneBlend(p.from, p.to).at(0.5);
  QCOMPARE(middle.sections()[0].plane.offset, 5.0f);
  QCOMPARE(middle.sections()[1].plane.offset, 7.0f);
}

void BlendTest::newStructuresAreThereAtOnce() {
  Pair p;
  const NodeId more = p.to.append({.name = "more", .mesh = test::sphere(5, 2)});
  const Scene early = SceneBlend(p.from, p.to).at(0.1);
  QCOMPARE(early.resolve(more), p.to.resolve(more));
}

SLINE_TEST(BlendTest)
#include "blend_test.moc"
