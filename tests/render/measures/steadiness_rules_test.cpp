// SPDX-License-Identifier: Apache-2.0
// Tests what the measure of steadiness is made of: samples, mid-tones, sizes in print and rules.
#include "render/measures/steadiness.h"

#include <QtTest>
#include <array>
#include <cmath>

#include "render/measures/warp.h"
#include "tests/render/measures/pictures.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using render::Image;
using render::PixelValues;

namespace {

using Pixel = std::array<int, 4>;

}  // namespace

class SteadinessRulesTest : public QObject {
  Q_OBJECT
 private slots:
  void samplesBetweenPixels();
  void midTones_data();
  void midTones();
  void printSize_data();
  void printSize();
  void rules_data();
  void rules();
};

void SteadinessRulesTest::samplesBetweenPixels() {
  PixelValues ramp{.width = 8, .height = 6, .values = {}};
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 8; ++x)
      ramp.values.push_back(0.1f * float(x) + 0.03f * float(y));
  for (const glm::vec2 place : {glm::vec2(3.5f, 2.5f), {4.0f, 3.0f}, {5.25f, 2.6f}}) {
    const float expected = 0.1f * (place.x - 0.5f) + 0.03f * (place.y - 0.5f);
    QVERIFY(std::abs(render::sample(ramp, place) - expected) < 1e-5f);
  }
  PixelValues edge{.width = 8, .height = 4, .values = {}};
  for (int i = 0; i < 32; ++i)
    edge.values.push_back(i % 8 < 4 ? 0.0f : 1.0f);
  for (float x = 2.0f; x < 6.0f; x += 0.1f) {
    const float value = render::sample(edge, {x, 2.0f});
    QVERIFY(value >= 0.0f && value <= 1.0f);
  }
}

void SteadinessRulesTest::midTones_data() {
  QTest::addColumn<int>("dark");
  QTest::addColumn<int>("middle");
  QTest::addColumn<int>("light");
  QTest::addColumn<double>("share");
  QTest::newRow("blank") << 0 << 0 << 0 << 0.0;
  QTest::newRow("black and white") << 50 << 0 << 0 << 0.0;
  QTest::newRow("a quarter") << 30 << 20 << 30 << 0.25;
  QTest::newRow("grey") << 0 << 40 << 0 << 1.0;
}

void SteadinessRulesTest::midTones() {
  QFETCH(int, dark);
  QFETCH(int, middle);
  QFETCH(int, light);
  const Image image = painted(100, 1, [&](int x, int) {
    const int grey = x < dark                    ? 40
                     : x < dark + middle         ? 128
                     : x < dark + middle + light ? 220
                                                 : 255;
    return Pixel{grey, grey, grey, 255};
  });
  QTEST(render::midToneShare(image), "share");
}

void SteadinessRulesTest::rules_data() {
  QTest::addColumn<double>("strokes");
  QTest::addColumn<double>("printed");
  QTest::addColumn<double>("middle");
  QTest::addColumn<double>("middleInPrint");
  QTest::addColumn<QStringList>("faults");
  QTest::newRow("as it should be") << 0.01 << 0.03 << 0.24 << 0.1 << QStringList{};
  QTest::newRow("restless") << 0.02 << 0.03 << 0.24 << 0.1
                            << QStringList{
                                   "strokes: change 67 % as much as hatching as printed does "
                                   "for as much ink, not at most 50 %"};
  QTest::newRow("soft on a screen") << 0.01 << 0.03 << 0.60 << 0.24 << QStringList{};
  QTest::newRow("smeared") << 0.01 << 0.03 << 0.60 << 0.26
                           << QStringList{
                                  "strokes: 26 % of hatched pixels are mid-tones in print, not at "
                                  "most 25 %"};
}

void SteadinessRulesTest::rules() {
  QFETCH(double, strokes);
  QFETCH(double, printed);
  QFETCH(double, middle);
  QFETCH(double, middleInPrint);
  QFETCH(QStringList, faults);
  const render::Steadiness steadiness{
      .strokes = {.overSurface = strokes,
                  .overHatching = 2.0 * strokes,
                  .hatchedShare = 0.5,
                  .ink = 0.04,
                  .midTones = middle,
                  .midTonesInPrint = middleInPrint},
      .asPrinted = {
          .overSurface = printed, .overHatching = printed, .hatchedShare = 0.5, .ink = 0.04}};
  QStringList found;
  for (const std::string& fault : render::faults(steadiness))
    found.append(QString::fromStdString(fault));
  QCOMPARE(found, faults);
  QCOMPARE(*steadiness.ratio(), strokes / printed);
  QCOMPARE(*steadiness.hatchedRatio(), 2.0 * strokes / printed);
  QCOMPARE(*steadiness.inkRatio(), strokes / printed);
}

void SteadinessRulesTest::printSize_data() {
  QTest::addColumn<int>("width");
  QTest::addColumn<int>("height");
  QTest::addColumn<QList<int>>("print");
  QTest::newRow("4:3") << 640 << 480 << QList<int>{2880, 2160};
  QTest::newRow("portrait") << 600 << 800 << QList<int>{1620, 2160};
  QTest::newRow("larger than print") << 9000 << 6000 << QList<int>{3240, 2160};
  QTest::newRow("a strip") << 2000 << 100 << QList<int>{20000, 1000};
  QTest::newRow("a column") << 16 << 20000 << QList<int>{2, 2160};
}

void SteadinessRulesTest::printSize() {
  QFETCH(int, width);
  QFETCH(int, height);
  QFETCH(QList<int>, print);
  const render::PictureSize size = render::printSize({.width = width, .height = height});
  QCOMPARE((QList<int>{size.width, size.height}), print);
}

SLINE_TEST_WITH_EVENTS(SteadinessRulesTest)
#include "steadiness_rules_test.moc"
