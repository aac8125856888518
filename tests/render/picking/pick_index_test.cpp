// SPDX-License-Identifier: Apache-2.0
#include <QTest>

#include "render/picking/pick_index.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render;

class PickIndexTest : public QObject {
  Q_OBJECT
 private slots:
  /// A part that a section takes away cannot be picked; its cut face can.
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
    render::PickIndex index;
    const model::Ray ray{.origin = {1, -500, 2}, .direction = {0, 1, 0}};
    const auto pick = index.pick(scene, {&ray, 1}).seen;
    QVERIFY(pick);
    QVERIFY(std::abs(pick->position.y - picked) < 1.0f);
  }

  /// Of faces of one cut the innermost is picked, whatever the order of the scene and the fills.
  void theInnermostFaceIsPicked() {
    for (const float gamma : {1.0f, 3.0f, 5.0f})
      for (const bool bodyFirst : {true, false}) {
        model::Scene scene;
        model::NodeId heart;
        for (const bool body : {bodyFirst, !bodyFirst}) {
          model::Node node{.name = body ? "BODY" : "Heart",
                           .mesh = test::moved(*test::sphere(body ? 60.0f : 20.0f, 4), 1.0f,
                                               {0.0f, body ? 0.0f : 4.0f, 0.0f})};
          node.style.gamma = Gamma::clamped(gamma);
          const model::NodeId id = scene.append(node);
          heart = body ? heart : id;
        }
        scene.appendSection({.plane = {.normal = {0.0f, -1.0f, 0.0f}, .offset = 0.0f}});
        render::PickIndex index;
        const model::Ray inside{.origin = {5, -500, 3}, .direction = {0, 1, 0}};
        const model::Ray beside{.origin = {40, -500, 3}, .direction = {0, 1, 0}};
        QCOMPARE(index.pick(scene, {&inside, 1}).seen->id, heart);
        QVERIFY(index.pick(scene, {&beside, 1}).seen->id != heart);
      }
  }

  /// Three spheres lie in a row along the ray, the first at y = −100.
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
    render::PickIndex index;
    const model::Ray ray{.origin = {1.0f, -500.0f, 2.0f}, .direction = {0.0f, 1.0f, 0.0f}};
    const std::optional<render::Pick> pick = index.pick(scene, {&ray, 1}).seen;
    QCOMPARE(pick.has_value(), picked >= 0);
    if (!pick)
      return;
    QVERIFY(pick->id == ids[std::size_t(picked)]);
    QVERIFY(std::abs(pick->position.y - (-130.0f + 100.0f * float(picked))) < 1.0f);
    const model::Ray beside{.origin = {200.0f, -500.0f, 0.0f}, .direction = {0, 1, 0}};
    QVERIFY(!index.pick(scene, {&beside, 1}).seen);
    // Another scene gives another answer: nothing is remembered of the first.
    QVERIFY(!index.pick({}, {&ray, 1}).seen);
  }

  /// A ball is in front of another, seen from the front at 1 mm a pixel; the rows test what the
  /// first lets through.
  void seen_data() {
    QTest::addColumn<QPointF>("pixel");  // from the balls' middle
    QTest::addColumn<float>("gamma");
    QTest::addColumn<int>("fill");
    QTest::addColumn<float>("opacity");
    QTest::addColumn<bool>("locked");
    QTest::addColumn<int>("picked");  // 0 the one in front, 1 behind, -1 nothing
    const int none = int(model::Fill::none);
    const int veil = int(model::Fill::veil);
    const int paper = int(model::Fill::paper);
    const QPointF within(10, 5);
    const QPointF edge(29, 0);
    const QPointF outside(31.5, 0);
    QTest::newRow("through an outline") << within << 1.0f << none << 1.0f << false << 1;
    QTest::newRow("on its line") << edge << 1.0f << none << 1.0f << false << 0;
    QTest::newRow("just beside its line") << outside << 1.0f << none << 1.0f << false << 0;
    QTest::newRow("far beside its line") << QPointF(38, 0) << 1.0f << none << 1.0f << false << 1;
    QTest::newRow("on the line of a locked one") << edge << 1.0f << none << 1.0f << true << 1;
    QTest::newRow("a body") << within << 2.0f << none << 1.0f << false << 0;
    QTest::newRow("a locked body") << within << 5.0f << none << 1.0f << true << 1;
    QTest::newRow("through a veil") << within << 1.0f << veil << 1.0f << false << 1;
    QTest::newRow("on a veil's line") << edge << 1.0f << veil << 1.0f << false << 0;
    QTest::newRow("paper hides") << within << 1.0f << paper << 1.0f << false << 0;
    QTest::newRow("thin") << within << 5.0f << paper << 0.2f << false << 1;
    const int tint = int(model::Fill::tint);
    QTest::newRow("through a wash") << within << 1.0f << tint << 1.0f << false << 1;
    QTest::newRow("told under a veil") << within << 2.0f << veil << 1.0f << false << 0;
    QTest::newRow("35 % hide enough") << within << 5.0f << paper << 0.36f << false << 0;
    QTest::newRow("34 % do not") << within << 5.0f << paper << 0.34f << false << 1;
    QTest::newRow("not there") << edge << 5.0f << paper << 0.0f << false << 1;
    QTest::newRow("beside both") << QPointF(70, 0) << 2.0f << none << 1.0f << false << -1;
  }
  void seen() {
    QFETCH(QPointF, pixel);
    QFETCH(float, gamma);
    QFETCH(int, fill);
    QFETCH(float, opacity);
    QFETCH(bool, locked);
    QFETCH(int, picked);
    model::Scene scene;
    const auto ball = [&](float radius, float y, model::Style style, bool isLocked) {
      return scene.append({.name = "ball",
                           .style = style,
                           .locked = isLocked,
                           .mesh = test::moved(*test::sphere(radius, 5), 1.0f, {0, y, 0})});
    };
    model::Style front;
    front.gamma = Gamma::clamped(gamma);
    front.fill = model::Fill(fill);
    front.opacity = Opacity::clamped(opacity);
    const std::array ids{ball(30.0f, 0.0f, front, locked), ball(60.0f, 200.0f, {}, false)};
    model::Camera camera;
    camera.projection = model::Projection::orthographic;
    camera.heightMm = 200.0f;
    const glm::vec2 at(100.0f + float(pixel.x()), 100.0f + float(pixel.y()));
    render::PickIndex index;
    const auto pick = index.pick(scene, render::sightsAround(camera, at, {200.0f, 200.0f})).seen;
    QCOMPARE(pick.has_value(), picked >= 0);
    if (pick)
      QVERIFY(pick->id == ids[std::size_t(picked)]);
  }

  /// Lines let through what shines between them, as a thin veil under them does.
  void bodiesWinOverLinesBefore_data() {
    QTest::addColumn<int>("fill");
    QTest::addColumn<float>("opacity");
    QTest::addColumn<bool>("through");
    QTest::newRow("lines") << int(model::Fill::none) << 1.0f << true;
    QTest::newRow("over a wash") << int(model::Fill::tint) << 1.0f << true;
    QTest::newRow("over a thin veil") << int(model::Fill::veil) << 0.5f << true;
    QTest::newRow("over a veil") << int(model::Fill::veil) << 1.0f << false;
    QTest::newRow("over paper") << int(model::Fill::paper) << 1.0f << false;
  }
  void bodiesWinOverLinesBefore() {
    QFETCH(int, fill);
    QFETCH(float, opacity);
    QFETCH(bool, through);
    model::Scene scene;
    model::Style front{.gamma = Gamma::clamped(2.5f), .opacity = Opacity::clamped(opacity)};
    front.fill = model::Fill(fill);
    const model::NodeId before =
        scene.append({.name = "muscle", .style = front, .mesh = test::sphere(60.0f, 4)});
    const model::NodeId behind =
        scene.append({.name = "organ",
                      .style = {.gamma = Gamma::clamped(5.0f)},
                      .mesh = test::moved(*test::sphere(30.0f, 4), 1.0f, {0.0f, 200.0f, 0.0f})});
    render::PickIndex index;
    const model::Ray ray{.origin = {1.0f, -500.0f, 2.0f}, .direction = {0.0f, 1.0f, 0.0f}};
    const std::optional<render::Pick> pick = index.pick(scene, {&ray, 1}).seen;
    QVERIFY(pick && pick->id == (through ? behind : before));
  }

  /// A box holds what lies wholly within and touches what has a part in it; what a body hides
  /// counts for neither, and what only lines hide for both.
  void boxes_data() {
    QTest::addColumn<QRectF>("box");  // from the picture's middle, mm
    QTest::addColumn<bool>("touching");
    QTest::addColumn<float>("gamma");  // of the one in front
    QTest::addColumn<QString>("found");
    const QRectF all(-70, -70, 140, 140);
    const QRectF corner(-45, -45, 30, 30);
    QTest::newRow("all, a body in front") << all << false << 5.0f << "f";
    QTest::newRow("all, lines in front") << all << false << 1.0f << "fb";
    QTest::newRow("nothing is within") << corner << false << 1.0f << "";
    QTest::newRow("a body is touched") << corner << true << 5.0f << "f";
    QTest::newRow("only the small one is within")
        << QRectF(-35, -35, 70, 70) << false << 1.0f << "b";
    QTest::newRow("both are touched") << QRectF(-5, -5, 10, 10) << true << 1.0f << "fb";
    QTest::newRow("beside both") << QRectF(65, 65, 9, 9) << true << 5.0f << "";
  }
  void boxes() {
    QFETCH(QRectF, box);
    QFETCH(bool, touching);
    QFETCH(float, gamma);
    QFETCH(QString, found);
    model::Scene scene;
    const model::NodeId front = scene.append({.name = "front",
                                              .style = {.gamma = Gamma::clamped(gamma)},
                                              .mesh = test::sphere(60.0f, 4)});
    const model::NodeId back =
        scene.append({.name = "back",
                      .style = {.gamma = Gamma::clamped(5.0f)},
                      .mesh = test::moved(*test::sphere(30.0f, 4), 1.0f, {0.0f, 200.0f, 0.0f})});
    model::Camera camera;
    camera.projection = model::Projection::orthographic;
    camera.heightMm = 200.0f;
    const glm::vec2 middle(100.0f, 100.0f);
    const render::PickIndex::Box asked{
        .camera = camera,
        .size = {200.0f, 200.0f},
        .low = middle + glm::vec2(float(box.left()), float(box.top())),
        .high = middle + glm::vec2(float(box.right()), float(box.bottom())),
        .touching = touching};
    QString got;
    for (const model::NodeId id : render::PickIndex().inBox(scene, asked))
      got += id == front ? QLatin1Char('f') : id == back ? QLatin1Char('b') : QLatin1Char('?');
    QCOMPARE(got, found);
  }

  /// A fold of the surface is drawn as a line, too: the near side of a ring before its far side.
  void linesWithinTheOutlineCount() {
    model::Scene scene;
    model::Style outline;
    outline.gamma = Gamma::clamped(1.0f);
    outline.fill = model::Fill::none;
    const model::NodeId ring =
        scene.append({.name = "ring", .style = outline, .mesh = test::torus(40, 12, 256, 96)});
    const model::NodeId behind = scene.append(
        {.name = "ball", .mesh = test::moved(*test::sphere(80.0f, 4), 1.0f, {0, 300, 0})});
    model::Camera camera;  // a little from above, so that the near side hides the far one
    camera.projection = model::Projection::orthographic;
    camera.heightMm = 200.0f;
    camera.eye = {0.0f, -1000.0f, 200.0f};
    render::PickIndex index;
    // In this column the near side's upper rim lies before the far side.
    int onRing = 0;
    for (float y = 60.0f; y < 140.0f; y += 1.0f) {
      const auto pick =
          index.pick(scene, render::sightsAround(camera, {100.0f, y}, {200, 200})).seen;
      if (pick && pick->id == ring)
        ++onRing;
      else
        QVERIFY(!pick || pick->id == behind);
    }
    // Three lines cross the column (upper and lower outline, and the near side's rim), each as wide
    // as a hand is unsteady, and no wider.
    QVERIFY2(onRing > 14 && onRing < 45, qPrintable(QString::number(onRing)));
  }

  void deeperGoesRound() {
    const model::NodeId a{1};
    const model::NodeId b{2};
    const model::NodeId c{3};
    const std::vector<render::Pick> all{{.id = a}, {.id = b}, {.id = c}};
    const auto after = [&](std::vector<model::NodeId> selection) {
      return render::nextDeeper(all, selection)->id;
    };
    QVERIFY(after({}) == a);
    QVERIFY(after({a}) == b);
    QVERIFY(after({b}) == c);
    QVERIFY(after({c}) == a);
    QVERIFY(after({model::NodeId{9}}) == a);
    QVERIFY(after({a, b}) == a);
    QVERIFY(!render::nextDeeper({}, {}));
  }

  void allAreFoundInOrder() {
    model::Scene scene;
    std::vector<model::NodeId> ids;
    for (const float y : {200.0f, 0.0f, 100.0f})
      ids.push_back(scene.append(
          {.name = "ball", .mesh = test::moved(*test::sphere(30.0f, 3), 1.0f, {0.0f, y, 0.0f})}));
    render::PickIndex index;
    const model::Ray ray{.origin = {1, -500, 2}, .direction = {0, 1, 0}};
    const std::vector<render::Pick> all = index.pick(scene, {&ray, 1}).all;
    QCOMPARE(all.size(), std::size_t(3));
    QVERIFY(all[0].id == ids[1] && all[1].id == ids[2] && all[2].id == ids[0]);
  }
};

SLINE_TEST(PickIndexTest)
#include "pick_index_test.moc"
