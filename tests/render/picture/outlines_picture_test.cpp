// SPDX-License-Identifier: Apache-2.0
// Tests the lines around structures in a window's picture: the processor draws what a driver does,
// and keeps only what is still right.
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <optional>
#include <vector>

#include "tests/render/picture/section_scenes.h"
#include "tests/render/picture/target_pixels.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using render::Image;
using render::Outline;
using render::PictureOptions;
using render::PictureSettings;

namespace {

const PictureSettings settings{.width = 420, .height = 360};
const Colour ink{0, 90, 255};

/// A ring with a ball before it, one within it and one aside; and a large ball behind them, which
/// reaches out of narrow pictures.
model::Scene bodies(float gamma) {
  model::Scene scene;
  const auto put = [&](const model::MeshPtr& mesh, const Colour& colour) {
    model::Style style = gammaStyle(gamma);
    style.colour = colour;
    add(scene, mesh, style);
  };
  put(torus(50.0f, 20.0f, 120, 48), {200, 60, 60});
  put(moved(*sphere(26.0f, 5), 1.0f, {18.0f, -60.0f, 12.0f}), {60, 160, 60});
  put(moved(*sphere(12.0f, 4), 1.0f, {0.0f, 0.0f, 0.0f}), {160, 160, 40});
  put(moved(*sphere(12.0f, 4), 1.0f, {-70.0f, 0.0f, 40.0f}), {160, 60, 160});
  put(moved(*sphere(60.0f, 5), 1.0f, {20.0f, 120.0f, 0.0f}), {90, 90, 200});
  return scene;
}

std::vector<model::NodeId> idsOf(const model::Scene& scene, std::initializer_list<int> places) {
  std::vector<model::NodeId> ids;
  for (const int place : places)
    ids.push_back(scene.nodes()[std::size_t(place)].id);
  std::sort(ids.begin(), ids.end());
  return ids;
}

model::Camera slanted(float height, bool perspective) {
  model::Camera camera = frontal(height);
  camera.eye = {60.0f, -320.0f, 90.0f};
  if (perspective)
    camera.projection = model::Projection::perspective;
  return camera;
}

struct Row {
  const char* name;
  std::vector<std::vector<int>> outlined = {{0}};  ///< of each line, the structures' places
  float gamma = 4.2f;
  float height = 190.0f;  ///< of what the camera sees, mm
  bool perspective = false;
  bool cut = false;
  int surfaceStep = 1;
};

std::vector<Row> rows() {
  return {{.name = "one"},
          {.name = "lines alone", .gamma = 2.0f},
          {.name = "among others without lines", .gamma = 5.0f},
          {.name = "several", .outlined = {{0, 1, 2, 4}}},
          {.name = "two lines", .outlined = {{0, 3}, {1}}},
          {.name = "perspective", .outlined = {{0, 1}}, .perspective = true},
          {.name = "beyond the picture", .outlined = {{0, 4}}, .height = 70.0f},
          {.name = "far away", .outlined = {{0, 2, 3}}, .height = 2500.0f},
          {.name = "cut", .outlined = {{0, 4}}, .gamma = 3.6f, .cut = true},
          {.name = "moving", .outlined = {{0}, {2}}, .surfaceStep = 3}};
}

/// Draws pictures with lines as a window does.
class Window {
 public:
  explicit Window(PictureOptions::Painter painter, int maximumSide = 0)
      : m_picture(render::Picture::create({.maximumSide = maximumSide, .painter = painter})),
        m_pixels(settings) {}

  bool ok() const { return m_picture.ok() && m_pixels.ok(); }
  std::optional<Image> draw(const model::Scene& scene, const model::Camera& camera,
                            const std::vector<Outline>& outlines, int step = 1) {
    PictureSettings asked = settings;
    asked.surfaceStep = step;
    m_pixels.clear();
    const auto drawn =
        (*m_picture)
            ->drawInto({.target = m_pixels.target(), .outlines = outlines}, scene, camera, asked);
    if (!drawn.ok() || !*drawn)
      return std::nullopt;
    return m_pixels.image();
  }
  std::optional<Image> refine(const model::Scene& scene, const model::Camera& camera,
                              const std::vector<Outline>& outlines) {
    const auto drawn = (*m_picture)
                           ->refineInto({.target = m_pixels.target(), .outlines = outlines}, scene,
                                        camera, settings);
    if (!drawn.ok() || !*drawn)
      return std::nullopt;
    return m_pixels.image();
  }

 private:
  Result<std::unique_ptr<render::Picture>> m_picture;
  TargetPixels m_pixels;
};

/// Does so in memory, without a driver.
class PlainWindow {
 public:
  PlainWindow() : m_picture(render::Picture::withoutDriver({}, {})) {}

  template <class Draw>
  std::optional<Image> image(const Draw& draw) {
    m_pixels.assign(std::size_t(settings.width) * std::size_t(settings.height), 0);
    const Result<bool> drawn =
        draw(*m_picture, render::PictureTarget(settings.width, settings.height, m_pixels));
    if (!drawn.ok() || !*drawn)
      return std::nullopt;
    Image image{.width = settings.width, .height = settings.height, .rgba = {}};
    for (int y = settings.height - 1; y >= 0; --y)
      for (int x = 0; x < settings.width; ++x)
        for (int c = 0; c < 4; ++c)
          image.rgba.push_back(
              std::uint8_t(m_pixels[std::size_t(y * settings.width + x)] >> (8 * c)));
    return image;
  }

 private:
  std::unique_ptr<render::Picture> m_picture;
  std::vector<std::uint32_t> m_pixels;
};

int apart(const Image& a, const Image& b, std::size_t pixel) {
  int largest = 0;
  for (std::size_t c = 0; c < 4; ++c)
    largest = std::max(largest, std::abs(int(a.rgba[4 * pixel + c]) - int(b.rgba[4 * pixel + c])));
  return largest;
}

}  // namespace

class OutlinesPictureTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    m_studio = openStudio();
    if (!m_studio.absent.empty())
      QSKIP(m_studio.absent.c_str());
    QVERIFY2(m_studio.fault.empty(), m_studio.fault.c_str());
  }

  void areThoseOfTheDriver_data() {
    QTest::addColumn<int>("row");
    const std::vector<Row> all = rows();
    for (std::size_t i = 0; i < all.size(); ++i)
      QTest::newRow(all[i].name) << int(i);
  }

  void areThoseOfTheDriver() {
    QFETCH(int, row);
    const Row r = rows()[std::size_t(row)];
    model::Scene scene = bodies(r.gamma);
    if (r.cut)
      cut(scene, model::AnatomicalView::posterior, -4.0f);
    const model::Camera camera = slanted(r.height, r.perspective);
    std::vector<Outline> outlines;
    for (const std::vector<int>& places : r.outlined) {
      Outline& outline = outlines.emplace_back(Outline{.ink = ink});
      for (const int place : places)
        outline.structures.push_back(scene.nodes()[std::size_t(place)].id);
    }
    Window processor(PictureOptions::Painter::processor);
    Window driver(PictureOptions::Painter::driver);
    QVERIFY(processor.ok() && driver.ok());
    const auto plain = processor.draw(scene, camera, {}, r.surfaceStep);
    const auto plainDriver = driver.draw(scene, camera, {}, r.surfaceStep);
    const auto lined = processor.draw(scene, camera, outlines, r.surfaceStep);
    const auto linedDriver = driver.draw(scene, camera, outlines, r.surfaceStep);
    QVERIFY(plain && plainDriver && lined && linedDriver);
    std::size_t changed = 0;
    std::size_t differ = 0;
    for (std::size_t i = 0; i < plain->rgba.size() / 4; ++i) {
      if (apart(*plain, *plainDriver, i) > 2)
        continue;
      changed += apart(*lined, *plain, i) > 8;
      differ += apart(*lined, *linedDriver, i) > 4;
    }
    // A structure's rim is a pixel's matter of rounding, and so is what hides it there. While the
    // camera moves the processor takes a coarser form of the surface.
    const double allowed = r.surfaceStep > 1 ? 0.05 : 0.02;
    QVERIFY2(changed > 60, qPrintable(QString::number(changed)));
    QVERIFY2(double(differ) < allowed * double(changed),
             qPrintable(QString("%1 of %2").arg(differ).arg(changed)));
  }

  void areTheSameInMemory_data() { areThoseOfTheDriver_data(); }
  void areTheSameInMemory() {
    QFETCH(int, row);
    const Row r = rows()[std::size_t(row)];
    model::Scene scene = bodies(r.gamma);
    if (r.cut)
      cut(scene, model::AnatomicalView::posterior, -4.0f);
    const model::Camera camera = slanted(r.height, r.perspective);
    std::vector<Outline> outlines;
    for (const std::vector<int>& places : r.outlined) {
      Outline& outline = outlines.emplace_back(Outline{.ink = ink});
      for (const int place : places)
        outline.structures.push_back(scene.nodes()[std::size_t(place)].id);
    }
    PictureSettings asked = settings;
    asked.surfaceStep = r.surfaceStep;
    Window texture(PictureOptions::Painter::processor);
    PlainWindow memory;
    QVERIFY(texture.ok());
    for (const std::vector<Outline>& lines : {std::vector<Outline>(), outlines}) {
      const auto expected = texture.draw(scene, camera, lines, r.surfaceStep);
      const auto got = memory.image([&](render::Picture& picture, render::PictureTarget target) {
        return picture.drawInto({.target = target, .outlines = lines}, scene, camera, asked);
      });
      QVERIFY(expected && got);
      // What lies over the picture is rounded once more.
      QVERIFY(difference(*got, *expected).largest <= (lines.empty() ? 0 : 1));
    }
    if (r.surfaceStep > 1)
      return;
    const auto expected = texture.refine(scene, camera, outlines);
    const auto got = memory.image([&](render::Picture& picture, render::PictureTarget target) {
      return picture.refineInto({.target = target, .outlines = outlines}, scene, camera, settings);
    });
    QVERIFY(expected && got);
    QVERIFY(difference(*got, *expected).largest <= 2);
  }

  /// A picture has no other place to go than it has room for.
  void targetsOfAnotherSizeAreRefused() {
    const auto picture = render::Picture::withoutDriver({}, {});
    std::vector<std::uint32_t> pixels(20);
    const model::Scene scene = bodies(2.0f);
    for (const auto& target :
         {render::PictureTarget(settings.width, settings.height, pixels),
          render::PictureTarget(5, 4, pixels), render::PictureTarget(4, 4, pixels)})
      QVERIFY(!picture->drawInto({.target = target}, scene, slanted(190.0f, false), settings).ok());
  }

  /// A line that is hidden is weaker than one that is seen.
  void isWeakWhereHidden() {
    const model::Scene scene = bodies(5.0f);
    const model::Camera camera = frontal(190.0f);
    Window window(PictureOptions::Painter::processor);
    QVERIFY(window.ok());
    // The ball stands before the ring, and before most of the large ball.
    const auto blueness = [&](int place) {
      const auto plain = window.draw(scene, camera, {});
      const auto lined =
          window.draw(scene, camera, {{.structures = idsOf(scene, {place}), .ink = ink}});
      int most = 0;
      for (int y = 0; y < settings.height; ++y)
        for (int x = 0; x < settings.width; ++x) {
          const Pixel before = pixelAt(*plain, x, y);
          const Pixel after = pixelAt(*lined, x, y);
          most = std::max(most, (after.blue - after.red) - (before.blue - before.red));
        }
      return most;
    };
    const int seen = blueness(1);
    const int hidden = blueness(2);
    QVERIFY2(seen > 180 && hidden > 20 && 2 * hidden < seen,
             qPrintable(QString("%1 %2").arg(seen).arg(hidden)));
  }

  /// The structure's own style, another's, what is outlined, the camera: each picture is as if
  /// there had been none before.
  void whatIsKeptIsStillRight() {
    model::Scene scene = bodies(4.0f);
    model::Camera camera = slanted(190.0f, false);
    std::vector<Outline> outlines{{.structures = idsOf(scene, {0}), .ink = ink}};
    Window window(PictureOptions::Painter::processor);
    QVERIFY(window.ok());
    const auto changed = [&](int place, auto change) {
      std::vector<model::Node> nodes = scene.nodes();
      change(nodes[std::size_t(place)].style);
      scene.setNodes(std::move(nodes));
    };
    const auto gamma = [](float value) {
      return [value](model::Style& style) { style.gamma = Gamma::clamped(value); };
    };
    const std::vector<std::function<void()>> steps{
        [] {},
        [&] { changed(0, gamma(2.0f)); },
        [&] { changed(1, gamma(1.0f)); },
        [&] { changed(1, gamma(5.0f)); },
        [&] { changed(0, gamma(5.0f)); },
        [&] { changed(1, [](model::Style& style) { style.visible = false; }); },
        [&] {
          outlines[0].structures = idsOf(scene, {0, 2});
        },
        [&] { changed(2, gamma(3.0f)); },
        [&] {
          outlines.push_back({.structures = idsOf(scene, {3}), .ink = {200, 0, 0}});
        },
        [&] { outlines[0].width = 4.0f; },
        [&] { outlines.erase(outlines.begin()); },
        [&] { cut(scene, model::AnatomicalView::posterior, -2.0f); },
        [&] { changed(3, [](model::Style& style) { style.opacity = Opacity::clamped(0.0f); }); },
        [&] { changed(3, [](model::Style& style) { style.opacity = Opacity::clamped(1.0f); }); },
        [&] { camera.eye.x += 20.0f; },
    };
    for (std::size_t i = 0; i < steps.size(); ++i) {
      steps[i]();
      Window fresh(PictureOptions::Painter::processor);
      QVERIFY(fresh.ok());
      const auto kept = window.draw(scene, camera, outlines);
      const auto anew = fresh.draw(scene, camera, outlines);
      QVERIFY(kept && anew);
      QVERIFY2(difference(*kept, *anew).largest == 0, qPrintable(QString("step %1").arg(i)));
    }
  }

  /// Refining a picture leaves the line as it was, over finer pixels.
  void refinedPicturesHaveTheLine() {
    const model::Scene scene = bodies(5.0f);
    const model::Camera camera = slanted(190.0f, false);
    const std::vector<Outline> outlines{{.structures = idsOf(scene, {0}), .ink = ink}};
    Window window(PictureOptions::Painter::processor);
    QVERIFY(window.ok());
    const auto drawn = window.draw(scene, camera, outlines);
    const auto refined = window.refine(scene, camera, outlines);
    QVERIFY(drawn && refined);
    const auto blue = [&](const Image& image) {
      int count = 0;
      for (int y = 0; y < settings.height; ++y)
        for (int x = 0; x < settings.width; ++x)
          count += pixelAt(image, x, y).blue > pixelAt(image, x, y).red + 200;
      return count;
    };
    QVERIFY2(blue(*drawn) > 200, qPrintable(QString::number(blue(*drawn))));
    QVERIFY(std::abs(blue(*drawn) - blue(*refined)) < blue(*drawn) / 20);
  }

  /// Pictures that are drawn region by region have the line, too, wherever the structure lies: in
  /// some of them, at their rims or a little beside them.
  void isDrawnRegionByRegion() {
    model::Scene scene;
    // Its rim passes the middle of the picture, where regions meet.
    add(scene, moved(*sphere(20.0f, 4), 1.0f, {25.0f, 0.0f, 0.0f}), gammaStyle(5.0f));
    add(scene, moved(*sphere(70.0f, 4), 1.0f, {0.0f, 100.0f, 0.0f}), gammaStyle(5.0f));
    model::Camera camera = frontal(180.0f);
    const std::vector<Outline> outlines{{.structures = idsOf(scene, {0}), .ink = ink}};
    Window whole(PictureOptions::Painter::processor);
    Window regions(PictureOptions::Painter::processor, 128);
    QVERIFY(whole.ok() && regions.ok());
    for (int i = 0; i < 24; ++i) {
      camera.eye.x += 0.5f;  // one pixel
      camera.target.x += 0.5f;
      const auto plain = whole.draw(scene, camera, {});
      const auto expected = whole.draw(scene, camera, outlines);
      const auto lined = regions.draw(scene, camera, outlines);
      QVERIFY2(plain && expected && lined, qPrintable(QString::number(i)));
      std::size_t changed = 0;
      std::size_t differ = 0;
      for (std::size_t k = 0; k < plain->rgba.size() / 4; ++k) {
        changed += apart(*expected, *plain, k) > 8;
        differ += apart(*lined, *expected, k) > 16;
      }
      // At the rim of a region the line does not know what lies beyond.
      QVERIFY2(changed > 300 && differ < changed / 12,
               qPrintable(QString("%1: %2 of %3").arg(i).arg(differ).arg(changed)));
    }
  }

  /// What reaches behind the eye is left to a driver, and has its line all the same.
  void behindTheEyeADriverDraws() {
    model::Scene scene;
    add(scene, sphere(60.0f, 4), gammaStyle(5.0f));
    add(scene, moved(*sphere(12.0f, 4), 1.0f, {30.0f, 90.0f, 0.0f}), gammaStyle(5.0f));
    model::Camera camera = frontal(190.0f);
    camera.projection = model::Projection::perspective;
    camera.eye = {0.0f, -59.9f, 0.0f};
    Window window(PictureOptions::Painter::processor);
    QVERIFY(window.ok());
    const auto plain = window.draw(scene, camera, {});
    const auto lined = window.draw(scene, camera, {{.structures = idsOf(scene, {1}), .ink = ink}});
    QVERIFY(plain && lined);
    QVERIFY(difference(*plain, *lined).largest > 20);
  }

 private:
  Studio m_studio;
};

SLINE_TEST(OutlinesPictureTest)
#include "outlines_picture_test.moc"
