// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/film.h"
#include "render/export/motion/subtitles.h"

#include <QtTest>
#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "model/edit/views.h"
#include "model/focus/context.h"
#include "render/export/motion/film_options.h"
#include "render/export/motion/gif_palette.h"
#include "render/labels/seen/screen.h"
#include "render/labels/seen/sight.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using render::Film;
using render::Motion;

namespace {

model::NodeId add(model::Scene& scene, const std::string& name, const model::MeshPtr& mesh) {
  model::Node node;
  node.name = name;
  node.mesh = mesh;
  return scene.append(std::move(node));
}

/// Returns a long object seen from the side on which it is short: turning, it needs more room.
render::ExportOrder longOrder(model::AnatomicalView view = model::AnatomicalView::left) {
  render::ExportOrder order;
  for (const float x : {-90.0f, 0.0f, 90.0f})
    add(order.scene, "ball", test::moved(*test::sphere(15.0f, 2), 1.0f, {x, 0.0f, 0.0f}));
  order.camera = model::anatomicalCamera(view, order.scene.visibleBounds(), 16.0f / 9.0f);
  order.viewName = "left";
  order.of<render::FilmOptions>().seconds = 2.0;
  order.of<render::FilmOptions>().format = render::FilmFormat::page;
  order.of<render::FilmOptions>().framesPerSecond = 18;
  return order;
}

render::ExportOrder tourOrder() {
  render::ExportOrder order = longOrder();
  model::View front{.name = "Front", .camera = {}};
  front.looks = {{order.scene.nodes()[0].id, {.gamma = Gamma::clamped(1.0f)}, {}}};
  model::View side{.name = "Side", .camera = order.camera};
  side.looks = {{order.scene.nodes()[0].id, {.gamma = Gamma::clamped(4.0f)}, {}}};
  model::View back{.name = "Back", .camera = {.eye = {0.0f, 900.0f, 0.0f}}};
  order.scene.setViews({front, side, back});
  order.of<render::FilmOptions>() = {
      .motion = Motion::tour, .seconds = 10.0, .framesPerSecond = 10, .hold = 2.0};
  return order;
}

float gammaIn(const render::FilmFrame& frame, std::size_t node = 0) {
  return frame.scene.resolve(frame.scene.nodes()[node].id).gamma.value();
}

/// Tells whether all points lie within the picture, less a margin on all sides.
bool allInside(const render::FilmFrame& frame, const glm::vec2& size,
               const glm::vec2& margin = glm::vec2(0.0f)) {
  const render::Screen screen(frame.camera, size);
  for (const model::Node& node : frame.scene.nodes())
    for (const glm::vec3& p : node.mesh->positions())
      if (const auto place = screen.place(p); !place || place->x < margin.x ||
                                              place->y < margin.y || place->x > size.x - margin.x ||
                                              place->y > size.y - margin.y)
        return false;
  return true;
}

}  // namespace

class FilmTest : public QObject {
  Q_OBJECT

 private slots:
  void turntableGoesRoundEvenly() {
    const render::ExportOrder order = longOrder(model::AnatomicalView::anterior);
    const Film film = std::move(Film::create(order)).value();
    QCOMPARE(film.frames(), 36);
    QVERIFY(film.loops());
    QVERIFY(film.size() == glm::ivec2(1280, 720));
    const glm::vec3 first = film.at(0).camera.eye - film.at(0).camera.target;
    // The patient's left comes before the right, and the seam is a step like any other.
    QVERIFY(film.at(9).camera.eye.x > 100.0f);
    QVERIFY(film.at(27).camera.eye.x < -100.0f);
    for (int i = 0; i < 36; ++i) {
      const auto way = [&film](int frame) {
        const model::Camera camera = film.at(frame % 36).camera;
        return glm::normalize(camera.eye - camera.target);
      };
      QVERIFY(std::abs(glm::dot(way(i), way(i + 1)) - std::cos(glm::radians(10.0f))) < 1e-4f);
      const model::Camera camera = film.at(i).camera;
      QVERIFY(std::abs(glm::length(camera.eye - camera.target) - glm::length(first)) < 1e-2f);
      QVERIFY(std::abs(camera.eye.z - film.at(0).camera.eye.z) < 1e-3f);
    }
    QVERIFY(film.at(0).camera == film.at(36).camera);
    // A name that flashes up once would be no help.
    QVERIFY(film.at(0).viewName.empty());
  }

  /// Each view's words are the frames' as long as its name is, and so are the subtitles.
  void viewsSayWords() {
    render::ExportOrder order = tourOrder();
    std::vector<model::View> views = order.scene.views();
    views[0].words.text = {"From *the front* & <i>not</i> --> here\n\n- one", {{"de", "Von vorn"}}};
    views[2].words.title = {"Behind", {}};
    order.scene.setViews(views);
    const Film film = std::move(Film::create(order)).value();
    for (int frame = 0; frame < film.frames(); ++frame) {
      const render::FilmFrame shown = film.at(frame);
      const auto view = std::find_if(views.begin(), views.end(), [&](const model::View& each) {
        return each.name == shown.viewName;
      });
      QVERIFY(view != views.end() && shown.words == view->words);
      const double time = double(frame) / 10.0;
      for (const render::FilmCue& cue : film.cues())
        if (time > cue.begin + 1e-6 && time < cue.end - 1e-6)
          QVERIFY(cue.words == shown.words);
    }
    QCOMPARE(QString::fromStdString(render::webVtt(film, "")),
             QString("WEBVTT\n\n00:00:00.000 --> 00:00:03.000\nFrom <i>the front</i> &amp; "
                     "&lt;i&gt;not&lt;/i&gt; --&gt; here\n\u2022 one\n\n"
                     "00:00:07.000 --> 00:00:10.000\n<b>Behind</b>\n"));
    QVERIFY(render::webVtt(film, "de+la").find("\nVon vorn\n") != std::string::npos);
    order.of<render::FilmOptions>().motion = Motion::turntable;
    QCOMPARE(render::webVtt(std::move(Film::create(order)).value(), ""), std::string("WEBVTT\n"));
  }

  /// A view that says how long it is shown is shown so long, others as the film rests.
  void viewsRestAsLongAsTheySay() {
    render::ExportOrder order = tourOrder();
    std::vector<model::View> views = order.scene.views();
    views[1].words.seconds = 4.0f;
    order.scene.setViews(views);
    const Film film = std::move(Film::create(order)).value();
    QVERIFY(!film.at(20).moving && film.at(25).moving);
    for (int frame = 30; frame <= 70; ++frame)
      QVERIFY(film.at(frame).camera == views[1].camera && film.at(frame).viewName == "Side");
    QVERIFY(film.at(75).moving && !film.at(80).moving);
    QVERIFY(film.at(99).camera == views[2].camera);
    views[0].words.seconds = 6.0f;
    order.scene.setViews(views);
    QVERIFY(!Film::create(order).ok());
  }

  void nothingLeavesThePicture() {
    for (const auto projection :
         {model::Projection::perspective, model::Projection::orthographic}) {
      render::ExportOrder order = longOrder();
      order.camera.projection = projection;
      order.camera.heightMm = 40.0f;
      order.page.sizeMm = {100.0f, 100.0f};
      const Film film = std::move(Film::create(order)).value();
      QVERIFY(!(film.at(0).camera == order.camera));
      // The object is in the middle, and no smaller than it must be.
      QVERIFY(glm::length(film.at(9).camera.target - film.at(27).camera.target) < 1.0f);
      bool full = false;
      for (int i = 0; i < film.frames(); ++i)
        full = full || !allInside(film.at(i), order.page.sizeMm, 0.08f * order.page.sizeMm);
      QVERIFY(full);
      for (int i = 0; i < film.frames(); ++i)
        QVERIFY2(allInside(film.at(i), order.page.sizeMm), qPrintable(QString::number(i)));
    }
  }

  /// The axis rests whichever way the camera is tilted.
  /// What is in focus is seen from all sides: what lies behind it where the film begins comes to
  /// lie before it, and is open then, in all frames alike. What was set by hand stays.
  void theFocusIsNeverHidden() {
    model::Scene scene;
    const model::NodeId target = add(scene, "bladder", test::sphere(20.0f, 3));
    std::vector<model::NodeId> around;
    for (const auto& [name, at] : {std::pair("sacrum", glm::vec3(0.0f, 70.0f, 0.0f)),
                                   {"left hip bone", glm::vec3(70.0f, 0.0f, 0.0f)},
                                   {"right hip bone", glm::vec3(-70.0f, 0.0f, 0.0f)}})
      around.push_back(add(scene, name, test::moved(*test::sphere(30.0f, 3), 1.0f, at)));
    render::ExportOrder order = longOrder(model::AnatomicalView::anterior);
    order.camera = model::anatomicalCamera(model::AnatomicalView::anterior, scene.visibleBounds(),
                                           16.0f / 9.0f);
    model::FormIndex forms;
    const std::array<model::NodeId, 1> asked{target};
    const auto analysis = model::analysed(scene, {.targets = asked, .camera = order.camera}, forms);
    QVERIFY(analysis);
    order.scene =
        model::withFocusAndContext(scene, *analysis, model::ContextAmount::clamped(0.7f)).scene;
    const auto hiddenFrames = [&] {
      const Film film = std::move(Film::create(order)).value();
      int hidden = 0;
      for (int i = 0; i < film.frames(); ++i) {
        const render::FilmFrame frame = film.at(i);
        if (!(frame.scene == film.at(0).scene))
          return -1;
        model::MeshTrees trees;
        const render::Sights sights(frame.scene, trees);
        const glm::vec3 way = glm::normalize(-frame.camera.eye);
        const auto hit = sights.nearest({.origin = frame.camera.eye, .direction = way});
        hidden += hit && hit->structure == target ? 0 : 1;
      }
      return hidden;
    };
    QCOMPARE(hiddenFrames(), 0);
    std::vector<model::Node> nodes = order.scene.nodes();
    for (model::Node& node : nodes)
      if (node.id == around[1])
        node.style.gamma = Gamma::clamped(5.0f);
    order.scene.setNodes(std::move(nodes));
    QVERIFY(hiddenFrames() > 0);
  }

  void theAxisRests() {
    for (const bool close : {false, true}) {
      render::ExportOrder order = longOrder();
      const glm::vec3 centre = order.camera.target;
      order.camera.eye = centre + glm::vec3(close ? 60.0f : 420.0f, -90.0f, 130.0f);
      order.camera.up = {0.1f, 0.3f, 0.9f};
      const Film film = std::move(Film::create(order)).value();
      for (const float height : {-8.0f, 0.0f, 8.0f}) {
        const auto placeIn = [&](int frame) {
          return *render::Screen(film.at(frame).camera, order.page.sizeMm)
                      .place(centre + glm::vec3(0.0f, 0.0f, height));
        };
        for (int i = 1; i < film.frames(); ++i)
          QVERIFY2(glm::distance(placeIn(i), placeIn(0)) < 0.02f,
                   qPrintable(QString("%1: %2").arg(i).arg(close)));
      }
    }
  }

  void whatHasRoomOrIsCloseStays() {
    render::ExportOrder order = longOrder(model::AnatomicalView::anterior);
    QVERIFY(std::move(Film::create(order)).value().at(0).camera == order.camera);
    order.camera.eye = order.camera.target + 0.2f * (order.camera.eye - order.camera.target);
    QVERIFY(std::move(Film::create(order)).value().at(0).camera == order.camera);
  }

  void fromAboveItTumbles() {
    const Film film = std::move(Film::create(longOrder(model::AnatomicalView::superior))).value();
    const model::Camera camera = film.at(9).camera;
    QVERIFY(std::abs(glm::normalize(camera.eye - camera.target).z) < 0.01f);
  }

  void tourRestsAndMoves() {
    const render::ExportOrder order = tourOrder();
    const Film film = std::move(Film::create(order)).value();
    QCOMPARE(film.frames(), 100);
    QVERIFY(!film.loops());
    // The film stays 2 s at each of three views and takes 2 s on each way.
    const std::vector<model::View>& views = order.scene.views();
    for (const auto& [frame, view] :
         {std::pair(0, 0), {20, 0}, {40, 1}, {60, 1}, {80, 2}, {99, 2}}) {
      QVERIFY2(film.at(frame).camera == views[std::size_t(view)].camera,
               qPrintable(QString::number(frame)));
      QCOMPARE(film.at(frame).viewName, views[std::size_t(view)].name);
    }
    QCOMPARE(gammaIn(film.at(0)), 1.0f);
    QCOMPARE(gammaIn(film.at(30)), 2.5f);
    QCOMPARE(gammaIn(film.at(50)), 4.0f);
    QVERIFY(film.at(60).scene == model::withViewApplied(order.scene, views[1]).scene);
    // The camera flies on an arc: halfway from the front to the left the eye is between, and as far
    // away.
    const model::Camera half = film.at(30).camera;
    QVERIFY(half.eye.x > 100.0f && half.eye.y < -100.0f);
  }

  void sweepGoesFrom0To5() {
    render::ExportOrder order = longOrder();
    order.of<render::FilmOptions>() = {
        .motion = Motion::gammaSweep, .seconds = 1.2, .framesPerSecond = 10, .swept = {}};
    const Film all = std::move(Film::create(order)).value();
    QCOMPARE(all.frames(), 12);
    QCOMPARE(gammaIn(all.at(0)), 0.0f);
    QCOMPARE(gammaIn(all.at(11)), 5.0f);
    float before = 0.0f;
    for (int i = 0; i < 12; ++i) {
      QVERIFY(gammaIn(all.at(i)) >= before);
      before = gammaIn(all.at(i));
      QCOMPARE(gammaIn(all.at(i), 2), before);
      QVERIFY(all.at(i).camera == order.camera);
    }
    order.of<render::FilmOptions>().swept = {order.scene.nodes()[1].id};
    const Film one = std::move(Film::create(order)).value();
    QCOMPARE(gammaIn(one.at(11), 1), 5.0f);
    QCOMPARE(gammaIn(one.at(11), 0), 2.0f);
  }

  void refuses_data() {
    QTest::addColumn<render::FilmOptions>("film");
    QTest::addColumn<QString>("reason");
    const auto row = [](const char* name, const render::FilmOptions& film, const char* reason) {
      QTest::newRow(name) << film << QString(reason);
    };
    row("no time", {.seconds = 0.0}, "0.1 to 600");
    row("not a number", {.seconds = std::nan("")}, "0.1 to 600");
    row("too long", {.seconds = 601.0}, "0.1 to 600");
    row("too slow", {.framesPerSecond = 0}, "1 to 60");
    row("too fast", {.framesPerSecond = 61}, "1 to 60");
    row("too small", {.format = render::FilmFormat::page, .height = 2}, "4 × 2 pixels");
    row("too large", {.format = render::FilmFormat::page, .height = 4000}, "pixels");
    row("no views", {.motion = Motion::tour}, "no saved views");
    row("rests too long", {.motion = Motion::gammaSweep, .seconds = 4.0, .hold = 2.0},
        "rests of 2.0 seconds");
  }
  void refuses() {
    QFETCH(render::FilmOptions, film);
    QFETCH(QString, reason);
    render::ExportOrder order = longOrder();
    order.of<render::FilmOptions>() = film;
    const auto refused = Film::create(order);
    QVERIFY(!refused.ok());
    QVERIFY2(refused.error().reason.find(reason.toStdString()) != std::string::npos,
             refused.error().reason.c_str());
    QVERIFY(!refused.error().remedy.empty());
  }

  void sizes_data() {
    using render::FilmFormat;
    QTest::addColumn<render::FilmOptions>("film");
    QTest::addColumn<QSize>("size");
    const auto row = [](const char* name, const render::FilmOptions& film, const QSize& size) {
      QTest::newRow(name) << film << size;
    };
    row("none said", {}, {1280, 720});
    row("full", {.format = FilmFormat::fullHd, .width = 10, .height = 10}, {1920, 1080});
    row("square", {.format = FilmFormat::square}, {1080, 1080});
    row("typed", {.format = FilmFormat::typed, .width = 641, .height = 360}, {642, 360});
    row("the page's", {.format = FilmFormat::page, .width = 10, .height = 300}, {200, 300});
  }
  void sizes() {
    QFETCH(render::FilmOptions, film);
    QFETCH(QSize, size);
    render::ExportOrder order = longOrder();
    order.page.sizeMm = {100.0f, 150.0f};
    order.of<render::FilmOptions>() = film;
    QCOMPARE(render::filmSize(order), glm::ivec2(size.width(), size.height()));
    QCOMPARE(std::move(Film::create(order)).value().size(), render::filmSize(order));
    // Letters and lines are as large on every screen, whatever paper other kinds have.
    const glm::vec2 page = render::filmPageMm(order);
    QVERIFY(std::abs(std::min(page.x, page.y) - 106.0f) < 1e-3f);
    order.page.sizeMm *= 3.0f;
    QVERIFY(glm::length(render::filmPageMm(order) - page) < 1e-3f);
    QVERIFY(std::abs(page.x / page.y - float(size.width()) / float(size.height())) < 1e-4f);
  }

  void tourNeedsTwoViewsAndTime() {
    render::ExportOrder order = tourOrder();
    order.of<render::FilmOptions>().hold = 4.0;
    QVERIFY(!Film::create(order).ok());
    order.of<render::FilmOptions>().hold.reset();
    QVERIFY(Film::create(order).ok());
    order.scene.setViews({order.scene.views().front()});
    QVERIFY(!Film::create(order).ok());
  }

  void paletteHasFewColoursExactly() {
    render::Image image{.width = 64, .height = 1, .rgba = {}};
    for (int i = 0; i < 64; ++i)
      for (const int c : {4 * i, 255 - 4 * i, 7, 255})
        image.rgba.push_back(std::uint8_t(c));
    render::GifPalette palette = render::GifPalette::of({&image, 1});
    for (int i = 0; i < 64; ++i) {
      const render::GifPalette::Rgb c{std::uint8_t(4 * i), std::uint8_t(255 - 4 * i), 7};
      const auto found = palette.colours()[palette.index(c, i, i / 3)];
      for (std::size_t channel = 0; channel < 3; ++channel)
        QVERIFY(std::abs(int(found[channel]) - int(c[channel])) <= 4);
    }
  }

  void paletteOfManyIsNear() {
    // The image has all of a coarse cube of colours, and a ground that makes up most of it.
    render::Image image{.width = 4096 + 20000, .height = 1, .rgba = {}};
    for (int i = 0; i < 4096 + 20000; ++i)
      for (const int c : {i < 4096 ? 17 * (i % 16) : 251, i < 4096 ? 17 * (i / 16 % 16) : 247,
                          i < 4096 ? 17 * (i / 256) : 236, 255})
        image.rgba.push_back(std::uint8_t(c));
    render::GifPalette palette = render::GifPalette::of({&image, 1});
    QVERIFY(palette.colours().size() <= 255);
    QVERIFY(palette.colours().size() > 200);
    const render::GifPalette::Rgb ground{251, 247, 236};
    QVERIFY(palette.colours()[palette.index(ground, 3, 2)] == ground);
    double sum = 0.0;
    for (int i = 0; i < 4096; ++i) {
      const render::GifPalette::Rgb c{std::uint8_t(17 * (i % 16)), std::uint8_t(17 * (i / 16 % 16)),
                                      std::uint8_t(17 * (i / 256))};
      const auto found = palette.colours()[palette.index(c, 0, 0)];
      for (std::size_t channel = 0; channel < 3; ++channel)
        sum += std::abs(int(found[channel]) - int(c[channel]));
    }
    // 255 boxes of a cube of colours are some 40 wide, so a tenth on average is the best they can
    // do.
    QVERIFY2(sum / (3.0 * 4096.0) < 14.0, qPrintable(QString::number(sum / 12288.0)));
  }
};

SLINE_TEST_WITH_EVENTS(FilmTest)
#include "film_test.moc"
