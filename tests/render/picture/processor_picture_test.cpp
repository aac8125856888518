// SPDX-License-Identifier: Apache-2.0
// Compares pictures that the processor draws (render/software), and those that a graphics card
// would be left to draw, with those of a software driver: all are the same, but for pixels whose
// middle lies on an edge.
#include <QImage>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "tests/render/picture/section_scenes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using render::Background;
using render::Image;
using render::PictureOptions;
using render::PictureSettings;

namespace {

using Change = std::function<void(model::Style&, int)>;

/// Returns bodies of several forms in, behind and through each other.
model::Scene bodies(float gamma, const Change& change) {
  model::Scene scene;
  auto put = [&, i = 0](model::MeshPtr mesh) mutable {
    model::Style style = gammaStyle(gamma);
    style.lineVariation = 1.0f;
    style.colour = Colour{std::uint8_t(60 + 30 * i), std::uint8_t(190 - 25 * i), 120};
    if (change)
      change(style, i);
    add(scene, std::move(mesh), style);
    ++i;
  };
  put(torus(50.0f, 20.0f, 120, 48));
  put(moved(*sphere(26.0f, 5), 1.0f, {18.0f, -30.0f, 12.0f}));
  put(moved(*sphere(30.0f, 3), 1.0f, {-40.0f, 40.0f, 5.0f}));
  put(moved(*torus(30.0f, 9.0f, 80, 32), 1.0f, {-20.0f, -20.0f, -20.0f}));
  put(moved(*sphere(12.0f, 4), 1.0f, {52.0f, -14.0f, -30.0f}));
  return scene;
}

model::Camera slanted(bool perspective) {
  model::Camera camera = frontal(190.0f);
  camera.eye = {60.0f, -320.0f, 170.0f};
  if (perspective)
    camera.projection = model::Projection::perspective;
  return camera;
}

struct Row {
  const char* name;
  float gamma;
  Change change = {};
  PictureSettings settings = {};
  bool perspective = false;
};

std::vector<Row> rows() {
  const auto moving = [](int step) {
    PictureSettings settings;
    settings.surfaceStep = step;
    return settings;
  };
  const auto ground = [](Background background, bool key = false) {
    PictureSettings settings;
    settings.environment.background = background;
    settings.environment.keyLight = key;
    return settings;
  };
  const Change mixed = [](model::Style& style, int i) {
    style.gamma = Gamma::clamped(1.2f * float(i));
  };
  return {
      {"silhouettes", 0.0f},
      {"lines", 2.0f},
      {"lines in perspective", 2.0f, {}, {}, true},
      {"hatching", 3.0f},
      {"shading enters", 3.4f},
      {"shading on a dark ground", 3.6f, {}, ground(Background::dark)},
      {"complete", 5.0f},
      {"complete, lit by a key light, in perspective",
       5.0f,
       {},
       ground(Background::paper, true),
       true},
      {"edges of fills", 4.6f, {}, ground(Background::transparent)},
      {"each of its own", 0.0f, mixed},
      {"each of its own, moving", 0.0f, mixed, moving(3), true},
      {"moving by two", 4.4f, {}, moving(2)},
      {"paper, tint and veil", 2.0f,
       [](model::Style& style, int i) { style.fill = model::Fill(1 + i % 3); }},
      {"glass", 5.0f,
       [](model::Style& style, int i) {
         style.opacity = Opacity::clamped(0.3f + 0.1f * float(i));
       }},
      {"hidden outlines", 2.0f,
       [](model::Style& style, int i) {
         style.fill = model::Fill::paper;
         style.hiddenLines = model::HiddenLines(1 + i % 2);
       }},
      {"halos", 2.0f, [](model::Style& style, int) { style.halo = 2.0f; }},
      {"pencils", 2.5f, [](model::Style& style, int) { style.grain = 0.8f; }},
  };
}

}  // namespace

class ProcessorPictureTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    m_driver = openStudio({.painter = PictureOptions::Painter::driver});
    if (!m_driver.absent.empty())
      QSKIP(m_driver.absent.c_str());
    QVERIFY2(m_driver.fault.empty(), m_driver.fault.c_str());
    auto picture = render::Picture::create({.painter = PictureOptions::Painter::processor});
    QVERIFY(picture.ok());
    m_processor = std::move(*picture);
    auto card = render::Picture::create({.painter = PictureOptions::Painter::card});
    QVERIFY(card.ok());
    m_card = std::move(*card);
  }

  /// Otherwise the comparisons below would compare one with itself.
  void eachDrawsInItsOwnWay() {
    const auto inksOnTheDriver = [](render::Picture& picture) {
      const auto drawn =
          picture.render(bodies(2.0f, {}), slanted(false), {.width = 500, .height = 420});
      const auto& passes = picture.timings().passes;
      return drawn.ok() && std::any_of(passes.begin(), passes.end(),
                                       [](const auto& pass) { return pass.name == "ink"; });
    };
    QVERIFY(inksOnTheDriver(*m_driver.picture));
    QVERIFY(inksOnTheDriver(*m_card));
    QVERIFY(!inksOnTheDriver(*m_processor));
  }

  void isThatOfTheDriver_data() {
    QTest::addColumn<int>("row");
    const std::vector<Row> all = rows();
    for (std::size_t i = 0; i < all.size(); ++i)
      QTest::newRow(all[i].name) << int(i);
  }

  void isThatOfTheDriver() {
    QFETCH(int, row);
    const Row r = rows()[std::size_t(row)];
    PictureSettings settings = r.settings;
    settings.width = 500;
    settings.height = 420;
    compare(bodies(r.gamma, r.change), slanted(r.perspective), settings);
  }

  void cutStructuresAreAmongTheOthers_data() {
    QTest::addColumn<float>("gamma");
    QTest::addColumn<int>("step");
    QTest::addColumn<bool>("hatched");
    QTest::addColumn<bool>("perspective");
    QTest::newRow("lines alone") << 2.0f << 1 << false << false;
    QTest::newRow("shaded") << 4.2f << 1 << false << true;
    QTest::newRow("hatched faces") << 3.6f << 1 << true << true;
    QTest::newRow("moving") << 3.6f << 3 << true << true;
  }

  void cutStructuresAreAmongTheOthers() {
    QFETCH(float, gamma);
    QFETCH(int, step);
    QFETCH(bool, hatched);
    QFETCH(bool, perspective);
    model::Scene scene = bodies(gamma, {});
    cut(scene, model::AnatomicalView::posterior, 0.0f, scene.nodes()[1].id);
    cut(scene, model::AnatomicalView::left, 8.0f, scene.nodes()[0].id);
    cut(scene, model::AnatomicalView::posterior, -20.0f, scene.nodes()[0].id);
    std::vector<model::Section> sections = scene.sections();
    for (model::Section& section : sections)
      section.hatched = hatched;
    scene.setSections(sections);
    PictureSettings settings{.width = 500, .height = 420, .surfaceStep = step};
    compare(scene, slanted(perspective), settings);
  }

  /// Noise is drawn pixel by pixel, and by the driver; the others are as before.
  void noiseIsAmongTheOthers() {
    model::Scene scene = bodies(3.0f, [](model::Style& style, int i) {
      if (i == 1)
        style.technique = model::Technique::noiseLic;
    });
    compare(scene, slanted(false), {.width = 500, .height = 420});
  }

  /// Only what has changed is drawn anew, and a driver takes over what it needs.
  void layersAreKept() {
    model::Scene scene = bodies(2.0f, {});
    const PictureSettings settings{.width = 500, .height = 420};
    const model::Camera camera = slanted(false);
    QVERIFY(m_processor->render(scene, camera, settings).ok());
    std::vector<model::Node> nodes = scene.nodes();
    nodes[1].style.gamma = Gamma::clamped(4.2f);
    scene.setNodes(nodes);
    compare(scene, camera, settings);
    QCOMPARE(m_processor->timings().layersDrawn, 1);
    nodes[2].style.visible = false;
    scene.setNodes(nodes);
    compare(scene, camera, settings);
    QCOMPARE(m_processor->timings().layersDrawn, 0);
  }

  void piecesHaveNoSeams() {
    const model::Scene scene = bodies(3.5f, {});
    const model::Camera camera = slanted(true);
    const PictureSettings settings{.width = 500, .height = 420};
    const auto whole = m_processor->render(scene, camera, settings);
    auto small = render::Picture::create(
        {.maximumSide = 160, .painter = PictureOptions::Painter::processor});
    QVERIFY(whole.ok() && small.ok());
    const auto pieces = (*small)->render(scene, camera, settings);
    QVERIFY(pieces.ok());
    QCOMPARE(difference(*whole, *pieces).largest, 0);
  }

  /// Of a mesh that is much finer than the samples, clusters are drawn as discs while the camera
  /// moves; lines stay as they are.
  void fineMeshesMoveAsDiscs() {
    model::Scene scene;
    model::Style style = gammaStyle(4.5f);
    style.colour = Colour{200, 120, 80};
    add(scene, sphere(14.0f, 7), style);
    const PictureSettings settings{.width = 500, .height = 420, .surfaceStep = 4};
    compare(scene, slanted(true), settings);
  }

  void whatIsHiddenIsLeftOutWhileMoving_data() {
    QTest::addColumn<float>("gamma");
    QTest::addColumn<bool>("perspective");
    QTest::newRow("lines in perspective") << 2.0f << true;
    QTest::newRow("hatching in perspective") << 3.0f << true;
    QTest::newRow("shaded, in perspective") << 4.6f << true;
  }

  /// What lies behind something opaque is not drawn, and what juts out is; both appear when that
  /// is seen through.
  void whatIsHiddenIsLeftOutWhileMoving() {
    QFETCH(float, gamma);
    QFETCH(bool, perspective);
    const auto paper = [](model::Style& style, int) { style.fill = model::Fill::paper; };
    model::Scene scene = bodies(gamma, paper);
    model::Style style = gammaStyle(gamma);
    paper(style, 0);
    const glm::vec3 front = 0.35f * slanted(false).eye;
    add(scene, moved(*sphere(60.0f, 6), 1.0f, front), style);
    const std::size_t all = scene.structuresBelow(model::rootId).size();
    const PictureSettings settings{.width = 500, .height = 420, .surfaceStep = 3};
    for (const float right : {0.0f, 15.0f, 40.0f}) {
      model::Camera camera = slanted(perspective);
      camera.eye.x += right;
      compare(scene, camera, settings);
      if (right == 0.0f)
        QVERIFY(m_processor->timings().layersDrawn < int(all));
      std::vector<model::Node> nodes = scene.nodes();
      nodes.back().style.opacity = Opacity::clamped(0.0f);
      nodes.back().style.fill = model::Fill::none;
      model::Scene without = scene;
      without.setNodes(nodes);
      compare(without, camera, settings);
      // What hid nothing in the picture before is kept.
      compare(without, camera, settings);
      QCOMPARE(m_processor->timings().layersDrawn, 0);
      compare(scene, camera, settings);
    }
  }

  void whatShowsThroughStaysWhileMoving_data() {
    QTest::addColumn<int>("hiddenLines");
    QTest::addColumn<float>("halo");
    QTest::newRow("thin") << int(model::HiddenLines::thin) << 0.0f;
    QTest::newRow("dashed") << int(model::HiddenLines::dashed) << 0.0f;
    QTest::newRow("thin, with a halo") << int(model::HiddenLines::thin) << 2.0f;
  }

  /// A structure without a fill of which all else is hidden.
  void whatShowsThroughStaysWhileMoving() {
    QFETCH(int, hiddenLines);
    QFETCH(float, halo);
    model::Scene scene;
    add(scene, sphere(60.0f, 6), gammaStyle(5.0f));
    model::Style within = gammaStyle(2.0f);
    within.hiddenLines = model::HiddenLines(hiddenLines);
    within.halo = halo;
    add(scene, torus(30.0f, 12.0f, 120, 48), within);
    const PictureSettings settings{.width = 500, .height = 420, .surfaceStep = 3};
    compare(scene, slanted(true), settings);
    QVERIFY(farApart(scene, slanted(true), settings) < 10);
  }

  /// What shows nothing has memory that served another layer, of another size, and none of that is
  /// its own: the driver, which takes over where it draws one of the others, once read beyond its
  /// end.
  void whatShowsNothingIsNotGivenToTheDriver() {
    const PictureSettings whole{.width = 500, .height = 420};
    const model::Scene before = bodies(5.0f, {});
    const model::Scene scene = bodies(2.0f, [](model::Style& style, int i) {
      if (i != 1)
        return;
      style.technique = model::Technique::noiseLic;
      style.gamma = Gamma::clamped(3.0f);
    });
    PictureSettings tones = whole;
    tones.parts = {.lines = false, .hatching = true, .fills = false};
    model::Camera near = slanted(false);
    for (const float height : {400.0f, 60.0f, 300.0f, 30.0f}) {
      QVERIFY(m_processor->render(before, slanted(false), whole).ok());
      near.heightMm = height;
      compare(scene, near, tones);
    }
  }

  void whatReachesBehindTheEyeIsDrawnByTheDriver() {
    const model::Scene scene = bodies(5.0f, {});
    model::Camera camera = slanted(true);
    camera.eye = {10.0f, -45.0f, 10.0f};
    compare(scene, camera, {.width = 500, .height = 420});
  }

 private:
  /// Returns how many pixels clearly differ from the driver's.
  int farApart(const model::Scene& scene, const model::Camera& camera,
               const PictureSettings& settings) {
    const auto expected = m_driver.picture->render(scene, camera, settings);
    const auto found = m_processor->render(scene, camera, settings);
    if (!expected.ok() || !found.ok())
      return std::numeric_limits<int>::max();
    int count = 0;
    for (std::size_t i = 0; i < expected->rgba.size(); i += 4)
      count += std::abs(int(expected->rgba[i]) - int(found->rgba[i])) > 40 ? 1 : 0;
    return count;
  }

  void compare(const model::Scene& scene, const model::Camera& camera,
               const PictureSettings& settings) {
    const auto expected = m_driver.picture->render(scene, camera, settings);
    QVERIFY(expected.ok());
    compare(*expected, m_processor->render(scene, camera, settings), "processor");
    const auto byCard = m_card->render(scene, camera, settings);
    if (settings.surfaceStep == 1) {
      compare(*expected, byCard, "card");
      return;
    }
    // A card always draws as at rest.
    PictureSettings resting = settings;
    resting.surfaceStep = 1;
    const auto atRest = m_card->render(scene, camera, resting);
    QVERIFY(byCard.ok() && atRest.ok());
    QCOMPARE(byCard->rgba, atRest->rgba);
  }

  void compare(const Image& expected, const Result<Image>& found, const char* painter) {
    QVERIFY(found.ok());
    const Difference apart = difference(expected, *found);
    if (const QByteArray folder = qgetenv("SLINE_PICTURES"); !folder.isEmpty()) {
      const QString name = QString(folder + "/%1 %2 %3.png")
                               .arg(QTest::currentTestFunction(), QTest::currentDataTag(), painter);
      const auto save = [](const Image& image, const QString& to) {
        QImage(image.rgba.data(), image.width, image.height, QImage::Format_RGBA8888).save(to);
      };
      save(expected, QString(name).replace(painter, "driver"));
      save(*found, name);
    }
    QVERIFY2(apart.share < 0.002 && apart.mean < 0.2,
             qPrintable(QString("%1: %2 % of pixels, mean %3, largest %4")
                            .arg(painter)
                            .arg(100.0 * apart.share)
                            .arg(apart.mean)
                            .arg(apart.largest)));
  }

  Studio m_driver;
  std::unique_ptr<render::Picture> m_processor;
  std::unique_ptr<render::Picture> m_card;
};

SLINE_TEST(ProcessorPictureTest)
#include "processor_picture_test.moc"
