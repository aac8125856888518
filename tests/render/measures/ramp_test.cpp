// SPDX-License-Identifier: Apache-2.0
// Tests the ramp's rules on pictures of known course.
#include "render/measures/ramp.h"

#include <QtTest>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include "tests/render/measures/pictures.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using render::Image;
using render::Ramp;
using render::RampPictures;

namespace {

using Pixel = std::array<int, 4>;
constexpr int width = 64;
constexpr int height = 48;
constexpr int left = 12;
constexpr int first = 9;
constexpr int side = 30;

bool inside(int x, int y) {
  return x >= left && x < left + side && y >= first && y < first + side;
}

int indexOf(Gamma gamma) {
  return int(std::lround(20.0f * gamma.value()));
}

/// Draws a grey square on white. `grey` and `opacity` (0 … 255) are functions of the picture's
/// index and, for squares of two halves, of the half.
struct Course {
  std::function<int(int index, int half)> grey;
  std::function<int(int index)> opacity;

  RampPictures pictures() const {
    return {.whole =
                [this](Gamma gamma) {
                  const int index = indexOf(gamma);
                  return Result<Image>(painted(width, height, [&](int x, int y) {
                    const int value = inside(x, y) ? grey(index, x < left + side / 2 ? 0 : 1) : 255;
                    return Pixel{value, value, value, 255};
                  }));
                },
            .fill =
                [this](Gamma gamma) {
                  const int index = indexOf(gamma);
                  return Result<Image>(painted(width, height, [&](int x, int y) {
                    return Pixel{90, 90, 90, inside(x, y) ? opacity(index) : 0};
                  }));
                }};
  }
};

int evenGrey(int index) {
  return 254 - 2 * index;
}
int closingFill(int index) {
  return index < 60 ? 0 : (255 * (index - 60)) / 40;
}

Course even() {
  return {.grey = [](int index, int) { return evenGrey(index); }, .opacity = closingFill};
}

double lightOf(int grey) {
  const double value = double(grey) / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

}  // namespace

Q_DECLARE_METATYPE(Course)

class RampTest : public QObject {
  Q_OBJECT
 private slots:
  void figuresOfAnEvenRamp();
  void rules_data();
  void rules();
  void halvesThatTurnInOppositeWays();
  void changesOutsideOfTheRectangleDoNotCount();
  void timingInvertsTheCourse_data();
  void timingInvertsTheCourse();
  void deadStretchesStayWithinAStage();
  void bumps_data();
  void bumps();
  void errorsAreHandedOn();
};

void RampTest::figuresOfAnEvenRamp() {
  const Course course = even();
  const auto ramp = render::measureRamp(course.pictures());
  QVERIFY(ramp.ok());
  QCOMPARE(ramp->area, (render::PixelRect{left, first, side, side}));
  QCOMPARE(ramp->pixels, std::size_t(side * side));
  QCOMPARE(ramp->steps.size(), std::size_t(100));
  for (const double step : ramp->steps)
    QCOMPARE(step, 2.0 / 255.0);
  for (const render::RampStage& stage : ramp->stages) {
    QVERIFY(std::abs(stage.largest - 1.0) < 1e-9);
    QVERIFY(std::abs(stage.weakest - 1.0) < 1e-9);
    QVERIFY(std::abs(stage.whole - 40.0 / 255.0) < 1e-9);
    QVERIFY(std::abs(stage.endToEnd - 40.0 / 255.0) < 1e-9);
  }
  QCOMPARE(ramp->tone.luminance.size(), std::size_t(101));
  for (const int i : {0, 37, 100})
    QVERIFY(std::abs(ramp->tone.luminance[std::size_t(i)] - lightOf(evenGrey(i))) < 1e-5);
  QVERIFY(std::abs(ramp->tone.lowest - 1.0) < 1e-6);
  QCOMPARE(ramp->tone.bumpedPixels, 0.0);
  QCOMPARE(ramp->fill.openAtEnd, 0.0);
  QCOMPARE(ramp->fill.largestFall, 0.0);
}

void RampTest::rules_data() {
  QTest::addColumn<Course>("course");
  QTest::addColumn<QStringList>("faults");
  const auto row = [](const char* name, const std::function<int(int)>& grey,
                      const std::function<int(int)>& opacity, const QStringList& faults) {
    QTest::newRow(name) << Course{.grey = [grey](int i, int) { return grey(i); },
                                  .opacity = opacity}
                        << faults;
  };
  row("even", evenGrey, closingFill, {});
  row("a jump", [](int i) { return evenGrey(i) - (i > 30 ? 10 : 0); }, closingFill,
      {"1–2: jumps by 4.8 times the mean at Γ = 1.50"});
  // The grey stands still over 2.20 … 2.45, then catches up.
  row("a dead stretch",
      [](int i) { return i < 44 || i >= 60 ? evenGrey(i)
                         : i < 49          ? 166
                                           : 166 - 2 * (i - 48); },
      closingFill,
      {"2–3: nearly nothing changes in Γ = 2.20–2.40 (at worst 0 % of the mean rate)",
       "2–3: jumps by 5.0 times the mean at Γ = 2.95"});
  row("an exempt stage", [](int i) { return i < 20   ? 250 - i
                                            : i < 40 ? 230
                                                     : 270 - i; },
      closingFill, {});
  row("dark hatching", [](int i) { return i < 60   ? 255 - 3 * i
                                          : i < 80 ? 75 - i + 60
                                                   : i - 25; },
      closingFill, {"tone: 45.7 % darker at Γ = 4.00 than at Γ = 5"});
  row("light, then dark",
      [](int i) { return i < 60   ? 240 - 3 * i
                         : i < 80 ? 60 + (i - 60)
                                  : 80 - (i - 80); },
      closingFill, {"tone: 77.5 % lighter at Γ = 4.00 than before and after"});
  row("a fill that shrinks", evenGrey, [](int i) { return i == 90 ? 100 : closingFill(i); },
      {"fill: opacity falls by 0.329 at Γ = 4.50"});
  row("a fill that stays open", evenGrey, [](int i) { return closingFill(i) * 249 / 255; },
      {"fill: 100.0 % of the structure is not filled at Γ = 5"});
  row("rounding is no fall", evenGrey, [](int i) { return closingFill(i) - (i == 85); }, {});
}

void RampTest::rules() {
  QFETCH(Course, course);
  QFETCH(QStringList, faults);
  const auto ramp = render::measureRamp(course.pictures());
  QVERIFY(ramp.ok());
  QStringList found;
  for (const std::string& fault : render::faults(*ramp))
    found.append(QString::fromStdString(fault));
  found.sort();
  faults.sort();
  QCOMPARE(found, faults);
}

void RampTest::halvesThatTurnInOppositeWays() {
  // One half darkens while the other lightens as much, and back again.
  const auto wave = [](int index) { return index < 50 ? index : 100 - index; };
  const Course course{
      .grey = [&](int index,
                  int half) { return half == 0 ? 120 + wave(index) : 200 - wave(index); },
      .opacity = [](int) { return 255; }};
  const auto ramp = render::measureRamp(course.pictures());
  QVERIFY(ramp.ok());
  const double share = ramp->tone.bumpedPixels;
  // The share is half of the pixels, except for the blur over the border between the halves.
  QVERIFY2(share > 0.42 && share < 0.55, qPrintable(QString::number(share)));
  QVERIFY(std::abs(ramp->tone.bumpedByStage[2] - share) < 1e-9);
}

void RampTest::changesOutsideOfTheRectangleDoNotCount() {
  const Course course = even();
  RampPictures pictures = course.pictures();
  // A pixel flickers elsewhere, except where the rectangle is found.
  pictures.whole = [whole = pictures.whole](Gamma gamma) {
    Result<Image> image = whole(gamma);
    if (indexOf(gamma) % 2 == 1)
      image->rgba[0] = 0;
    return image;
  };
  const auto ramp = render::measureRamp(pictures);
  QVERIFY(ramp.ok());
  for (const double step : ramp->steps)
    QCOMPARE(step, 2.0 / 255.0);
}

void RampTest::timingInvertsTheCourse_data() {
  QTest::addColumn<double>("power");
  QTest::newRow("even") << 1.0;
  QTest::newRow("late") << 2.0;
  QTest::newRow("early") << 0.5;
}

void RampTest::timingInvertsTheCourse() {
  QFETCH(double, power);
  std::array<double, 20> steps{};
  for (int i = 0; i < 20; ++i)
    steps[std::size_t(i)] = 0.3 * (std::pow((i + 1) / 20.0, power) - std::pow(i / 20.0, power));
  const render::RampStage stage = render::measureStage(steps, 1.0, 0.3);
  QVERIFY(std::abs(stage.whole - 0.3) < 1e-12);
  for (int k = 1; k <= 9; ++k) {
    const double expected = std::pow(0.1 * k, 1.0 / power);
    QVERIFY2(std::abs(stage.timing[std::size_t(k - 1)] - expected) < 0.013,
             qPrintable(QString("%1 not %2").arg(stage.timing[std::size_t(k - 1)]).arg(expected)));
  }
}

void RampTest::deadStretchesStayWithinAStage() {
  std::array<double, 20> steps{};
  steps.fill(0.01);
  // One dead step alone halves its stretches; two make one stretch dead.
  steps[4] = 0.0;
  QVERIFY(!render::measureStage(steps, 3.0, 0.1).stalls());
  steps[5] = 0.0;
  const render::RampStage stage = render::measureStage(steps, 3.0, 0.1);
  QCOMPARE(stage.dead.size(), std::size_t(1));
  QVERIFY(std::abs(stage.dead.front() - 3.2) < 1e-9);
  QVERIFY(std::abs(stage.weakestAt - 3.2) < 1e-9);
  // The last step has no neighbour within the stage.
  steps.fill(0.01);
  steps[19] = 0.0;
  QVERIFY(!render::measureStage(steps, 3.0, 0.1).stalls());
  // A stage without any change is exempt, not a stall.
  steps.fill(0.0);
  QVERIFY(render::measureStage(steps, 3.0, 0.0).exempt());
  QVERIFY(!render::measureStage(steps, 3.0, 0.0).stalls());
}

void RampTest::bumps_data() {
  QTest::addColumn<QList<double>>("series");
  QTest::addColumn<double>("height");
  QTest::addColumn<int>("at");
  QTest::newRow("none") << QList<double>{} << 0.0 << 0;
  QTest::newRow("falls") << QList<double>{3, 2, 1} << 0.0 << 0;
  QTest::newRow("rises") << QList<double>{1, 2, 3} << 0.0 << 0;
  QTest::newRow("valley") << QList<double>{3, 1, 2} << 0.0 << 0;
  QTest::newRow("rises less than it falls") << QList<double>{4, 5, 1} << 1.0 << 1;
  QTest::newRow("falls less than it rises") << QList<double>{1, 5, 3} << 2.0 << 1;
  QTest::newRow("the larger of two") << QList<double>{1, 2, 1, 4, 2} << 2.0 << 3;
  QTest::newRow("over a dent") << QList<double>{0, 3, 2.5, 3.5, 0.5} << 3.0 << 3;
}

void RampTest::bumps() {
  QFETCH(QList<double>, series);
  QFETCH(double, height);
  QFETCH(int, at);
  const std::vector<double> values(series.begin(), series.end());
  const render::Bump bump = render::largestBump(values);
  QCOMPARE(bump.height, height);
  QCOMPARE(bump.at, at);
}

void RampTest::errorsAreHandedOn() {
  Course course = even();
  course.opacity = [](int) { return 0; };
  const auto nothing = render::measureRamp(course.pictures());
  QVERIFY(!nothing.ok());
  QVERIFY(nothing.error().reason.find("covers no pixel") != std::string::npos);
  course = even();
  RampPictures pictures = course.pictures();
  pictures.whole = [whole = pictures.whole](Gamma gamma) {
    return gamma.value() > 2.0f && gamma.value() < 5.0f
               ? Result<Image>(Error{.reason = "the driver is gone"})
               : whole(gamma);
  };
  const auto failed = render::measureRamp(pictures);
  QVERIFY(!failed.ok());
  QCOMPARE(failed.error().reason, std::string("the driver is gone"));
}

SLINE_TEST_WITH_EVENTS(RampTest)
#include "ramp_test.moc"
