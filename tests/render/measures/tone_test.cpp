// SPDX-License-Identifier: Apache-2.0
#include "render/measures/tone.h"

#include <QtTest>
#include <array>
#include <cmath>

#include "tests/render/measures/pictures.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using render::Image;
using render::PixelMask;
using render::PixelValues;

class ToneTest : public QObject {
  Q_OBJECT
 private slots:
  void luminanceIsLinearLight_data();
  void luminanceIsLinearLight();
  void differenceIsAMeanOverTheRectangle_data();
  void differenceIsAMeanOverTheRectangle();
  void areasAndMasks();
  void blurStaysWithinTheMask();
  void blurTurnsStrokesIntoTone();
};

namespace {
using Pixel = std::array<int, 4>;

Image plain(int width, int height, const Pixel& pixel) {
  return painted(width, height, [&](int, int) { return pixel; });
}
}  // namespace

void ToneTest::luminanceIsLinearLight_data() {
  QTest::addColumn<int>("red");
  QTest::addColumn<int>("green");
  QTest::addColumn<int>("blue");
  QTest::addColumn<double>("luminance");
  QTest::newRow("black") << 0 << 0 << 0 << 0.0;
  QTest::newRow("white") << 255 << 255 << 255 << 1.0;
  // The value is ((128/255 + 0.055)/1.055)^2.4.
  QTest::newRow("half the display value") << 128 << 128 << 128 << 0.215861;
  QTest::newRow("below the bend: linear") << 10 << 10 << 10 << 10.0 / 255.0 / 12.92;
  QTest::newRow("red") << 255 << 0 << 0 << 0.2126;
  QTest::newRow("green") << 0 << 255 << 0 << 0.7152;
  QTest::newRow("blue") << 0 << 0 << 255 << 0.0722;
}

void ToneTest::luminanceIsLinearLight() {
  QFETCH(int, red);
  QFETCH(int, green);
  QFETCH(int, blue);
  QFETCH(double, luminance);
  const PixelValues values = render::luminance(plain(3, 2, {red, green, blue, 255}), {1, 0, 2, 2});
  QCOMPARE(values.values.size(), std::size_t(4));
  for (const float value : values.values)
    QVERIFY2(std::abs(value - luminance) < 1e-5, qPrintable(QString::number(value)));
}

void ToneTest::differenceIsAMeanOverTheRectangle_data() {
  QTest::addColumn<int>("width");
  QTest::addColumn<double>("expected");
  // The left half differs by 51/255 in green alone.
  QTest::newRow("left half") << 4 << 0.2 / 3.0;
  QTest::newRow("both halves") << 8 << 0.1 / 3.0;
}

void ToneTest::differenceIsAMeanOverTheRectangle() {
  QFETCH(int, width);
  QFETCH(double, expected);
  const Image a = plain(8, 4, {200, 100, 50, 255});
  const Image b = painted(8, 4, [](int x, int) { return Pixel{200, x < 4 ? 151 : 100, 50, 255}; });
  QCOMPARE(render::meanDifference(a, b, {0, 0, width, 4}), expected);
  QCOMPARE(render::meanDifference(b, a, {0, 0, width, 4}), expected);
}

void ToneTest::areasAndMasks() {
  const Image image = painted(20, 10, [](int x, int y) {
    const bool inside = x >= 3 && x < 9 && y >= 2 && y < 8;
    return inside ? Pixel{255, 254, 255, x == 3 ? 127 : 128} : Pixel{255, 255, 255, 0};
  });
  QCOMPARE(render::inkedArea(image), (render::PixelRect{3, 2, 6, 6}));
  QCOMPARE(render::coveredArea(image), (render::PixelRect{4, 2, 5, 6}));
  QVERIFY(render::coveredArea(plain(4, 4, {0, 0, 0, 127})).empty());
  QVERIFY(render::inkedArea(plain(4, 4, {255, 255, 255, 255})).empty());
  const PixelMask mask = render::coveredMask(image, {2, 1, 9, 8});
  QCOMPARE(mask.count(), std::size_t(5 * 6));
  QCOMPARE(render::shrunk(mask, 2).count(), std::size_t(1 * 2));
  // Pixels that the rectangle cuts off count as outside.
  QCOMPARE(render::shrunk(render::coveredMask(image, {5, 3, 3, 3}), 1).count(), std::size_t(1));
}

void ToneTest::blurStaysWithinTheMask() {
  PixelMask mask{.area = {0, 0, 30, 20}, .inside = std::vector<std::uint8_t>(600, 0)};
  PixelValues values{.width = 30, .height = 20, .values = std::vector<float>(600, 9.0f)};
  for (int y = 4; y < 15; ++y)
    for (int x = 6; x < 25; ++x) {
      mask.inside[std::size_t(30 * y + x)] = 1;
      values.values[std::size_t(30 * y + x)] = 0.25f;
    }
  const PixelValues blurred = render::MaskedBlur(mask, 3)(values);
  for (std::size_t i = 0; i < 600; ++i)
    QVERIFY(std::abs(blurred.values[i] - (mask.inside[i] ? 0.25f : 0.0f)) < 1e-5f);
}

void ToneTest::blurTurnsStrokesIntoTone() {
  const PixelMask mask{.area = {0, 0, 64, 64}, .inside = std::vector<std::uint8_t>(64 * 64, 1)};
  PixelValues strokes{.width = 64, .height = 64, .values = {}};
  for (int i = 0; i < 64 * 64; ++i)
    strokes.values.push_back(i % 4 == 0 ? 0.0f : 1.0f);
  const PixelValues blurred = render::MaskedBlur(mask, 5)(strokes);
  for (int y = 11; y < 53; ++y)
    for (int x = 11; x < 53; ++x)
      QVERIFY(std::abs(blurred.at(x, y) - 0.75f) < 0.02f);
}

SLINE_TEST_WITH_EVENTS(ToneTest)
#include "tone_test.moc"
