// SPDX-License-Identifier: Apache-2.0
// Tests textures of known steadiness: glued to the surface, fixed to the picture, hidden and shown.
#include "render/measures/steadiness.h"

#include <QtTest>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/geometry/spatial_order.h"
#include "render/measures/warp.h"
#include "tests/render/measures/pictures.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using render::Image;
using render::PixelValues;

namespace {

using Pixel = std::array<int, 4>;

model::Camera front(model::Projection projection) {
  return {.projection = projection,
          .eye = {0.0f, -300.0f, 40.0f},
          .target = {0.0f, 0.0f, 0.0f},
          .up = {0.0f, 0.0f, 1.0f},
          .fovyDegrees = 20.0f,
          .heightMm = 100.0f};
}

render::Turntable turntable(const model::MeshPtr& mesh, model::Projection projection) {
  return {.mesh = mesh,
          .camera = front(projection),
          .width = 240,
          .height = 180,
          .frames = 2,
          .printHeight = 240};
}

/// Returns a picture of the surface with ink as a function of the point.
template <class Ink>
render::HatchingPicture glued(const model::MeshPtr& mesh, const Ink& ink) {
  const auto bvh = std::make_shared<model::Bvh>(mesh, model::spatialOrder(*mesh));
  return [=](const model::Camera& camera, int width, int height) {
    const render::SeenSurface seen =
        render::seenSurface(*bvh, render::PictureView(camera, mesh->bounds(), width, height));
    return Result<Image>(painted(width, height, [&](int x, int y) {
      const std::size_t i = seen.index(x, y);
      const int grey = seen.seen[i] ? 255 - int(std::lround(255.0f * ink(seen.points[i]))) : 255;
      return Pixel{grey, grey, grey, 255};
    }));
  };
}

/// Returns such a picture with strokes of definite edges, each pixel the mean of four by four
/// samples.
template <class Inside>
render::HatchingPicture drawnStrokes(const model::MeshPtr& mesh, const Inside& inside) {
  constexpr int samples = 4;
  const auto bvh = std::make_shared<model::Bvh>(mesh, model::spatialOrder(*mesh));
  return [=](const model::Camera& camera, int width, int height) {
    const render::SeenSurface seen = render::seenSurface(
        *bvh, render::PictureView(camera, mesh->bounds(), samples * width, samples * height));
    return Result<Image>(painted(width, height, [&](int x, int y) {
      int count = 0;
      for (int i = 0; i < samples * samples; ++i) {
        const std::size_t k = seen.index(samples * x + i % samples, samples * y + i / samples);
        count += seen.seen[k] && inside(seen.points[k]);
      }
      const int grey = 255 - 255 * count / (samples * samples);
      return Pixel{grey, grey, grey, 255};
    }));
  };
}

float waves(const glm::vec3& p) {
  return 0.5f + 0.4f * std::sin(0.7f * p.x + 0.2f * p.y) * std::cos(0.6f * p.z);
}

render::HatchingPicture fixedToThePicture() {
  return [](const model::Camera&, int width, int height) {
    return Result<Image>(painted(width, height, [width](int x, int) {
      const int grey = x * 80 / width % 2 ? 255 : 0;
      return Pixel{grey, grey, grey, 255};
    }));
  };
}

/// Returns two plates, the near one in front of the left half of the far one.
model::MeshPtr plates() {
  std::vector<glm::vec3> positions;
  for (const auto& [y, low, high] : {std::array{-25.0f, -30.0f, 0.0f}, {25.0f, -30.0f, 30.0f}})
    for (const auto& [x, z] : {std::pair{low, -30.0f}, {high, -30.0f}, {high, 30.0f}, {low, 30.0f}})
      positions.emplace_back(x, y, z);
  auto mesh = model::Mesh::create(positions, {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}});
  return std::make_shared<const model::Mesh>(std::move(*mesh));
}

render::Flicker flickerOf(const render::Turntable& table, const render::HatchingPicture& draw,
                          int oversampling = 1) {
  const auto flickers =
      render::measureFlicker(table, std::array{render::HatchingWay{draw, oversampling}});
  return flickers.ok() ? flickers->front() : render::Flicker{.overSurface = -1.0};
}

}  // namespace

Q_DECLARE_METATYPE(model::Projection)

class SteadinessTest : public QObject {
  Q_OBJECT
 private slots:
  void gluedIsSteady_data();
  void gluedIsSteady();
  void oversamplingTellsFineStrokesFromUnsteadyOnes_data();
  void oversamplingTellsFineStrokesFromUnsteadyOnes();
  void fixedToThePictureIsNot();
  void drawnAnewEachTimeIsWorse();
  void onlyWhatBothSeeCounts();
  void turnedCamera();
  void warpFindsTheSamePoint();
  void midTonesAreLookedAtInPrint();
  void refusesWhatShowsNothing();
};

void SteadinessTest::gluedIsSteady_data() {
  QTest::addColumn<model::Projection>("projection");
  QTest::newRow("perspective") << model::Projection::perspective;
  QTest::newRow("orthographic") << model::Projection::orthographic;
}

void SteadinessTest::gluedIsSteady() {
  QFETCH(model::Projection, projection);
  const model::MeshPtr ball = sphere(40.0f, 4);
  const render::Flicker flicker = flickerOf(turntable(ball, projection), glued(ball, waves));
  // The rest is rounding to 8 bits and interpolation.
  QVERIFY2(flicker.overSurface >= 0.0 && flicker.overSurface < 0.004,
           qPrintable(QString::number(flicker.overSurface)));
  QVERIFY(flicker.hatchedShare > 0.99);
}

void SteadinessTest::oversamplingTellsFineStrokesFromUnsteadyOnes_data() {
  QTest::addColumn<int>("oversampling");
  QTest::addColumn<double>("least");
  QTest::addColumn<double>("most");
  QTest::newRow("interpolated from pixel to pixel") << 1 << 0.10 << 0.25;
  QTest::newRow("three times as fine") << 3 << 0.0 << 0.08;
}

void SteadinessTest::oversamplingTellsFineStrokesFromUnsteadyOnes() {
  QFETCH(int, oversampling);
  QFETCH(double, least);
  QFETCH(double, most);
  // These are strokes a pixel wide that move across themselves.
  const model::MeshPtr ball = sphere(40.0f, 4);
  render::Turntable table = turntable(ball, model::Projection::orthographic);
  table.width = 120;
  table.height = 90;
  table.frames = 1;
  const float pixel = 100.0f / 90.0f;
  const render::Flicker flicker =
      flickerOf(table,
                drawnStrokes(ball,
                             [=](const glm::vec3& p) {
                               const float u = p.x / (8.0f * pixel);
                               return 8.0f * std::abs(u - std::round(u)) < 0.5f;
                             }),
                oversampling);
  QVERIFY2(flicker.overHatching > least && flicker.overHatching < most,
           qPrintable(QString::number(flicker.overHatching)));
}

void SteadinessTest::fixedToThePictureIsNot() {
  const model::MeshPtr ball = sphere(40.0f, 4);
  const render::Turntable table = turntable(ball, model::Projection::orthographic);
  const render::Flicker flicker = flickerOf(table, fixedToThePicture());
  // The surface moves by up to 40 mm · 0.5°, that is 0.63 pixels, under stripes with an edge every
  // 3 pixels; over a ball's disc by two thirds of that on average.
  const double expected = 40.0 * std::numbers::pi / 360.0 * 180.0 / 100.0 * (2.0 / 3.0) / 3.0;
  QVERIFY2(std::abs(flicker.overSurface / expected - 1.0) < 0.15,
           qPrintable(QString("%1, not %2").arg(flicker.overSurface).arg(expected)));
  QVERIFY(flicker.overHatching > flicker.overSurface);
}

void SteadinessTest::drawnAnewEachTimeIsWorse() {
  const model::MeshPtr ball = sphere(40.0f, 4);
  int phase = 0;
  const render::HatchingPicture anew = [&](const model::Camera&, int width, int height) {
    ++phase;
    return Result<Image>(painted(width, height, [&](int x, int) {
      const int grey = (x * 40 / width + phase) % 2 ? 255 : 0;
      return Pixel{grey, grey, grey, 255};
    }));
  };
  const render::Flicker flicker = flickerOf(turntable(ball, model::Projection::perspective), anew);
  QVERIFY2(flicker.overSurface > 0.85, qPrintable(QString::number(flicker.overSurface)));
  QVERIFY(flicker.overHatching > 0.85);
}

void SteadinessTest::onlyWhatBothSeeCounts() {
  const model::MeshPtr mesh = plates();
  // Black in front, white behind: any pixel warped from the wrong plate would differ by 1.
  const auto twoTones = glued(mesh, [](const glm::vec3& p) { return p.y < 0.0f ? 1.0f : 0.0f; });
  render::Turntable table = turntable(mesh, model::Projection::perspective);
  table.frames = 4;
  const render::Flicker flicker = flickerOf(table, twoTones);
  QVERIFY2(flicker.overSurface >= 0.0 && flicker.overSurface < 1e-6,
           qPrintable(QString::number(flicker.overSurface)));
  QVERIFY(flicker.hatchedShare > 0.3 && flicker.hatchedShare < 0.7);
  QVERIFY(flicker.ink > 0.0 && flicker.ink <= flicker.hatchedShare + 1e-6);
}

void SteadinessTest::turnedCamera() {
  const model::Camera camera = front(model::Projection::perspective);
  const glm::vec3 middle{5.0f, 2.0f, -3.0f};
  const model::Camera quarter = render::turned(camera, middle, 90.0f);
  const auto close = [](float a, float b) { return std::abs(a - b) < 1e-3f; };
  QVERIFY(close(glm::distance(camera.eye, middle), glm::distance(quarter.eye, middle)));
  QVERIFY(
      close(glm::distance(camera.eye, camera.target), glm::distance(quarter.eye, quarter.target)));
  // The direction that was to the right now lies ahead or behind; the vertical stays.
  const model::CameraFrame before = model::cameraFrame(camera);
  const model::CameraFrame after = model::cameraFrame(quarter);
  QVERIFY(close(glm::dot(before.up, after.up), 1.0f));
  QVERIFY(close(glm::dot(before.right, after.right), 0.0f));
  QVERIFY(close(std::abs(glm::dot(before.right, after.back)), 1.0f));
  // A full turn in half degrees comes back.
  model::Camera round = camera;
  for (int i = 0; i < 720; ++i)
    round = render::turned(round, middle, 0.5f);
  QVERIFY(glm::distance(round.eye, camera.eye) < 0.1f);
}

void SteadinessTest::warpFindsTheSamePoint() {
  const model::MeshPtr ring = torus(30.0f, 10.0f, 96, 48);
  const model::Bvh bvh(ring, model::spatialOrder(*ring));
  const model::Camera camera = front(model::Projection::perspective);
  const render::PictureView before(camera, ring->bounds(), 160, 120);
  const render::PictureView after(render::turned(camera, glm::vec3(0.0f), 2.0f), ring->bounds(),
                                  160, 120);
  const render::SeenSurface seenBefore = render::seenSurface(bvh, before);
  const render::SeenSurface seenAfter = render::seenSurface(bvh, after);
  const auto warped = render::warp(seenAfter, seenBefore, before);
  std::size_t shown = 0;
  for (const std::uint8_t seen : seenAfter.seen)
    shown += seen;
  QVERIFY(warped.size() > shown / 2 && warped.size() <= shown);
  for (const render::WarpedPixel& w : warped) {
    const glm::vec3& point = seenAfter.points[w.pixel];
    const auto again = seenBefore.points[seenBefore.index(int(w.from.x), int(w.from.y))];
    QVERIFY(glm::distance(point, again) < 12.0f * before.millimetresPerPixel(point));
  }
}

void SteadinessTest::midTonesAreLookedAtInPrint() {
  // Edges one pixel wide at every size: nearly all of a small picture, next to none in print.
  const model::MeshPtr ball = sphere(40.0f, 4);
  render::Turntable table = turntable(ball, model::Projection::perspective);
  table.printHeight = 1080;
  const auto soft = [](const model::Camera&, int width, int height) -> Result<Image> {
    const int stripe = height / 20;
    return painted(width, height, [stripe](int x, int) {
      const int grey = x % stripe == 0 ? 128 : 0;
      return Pixel{grey, grey, grey, 255};
    });
  };
  const render::Flicker flicker = flickerOf(table, soft);
  QVERIFY(std::abs(flicker.midTones - 1.0 / 9.0) < 0.01);
  QVERIFY(std::abs(flicker.midTonesInPrint - 1.0 / 54.0) < 0.002);
}

void SteadinessTest::refusesWhatShowsNothing() {
  // Blank pictures are no steady hatching.
  const model::MeshPtr ball = sphere(40.0f, 4);
  const render::Turntable table = turntable(ball, model::Projection::perspective);
  const render::Flicker blank =
      flickerOf(table, glued(ball, [](const glm::vec3&) { return 0.0f; }));
  QVERIFY(!blank.anyHatching());
  const render::Steadiness steadiness{.strokes = blank, .asPrinted = blank};
  QVERIFY(!steadiness.ratio().has_value());
  QCOMPARE(render::faults(steadiness).size(), std::size_t(2));
  // A camera that looks away sees nothing in common.
  render::Turntable away = table;
  away.camera.target = {0.0f, -600.0f, 40.0f};
  const auto flickers =
      render::measureFlicker(away, std::array{render::HatchingWay{fixedToThePicture()}});
  QVERIFY(!flickers.ok());
  QVERIFY(flickers.error().reason.find("no surface in common") != std::string::npos);
}

SLINE_TEST_WITH_EVENTS(SteadinessTest)
#include "steadiness_test.moc"
