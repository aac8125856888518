// SPDX-License-Identifier: Apache-2.0
// Tests hatching in the picture: the same drawing at any size, mirrored by a mirror, hidden by its
// own surface, black and white.
#include <QtTest>
#include <cmath>

#include "tests/render/picture/scenes.h"
#include "tests/support/suite.h"

using namespace sline;

namespace {
/// Returns a fat ring, hollow side to the eye: much of its inner half is hatched.
model::Scene ring(bool mirrored = false) {
  const model::MeshPtr mesh =
      test::moved(*test::askew(*test::torus(10.0f, 7.0f, 240, 140)), 1.0f, {1.5f, 0.0f, -1.0f});
  model::Scene scene;
  test::add(scene, mirrored ? test::mirrored(*mesh) : mesh, test::gammaStyle(3.0f));
  return scene;
}

model::Camera above() {
  return {.projection = model::Projection::orthographic,
          .eye = {0, -60, 50},
          .target = {0, 0, 0},
          .up = {0, 0, 1},
          .heightMm = 36.0f};
}

render::PictureSettings hatchingOnly(int width, int height) {
  return {.width = width, .height = height, .parts = {.lines = false, .fills = false}};
}

double inkShare(const render::Image& image) {
  double sum = 0.0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      sum += double(test::inkAt(image, x, y));
  return sum / (double(image.width) * image.height);
}
}  // namespace

class HatchingPictureTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    m_studio = test::openStudio();
    if (!m_studio.absent.empty())
      QSKIP(m_studio.absent.c_str());
    QVERIFY2(m_studio.fault.empty(), m_studio.fault.c_str());
  }

  void twiceTheSizeIsTheSameDrawing() {
    const auto small = m_studio.picture->render(ring(), above(), hatchingOnly(960, 720));
    const auto large = m_studio.picture->render(ring(), above(), hatchingOnly(1920, 1440));
    QVERIFY(small.ok() && large.ok());
    const render::Image shrunk = test::halved(*large);
    const double ink = inkShare(*small);
    QVERIFY2(ink > 0.003, qPrintable(QString::number(ink)));
    QVERIFY(std::abs(inkShare(shrunk) / ink - 1.0) < 0.1);
    // Pixels at the edge of a stroke have another share of it; no pixel is white in one and black
    // in the other.
    int apart = 0;
    for (int y = 0; y < small->height; ++y)
      for (int x = 0; x < small->width; ++x)
        apart += std::abs(test::inkAt(*small, x, y) - test::inkAt(shrunk, x, y)) > 0.3f;
    QVERIFY2(apart < 0.02 * small->width * small->height, qPrintable(QString::number(apart)));
    QVERIFY2(apart < 0.05 * ink * small->width * small->height,
             qPrintable(QString("%1 pixels, ink %2").arg(apart).arg(ink)));
    QVERIFY(test::difference(*small, shrunk).share < 0.02);
  }

  void aMirrorMirrorsThePicture() {
    const auto here = m_studio.picture->render(ring(), above(), hatchingOnly(960, 720));
    render::PictureSettings settings = hatchingOnly(960, 720);
    // In a mirror the light is on the other side, too.
    settings.environment.light = model::upperLeftLight * glm::vec3(-1.0f, 1.0f, 1.0f);
    const auto there = m_studio.picture->render(ring(true), above(), settings);
    QVERIFY(here.ok() && there.ok());
    QVERIFY(inkShare(*here) > 0.003);
    // The pixels that differ lie along edges of strokes; and it is no picture of the same thing.
    const double apart = test::difference(*here, test::mirroredImage(*there)).share;
    const double unlike = test::difference(*here, *there).share;
    QVERIFY2(apart < 0.008 && unlike > 10.0 * apart,
             qPrintable(QString("%1, unmirrored %2").arg(apart).arg(unlike)));
  }

  void onlyWhereAskedFor_data() {
    QTest::addColumn<float>("gamma");
    QTest::addColumn<bool>("shows");
    QTest::newRow("2") << 2.0f << false;
    QTest::newRow("2.5") << 2.5f << true;
    QTest::newRow("4") << 4.0f << true;
    QTest::newRow("5") << 5.0f << false;
  }
  void onlyWhereAskedFor() {
    QFETCH(float, gamma);
    QFETCH(bool, shows);
    model::Scene scene = ring();
    std::vector<model::Node> nodes = scene.nodes();
    nodes.front().style.gamma = Gamma::clamped(gamma);
    scene.setNodes(nodes);
    render::PictureSettings settings = hatchingOnly(480, 360);
    const auto with = m_studio.picture->render(scene, above(), settings);
    QVERIFY(with.ok());
    QCOMPARE(inkShare(*with) > 0.0005, shows);
    settings.parts.hatching = false;
    const auto without = m_studio.picture->render(scene, above(), settings);
    QVERIFY(without.ok());
    QCOMPARE(inkShare(*without), 0.0);
  }

  // The far side of the ring's hollow, behind its near rim, shows no stroke: every pixel with ink
  // lies on the ring.
  void nothingShowsThrough() {
    model::Scene shaded = ring();
    std::vector<model::Node> nodes = shaded.nodes();
    nodes.front().style.gamma = Gamma::clamped(5.0f);
    shaded.setNodes(nodes);
    const auto strokes = m_studio.picture->render(ring(), above(), hatchingOnly(960, 720));
    const auto body = m_studio.picture->render(shaded, above(), {.width = 960, .height = 720});
    QVERIFY(strokes.ok() && body.ok());
    int outside = 0;
    for (int y = 2; y < 718; ++y)
      for (int x = 2; x < 958; ++x)
        if (test::inkAt(*strokes, x, y) > 0.5f) {
          bool near = false;
          for (int d = -2; d <= 2; ++d)
            near = near || test::inkAt(*body, x + d, y) > 0.02f ||
                   test::inkAt(*body, x, y + d) > 0.02f;
          outside += !near;
        }
    QCOMPARE(outside, 0);
  }

 private:
  test::Studio m_studio;
};

SLINE_TEST(HatchingPictureTest)
#include "hatching_picture_test.moc"
