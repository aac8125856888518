// SPDX-License-Identifier: Apache-2.0
// Tests noise that is drawn out along the curvature: where it may be, which way it runs, and that
// it tells light and shade.
#include <QtTest>
#include <cmath>
#include <cstdlib>

#include "tests/render/picture/scenes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using render::Image;

namespace {

constexpr int side = 720;

/// Returns a style without lines, so that all ink is noise.
model::Style noisy(float gamma) {
  model::Style style = gammaStyle(gamma);
  style.technique = model::Technique::noiseLic;
  style.penWeight = 0.0f;
  style.opacity = Opacity::clamped(0.0f);
  return style;
}

/// Returns the mean ink within a rectangle.
double meanInk(const Image& image, int left, int right, int bottom, int top) {
  double sum = 0.0;
  for (int y = bottom; y < top; ++y)
    for (int x = left; x < right; ++x)
      sum += double(inkAt(image, x, y));
  return sum / double((right - left) * (top - bottom));
}

/// Returns the mean difference of ink between pixels that far apart, in the picture's middle.
double change(const Image& image, int dx, int dy) {
  double sum = 0.0;
  int count = 0;
  for (int y = side / 3; y < 2 * side / 3; ++y)
    for (int x = side / 2 - 100; x < side / 2 + 100; ++x) {
      sum += double(std::abs(inkAt(image, x, y) - inkAt(image, x + dx, y + dy)));
      ++count;
    }
  return sum / count;
}

}  // namespace

class NoiseLicTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    m_studio = openStudio();
    if (!m_studio.absent.empty())
      QSKIP(m_studio.absent.c_str());
    QVERIFY2(m_studio.fault.empty(), m_studio.fault.c_str());
  }

  void showsOnlyWhereItIsDue_data() {
    QTest::addColumn<float>("gamma");
    QTest::addColumn<bool>("part");
    QTest::addColumn<bool>("inked");
    QTest::newRow("contours") << 1.0f << true << false;
    QTest::newRow("on its way") << 2.0f << true << true;
    QTest::newRow("all of it") << 3.0f << true << true;
    QTest::newRow("shaded") << 5.0f << true << false;
    QTest::newRow("not asked for") << 3.0f << false << false;
  }
  void showsOnlyWhereItIsDue() {
    QFETCH(float, gamma);
    QFETCH(bool, part);
    QFETCH(bool, inked);
    const double ink = meanInk(ball(noisy(gamma), part), 0, side, 0, side);
    QVERIFY2(inked ? ink > 0.004 : ink == 0.0, qPrintable(QString::number(ink)));
  }

  void growsWithGamma() {
    double last = 0.0;
    for (const float gamma : {1.5f, 2.0f, 2.5f, 3.0f}) {
      const double ink = meanInk(ball(noisy(gamma)), 0, side, 0, side);
      QVERIFY(ink > last);
      last = ink;
    }
  }

  /// The light comes from the upper left.
  void liesInTheShade() {
    const Image image = ball(noisy(3.0f));
    const int near = side / 4;
    const int far = 3 * side / 4;
    const double upperLeft = meanInk(image, near - 40, near + 40, near - 40, near + 40);
    const double lowerRight = meanInk(image, far - 40, far + 40, far - 40, far + 40);
    const double most = std::max(upperLeft, lowerRight);
    const double least = std::min(upperLeft, lowerRight);
    QVERIFY2(most > 0.2 && least < 0.05,
             qPrintable(QString("%1 %2").arg(upperLeft).arg(lowerRight)));
  }

  /// Around a tube that stands upright strokes run across the picture.
  void runsAlongTheStrongerCurvature() {
    model::Scene upright;
    add(upright, cylinder(15, 80, 96, 160), noisy(3.0f));
    const Image image = picture(upright, {});
    const double across = change(image, 5, 0);
    const double along = change(image, 0, 5);
    QVERIFY2(across < 0.6 * along, qPrintable(QString("%1 %2").arg(across).arg(along)));
  }

 private:
  Image picture(const model::Scene& scene, const render::PictureContent& parts) {
    auto image = m_studio.picture->render(scene, frontal(72.0f),
                                          {.width = side, .height = side, .parts = parts});
    if (!image)
      qFatal("%s", image.error().text().c_str());
    return std::move(*image);
  }
  Image ball(const model::Style& style, bool hatching = true) {
    model::Scene scene;
    add(scene, sphere(30.0f, 5), style);
    return picture(scene, {.hatching = hatching});
  }

  Studio m_studio;
};

SLINE_TEST_WITH_EVENTS(NoiseLicTest)
#include "noise_lic_test.moc"
