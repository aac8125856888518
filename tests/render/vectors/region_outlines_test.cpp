// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/region_outlines.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/render/vectors/path_points.h"
#include "tests/support/suite.h"

using namespace sline;

namespace {

constexpr render::PixelRect area{100, 200, 120, 90};

std::vector<std::uint8_t> pixels(const std::function<bool(float, float)>& inside) {
  std::vector<std::uint8_t> found;
  for (int y = 0; y < area.height; ++y)
    for (int x = 0; x < area.width; ++x)
      found.push_back(inside(float(x) + 0.5f, float(y) + 0.5f));
  return found;
}

render::Path outlines(const std::vector<std::uint8_t>& inside, float smallest = 4.0f) {
  return render::regionOutlines(inside, area, smallest, 0.75f);
}

}  // namespace

class RegionOutlinesTest : public QObject {
  Q_OBJECT
 private slots:
  void discIsRound() {
    const auto inside = pixels([](float x, float y) { return std::hypot(x - 60, y - 45) < 30.0f; });
    const render::Path path = outlines(inside);
    QCOMPARE(path.size(), std::size_t(1));
    for (const glm::vec2& p : test::pointsOn(path.front()))
      QVERIFY(std::abs(std::hypot(p.x - 160.0f, p.y - 245.0f) - 30.0f) < 1.2f);
    QVERIFY(std::abs(test::areaOf(path.front()) - 2827.4f) < 60.0f);
  }

  void holesTurnTheOtherWay() {
    const auto inside = pixels([](float x, float y) {
      const float r = std::hypot(x - 60, y - 45);
      return r < 30.0f && r > 12.0f;
    });
    const render::Path path = outlines(inside);
    QCOMPARE(path.size(), std::size_t(2));
    const float a = test::areaOf(path[0]);
    const float b = test::areaOf(path[1]);
    QVERIFY(std::max(a, b) > 2700.0f);
    QVERIFY(std::min(a, b) < -400.0f);
  }

  void partsThatTouchAtACornerStayApart() {
    const auto inside =
        pixels([](float x, float y) { return (x < 40) == (y < 40) && x < 80 && y < 80; });
    QCOMPARE(outlines(inside).size(), std::size_t(2));
  }

  void specksAreLeftOut() {
    const auto inside = pixels([](float x, float y) {
      return (x < 20 && y < 20) || (x > 50 && x < 52 && y > 50 && y < 51);
    });
    QCOMPARE(outlines(inside, 4.0f).size(), std::size_t(1));
    QCOMPARE(outlines(inside, 1.0f).size(), std::size_t(2));
  }

  void wholeAndEmptyAreas() {
    QVERIFY(outlines(pixels([](float, float) { return false; })).empty());
    const render::Path whole = outlines(pixels([](float, float) { return true; }));
    QCOMPARE(whole.size(), std::size_t(1));
    QVERIFY(std::abs(test::areaOf(whole.front()) - 120.0f * 90.0f) < 60.0f);
  }
};

SLINE_TEST(RegionOutlinesTest)
#include "region_outlines_test.moc"
