// SPDX-License-Identifier: Apache-2.0
#include "render/web/page_engine.h"

#include <QtTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>

#include "model/demo/demo.h"
#include "model/disk/cache_folder.h"
#include "render/picture/headless/headless_picture.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render::web;

namespace {

/// Two balls in a group, one of them labelled, and a view from the left that hides the other.
struct Balls {
  model::Scene scene;
  model::NodeId group;
  model::NodeId near;
  model::NodeId far;

  Balls() {
    group = scene.append({.name = "balls"});
    near = scene.append({.parent = group,
                         .name = "near",
                         .mesh = test::moved(*test::sphere(30.0f, 4), 1.0f, {0.0f, -80.0f, 0.0f})});
    far = scene.append({.parent = group,
                        .name = "far",
                        .mesh = test::moved(*test::sphere(30.0f, 4), 1.0f, {90.0f, 0.0f, 0.0f})});
    scene.appendAnnotation({.anchors = {model::SurfacePoint{.structure = near}},
                            .text = "near",
                            .texts = {},
                            .colour = {},
                            .found = true,
                            .offset = {}});
    model::View view{.name = "left",
                     .camera = model::anatomicalCamera(model::AnatomicalView::left,
                                                       scene.visibleBounds(), 4.0f / 3.0f)};
    model::Style hidden;
    hidden.visible = false;
    view.looks = {{{.node = far, .style = hidden, .unread = {}}}};
    scene.setViews({view});
  }

  std::unique_ptr<PageEngine> engine() const {
    auto made = std::make_unique<PageEngine>();
    made->setSize({800, 600, 1.0f});
    const model::PackedScene packed = model::packedScene(scene);
    if (!made->take(packed.first))
      qWarning("the scene was not taken");
    return made;
  }
};

}  // namespace

class PageEngineTest : public QObject {
  Q_OBJECT
 private slots:
  void opensOnTheFirstView() {
    const Balls balls;
    const auto made = balls.engine();
    PageEngine& engine = *made;
    QVERIFY(engine.visible(balls.near));
    QVERIFY(!engine.visible(balls.far));
    QCOMPARE(model::nearestAnatomicalView(engine.camera()), model::AnatomicalView::left);
  }

  void fliesToAView() {
    const Balls balls;
    const auto made = balls.engine();
    PageEngine& engine = *made;
    const model::Camera there = engine.camera();
    engine.look(model::AnatomicalView::anterior);
    engine.goTo(0, 0.0);
    engine.goTo(0, 0.5);
    QVERIFY(engine.camera() != there);
    engine.goTo(0, 1.0);
    QVERIFY(glm::length(engine.camera().eye - there.eye) < 0.01f);
    engine.goTo(7, 1.0);  // there is none
    QVERIFY(glm::length(engine.camera().eye - there.eye) < 0.01f);
  }

  void gammaIsOfAllInAGroup() {
    const Balls balls;
    const auto made = balls.engine();
    PageEngine& engine = *made;
    const float before = engine.gamma(balls.near);
    engine.setGamma({{balls.group}}, 4.5f);
    QCOMPARE(engine.gamma(balls.near), 4.5f);
    QCOMPARE(engine.gamma(balls.far), 4.5f);
    engine.setGamma({{balls.far}}, 77.0f);
    QCOMPARE(engine.gamma(balls.far), 5.0f);
    engine.resetLook();
    QCOMPARE(engine.gamma(balls.near), before);
    engine.setGamma({{model::NodeId{4711}}}, 1.0f);  // there is none
    QCOMPARE(engine.gamma(balls.near), before);
  }

  void eyesOpenAndClose() {
    const Balls balls;
    const auto made = balls.engine();
    PageEngine& engine = *made;
    engine.setVisible({{balls.far}}, true);
    QVERIFY(engine.visible(balls.far));
    engine.setVisible({{balls.group}}, false);
    QVERIFY(!engine.visible(balls.near));
    engine.resetLook();
    QVERIFY(engine.visible(balls.near));
    QVERIFY(!engine.visible(balls.far));
  }

  void whatIsSetStaysWhenTheRestComes() {
    const Balls balls;
    const model::PackedScene packed = model::packedScene(balls.scene, {.later = {balls.far}});
    PageEngine engine;
    engine.setSize({800, 600, 1.0f});
    QVERIFY(engine.take(packed.first).ok());
    QCOMPARE(engine.shown().find(balls.far)->mesh->triangleCount(), std::size_t(0));
    engine.setGamma({{balls.near}}, 3.5f);
    engine.orbit({100.0f, 0.0f});
    const model::Camera camera = engine.camera();
    QVERIFY(engine.take(packed.rest).ok());
    QVERIFY(engine.shown().find(balls.far)->mesh->triangleCount() > 0);
    QCOMPARE(engine.gamma(balls.near), 3.5f);
    QVERIFY(engine.camera() == camera);
  }

  /// What is done last holds, before and after the rest of the scene comes.
  void eyesKeepTheOrderOfTime_data() {
    QTest::addColumn<QString>("done");  // N: near, F: far, G: their group; + shows, - hides
    QTest::addColumn<QString>("seen");
    QTest::newRow("hidden") << "F-"
                            << "N";
    QTest::newRow("group hidden") << "G-"
                                  << "";
    QTest::newRow("one of a hidden group") << "G-N+"
                                           << "N";
    QTest::newRow("all after one") << "N-G+"
                                   << "NF";
    QTest::newRow("hidden again") << "F-F+F-"
                                  << "N";
    QTest::newRow("one after all") << "N-F-G+N-"
                                   << "F";
    QTest::newRow("group last") << "F-N-F+G-"
                                << "";
  }
  void eyesKeepTheOrderOfTime() {
    QFETCH(QString, done);
    QFETCH(QString, seen);
    Balls balls;
    balls.scene.setViews({});
    const model::PackedScene packed = model::packedScene(balls.scene, {.later = {balls.far}});
    PageEngine engine;
    QVERIFY(engine.take(packed.first).ok());
    for (qsizetype i = 0; i < done.size(); i += 2) {
      const model::NodeId id = done[i] == 'N'   ? balls.near
                               : done[i] == 'F' ? balls.far
                                                : balls.group;
      engine.setVisible({{id}}, done[i + 1] == '+');
    }
    const auto shown = [&] {
      return QString(engine.visible(balls.near) ? "N" : "") +
             (engine.visible(balls.far) ? "F" : "");
    };
    QCOMPARE(shown(), seen);
    QVERIFY(engine.take(packed.rest).ok());
    QCOMPARE(shown(), seen);
  }

  void refusesWhatIsNoScene() {
    PageEngine engine;
    const Status taken = engine.take("nothing of the kind");
    QVERIFY(!taken.ok());
    QVERIFY(!taken.error().reason.empty());
  }

  void picksWhatIsSeen() {
    const Balls balls;
    const auto made = balls.engine();
    PageEngine& engine = *made;
    engine.setVisible({{balls.far}}, true);
    engine.setGamma({{balls.group}}, 5.0f);
    engine.look(model::AnatomicalView::anterior);
    engine.fit({{balls.near}});
    QCOMPARE(engine.pick({400.0f, 300.0f}).structure, balls.near);
    QCOMPARE(engine.pick({2.0f, 2.0f}).structure, model::NodeId{});
  }

  void zoomKeepsWhatIsUnderTheFinger() {
    const Balls balls;
    const auto made = balls.engine();
    PageEngine& engine = *made;
    engine.setGamma({{balls.group}}, 5.0f);
    engine.look(model::AnatomicalView::anterior);
    engine.setVisible({{balls.far}}, true);
    const model::Camera before = engine.camera();
    engine.zoom(2.0f, {400.0f, 300.0f});
    QVERIFY(glm::length(engine.camera().eye - engine.camera().target) <
            0.6f * glm::length(before.eye - before.target) + 1.0f);
    for (int i = 0; i < 100; ++i)
      engine.zoom(2.0f, {400.0f, 300.0f});
    QVERIFY(!model::cameraFault(engine.camera()));
  }

  void labelsStandInThePicture() {
    const Balls balls;
    const auto made = balls.engine();
    PageEngine& engine = *made;
    engine.layOutLabels(false);
    QVERIFY(engine.labels().labels.empty());
    const model::AnnotationId id = engine.shown().annotations().front().id;
    engine.setLabels({{id, {60.0f, 20.0f}}});
    engine.layOutLabels(false);
    QCOMPARE(engine.labels().labels.size(), std::size_t(1));
    const render::LabelBox box = engine.labels().labels.front().box;
    const glm::vec2 size = PageEngine::millimetres * glm::vec2(800.0f, 600.0f);
    QVERIFY(box.low.x >= 0.0f && box.low.y >= 0.0f && box.high.x <= size.x && box.high.y <= size.y);
    const glm::vec2 middle = box.middle() / PageEngine::millimetres;
    QCOMPARE(engine.pick(middle).label, id);
    // The dot at the leader's end is the label's, whatever lines pass there.
    const render::PlacedLabel& placed = engine.labels().labels.front();
    QVERIFY(!placed.hidden && !placed.leader.empty());
    const glm::vec2 dot = placed.leader.front() / PageEngine::millimetres;
    QCOMPARE(engine.pick(dot + glm::vec2(2.0f, -1.0f)).label, id);
    QCOMPARE(engine.pick(dot + glm::vec2(12.0f, 0.0f)).label, model::AnnotationId{});
  }

  /// Labels that were found for a page stand in the pictures that show what they name, and nowhere
  /// else; while the scene turns none is added.
  void labelsOfWhatIsSeen() {
    Balls balls;
    balls.scene.setViews({});
    // From the front the near one hides the far one.
    std::vector<model::Node> nodes = balls.scene.nodes();
    nodes[2].mesh = test::moved(*test::sphere(20.0f, 4), 1.0f, {0.0f, 80.0f, 0.0f});
    for (model::Node& node : nodes)
      node.style.gamma = Gamma::clamped(5.0f);
    balls.scene.setAnnotations({});
    balls.scene.setNodes(nodes);
    for (const model::NodeId id : {balls.near, balls.far}) {
      model::Annotation label{.text = "ball", .found = true};
      label.anchors = {model::SurfacePoint{.structure = id}};
      balls.scene.appendAnnotation(label);
    }
    const auto made = balls.engine();
    PageEngine& engine = *made;
    engine.look(model::AnatomicalView::anterior);
    std::vector<TextRoom> rooms;
    for (const model::Annotation& label : engine.shown().annotations())
      rooms.push_back({label.id, {60.0f, 20.0f}});
    const auto standing = [&](bool moving) {
      engine.layOutLabels(moving);
      QString all;
      for (const render::PlacedLabel& label : engine.labels().labels)
        all += (label.id == rooms[0].id ? "near" : "far") + QString(label.hidden ? "? " : " ");
      return all.trimmed();
    };
    engine.setLabels(rooms);
    QCOMPARE(standing(false), QString("near far?"));
    engine.setLabels(rooms, true);
    QCOMPARE(standing(false), QString("near"));
    engine.look(model::AnatomicalView::left);
    QVERIFY(!standing(true).contains("far"));
    QCOMPARE(standing(false), QString("near far"));
    // From either side each label stands on the side of what it names.
    for (const model::AnatomicalView side :
         {model::AnatomicalView::left, model::AnatomicalView::right}) {
      engine.look(side);
      QCOMPARE(standing(false), QString("near far"));
      for (std::size_t i = 0; i < 2; ++i) {
        const render::PlacedLabel& label = engine.labels().labels[i];
        const float place = engine.labelItems()[i].places.front().x;
        const float middle = PageEngine::millimetres * 400.0f;
        QVERIFY((label.box.middle().x < middle) == (place < middle));
      }
    }
  }

  /// Without WebGL the page shows the pixels that a workstation without a card draws.
  void plainIsTheWorkstationsPicture_data() {
    QTest::addColumn<QString>("demo");
    QTest::addColumn<float>("gamma");
    QTest::newRow("pelvis, lines") << "pelvis" << 1.8f;
    QTest::newRow("kidney, hatched") << "kidney" << 2.6f;
    QTest::newRow("kidney, shaded") << "kidney" << 4.4f;
  }
  void plainIsTheWorkstationsPicture() {
    QFETCH(QString, demo);
    QFETCH(float, gamma);
    const auto name = model::demoNamed(demo.toStdString());
    QVERIFY(name);
    const model::PackedScene packed =
        model::packedScene(model::demo(*name, model::Sex::female, model::userCacheFolder()));
    PageEngine engine;
    engine.setSize({960, 720, 1.0f});
    engine.openPlainPicture();
    QVERIFY(engine.take(packed.first).ok());
    std::vector<model::NodeId> all;
    for (const model::Node& node : engine.shown().nodes())
      if (!node.isGroup())
        all.push_back(node.id);
    engine.setGamma(all, gamma);
    auto picture =
        render::HeadlessPicture::create({.painter = render::PictureOptions::Painter::processor});
    QVERIFY(picture.ok());
    const auto image =
        (*picture)->render(engine.shown(), engine.camera(), {.width = 960, .height = 720});
    QVERIFY(image.ok());
    const Result<bool> drawn = engine.draw(false);
    QVERIFY2(drawn.ok(), drawn.ok() ? "" : drawn.error().text().c_str());
    const std::span<const std::uint32_t> pixels = engine.pixels();
    QCOMPARE(4 * pixels.size(), image->rgba.size());
    std::size_t inked = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      for (std::size_t c = 0; c < 4; ++c)
        QCOMPARE(int(pixels[i] >> (8 * c) & 0xffu), int(image->rgba[4 * i + c]));
      inked += (pixels[i] & 0xffffffu) != 0xffffffu;
    }
    QVERIFY(inked > 5000);
  }

  /// What moves is coarser and smaller, as it takes, and whole again at rest.
  void plainPicturesKeepUp() {
    const model::PackedScene packed = model::packedScene(
        model::demo(*model::demoNamed("kidney"), model::Sex::female, model::userCacheFolder()));
    PageEngine engine;
    engine.setSize({640, 480, 1.0f});
    engine.openPlainPicture();
    QVERIFY(engine.take(packed.first).ok());
    for (int i = 0; i < 12; ++i) {
      engine.orbit({5.0f, 0.0f});
      QVERIFY(engine.draw(true).ok());
      engine.took(900.0);
    }
    QVERIFY(engine.scale(true) < 1.0f);
    QCOMPARE(engine.scale(false), 1.0f);
    const Result<bool> rested = engine.draw(false);
    QVERIFY(rested.ok() && *rested);
  }
};

SLINE_TEST(PageEngineTest)
#include "page_engine_test.moc"
