// SPDX-License-Identifier: Apache-2.0
#include <QtTest>

#include "render/labels/seen/seen_map.h"
#include "render/measures/leader_truth.h"
#include "render/picture/headless/headless_picture.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render;

/// A sphere in outline before a larger solid one: what shows inside the outline is the solid one.
class LeaderTruthTest : public QObject {
  Q_OBJECT
 private:
  static constexpr glm::vec2 paper{254.0f, 190.5f};
  static constexpr float scale = 720.0f / 190.5f;
  model::Scene m_scene;
  model::NodeId m_solid;
  model::NodeId m_outline;
  const model::Camera m_camera{.eye = {0.0f, -400.0f, 0.0f}};

  LeaderFault judged(model::NodeId structure, const glm::vec2& place, bool dashed) {
    const auto picture = HeadlessPicture::create();
    if (!picture.ok())
      return LeaderFault::besideIt;
    const DrawPicture draw = (*picture)->drawing();
    const std::array<LeaderEnd, 1> ends{{{structure, scale * place, dashed}}};
    const auto verdicts = judgeLeaders(draw,
                                       {.scene = m_scene,
                                        .camera = m_camera,
                                        .settings = {.width = 960, .height = 720},
                                        .dotRadius = 0.5f * scale},
                                       ends);
    return verdicts.ok() ? verdicts->front().fault : LeaderFault::besideIt;
  }

 private slots:
  void initTestCase() {
    model::Node solid{.name = "solid", .mesh = test::sphere(40.0f, 4)};
    solid.style.gamma = Gamma::clamped(5.0f);
    m_solid = m_scene.append(solid);
    model::Node outline{.name = "outline",
                        .mesh = test::moved(*test::sphere(1.0f, 4), 15.0f, {0.0f, -60.0f, 0.0f})};
    outline.style.gamma = Gamma::clamped(1.0f);
    m_outline = m_scene.append(outline);
  }

  void whatShowsInsideAnOutlineIsNotNamedByIt() {
    const glm::vec2 middle = 0.5f * paper;
    QCOMPARE(judged(m_solid, middle, false), LeaderFault::none);
    QCOMPARE(judged(m_solid, middle, true), LeaderFault::dashedWhereSeen);
    QCOMPARE(judged(m_outline, middle, false), LeaderFault::onAnother);
    QCOMPARE(judged(m_outline, {5.0f, 5.0f}, false), LeaderFault::besideIt);
  }

  /// Bodies before and behind each other, in outline, washed and solid, as in a crowded picture.
  void placesInACrowdAreRight_data() {
    QTest::addColumn<int>("fill");
    QTest::addColumn<float>("turn");
    QTest::newRow("none") << int(model::Fill::none) << 0.0f;
    QTest::newRow("tint, turned") << int(model::Fill::tint) << 0.7f;
    QTest::newRow("veil, turned") << int(model::Fill::veil) << 2.1f;
    QTest::newRow("paper, turned") << int(model::Fill::paper) << -1.0f;
  }
  void placesInACrowdAreRight() {
    QFETCH(int, fill);
    QFETCH(float, turn);
    constexpr std::array<float, 5> gammas{1.0f, 4.2f, 0.6f, 2.0f, 5.0f};
    model::Scene scene;
    for (int i = 0; i < 15; ++i) {
      const float angle = 2.399963f * float(i);
      const float far = 6.0f * std::sqrt(float(i));
      model::Node node{.name = "body " + std::to_string(i),
                       .mesh = test::moved(*test::sphere(1.0f, 4), 7.0f + float(i % 4) * 3.0f,
                                           {far * std::cos(angle), float(i % 7) * 9.0f - 27.0f,
                                            far * std::sin(angle)})};
      node.style.gamma = Gamma::clamped(gammas[std::size_t(i) % gammas.size()]);
      node.style.fill = model::Fill(fill);
      scene.append(node);
    }
    const model::Camera camera{.eye = {-200.0f * std::sin(turn), -200.0f * std::cos(turn), 30.0f}};
    const SeenMap map(scene, Screen(camera, paper));
    std::vector<LeaderEnd> ends;
    for (const model::NodeId id : scene.structuresBelow(model::rootId)) {
      const auto place = map.find(id);
      QVERIFY(place);
      ends.push_back({id, scale * place->place, place->hidden});
    }
    const auto picture = HeadlessPicture::create();
    QVERIFY(picture.ok());
    const DrawPicture draw = (*picture)->drawing();
    const auto verdicts = judgeLeaders(draw,
                                       {.scene = scene,
                                        .camera = camera,
                                        .settings = {.width = 960, .height = 720},
                                        .dotRadius = 0.5f * scale},
                                       ends);
    QVERIFY(verdicts.ok());
    for (std::size_t i = 0; i < ends.size(); ++i)
      QVERIFY2((*verdicts)[i].fault == LeaderFault::none,
               qPrintable(QStringLiteral("%1: %2 at %3, %4")
                              .arg(QString::fromStdString(scene.find(ends[i].structure)->name))
                              .arg(int((*verdicts)[i].fault))
                              .arg(double(ends[i].place.x))
                              .arg(double(ends[i].place.y))));
  }

  void foundPlacesAreRight() {
    const SeenMap map(m_scene, Screen(m_camera, paper));
    for (const model::NodeId id : {m_solid, m_outline}) {
      const auto place = map.find(id);
      QVERIFY(place && !place->hidden);
      QCOMPARE(judged(id, place->place, false), LeaderFault::none);
    }
  }
};

SLINE_TEST(LeaderTruthTest)
#include "leader_truth_test.moc"
