// SPDX-License-Identifier: Apache-2.0
// Tests which cells a triangle covers and where in the triangle they lie.
#include <QTest>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "render/sight/flat_triangle.h"
#include "tests/support/suite.h"

using namespace sline::render;

namespace {

const glm::vec3 even(1.0f);

/// Returns how often each cell is covered by triangles that fan out from a point to a polygon.
std::map<std::pair<int, int>, int> covered(const glm::vec2& middle,
                                           const std::vector<glm::vec2>& around,
                                           const PixelRect& area) {
  std::map<std::pair<int, int>, int> count;
  for (std::size_t i = 0; i < around.size(); ++i)
    FlatTriangle({middle, around[i], around[(i + 1) % around.size()]}, even)
        .forEachCell(area, [&](int x, int y, const glm::vec3&) {
          ++count[{x, y}];
        });
  return count;
}

}  // namespace

class FlatTriangleTest : public QObject {
  Q_OBJECT

 private slots:
  void fansLeaveNoGap();
  void sharesAreThoseOfSpace();
  void endsAtItsArea();
  void triangleOfNoNumbers_data();
  void triangleOfNoNumbers();
};

/// Triangles side by side cover all that the polygon holds, whatever their shape, and little twice.
void FlatTriangleTest::fansLeaveNoGap() {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> within(0.0f, 1.0f);
  const PixelRect area{-40, -40, 80, 80};
  int cells = 0;
  int twice = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<glm::vec2> around;
    for (int i = 0; i < 12; ++i) {
      const float angle = 6.2831853f * (float(i) + within(random)) / 12.0f;
      around.push_back(30.0f * glm::vec2(std::cos(angle), std::sin(angle)));
    }
    const glm::vec2 middle = 10.0f * glm::vec2(within(random) - 0.5f, within(random) - 0.5f);
    const auto count = covered(middle, around, area);
    for (int y = area.y; y < area.top(); ++y)
      for (int x = area.x; x < area.right(); ++x) {
        const glm::vec2 p(float(x) + 0.5f, float(y) + 0.5f);
        bool inside = true;  // of the polygon, which need not be round, but is convex
        for (std::size_t i = 0; i < around.size(); ++i) {
          const glm::vec2 a = around[i];
          const glm::vec2 b = around[(i + 1) % around.size()];
          inside = inside && (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0.0f;
        }
        if (!inside)
          continue;
        ++cells;
        const auto found = count.find({x, y});
        QVERIFY2(found != count.end(), qPrintable(QString("%1, %2").arg(x).arg(y)));
        twice += found->second > 1 ? 1 : 0;
      }
  }
  QVERIFY(cells > 100'000);
  QVERIFY2(twice < cells / 1000, qPrintable(QString::number(twice)));
}

/// Of a triangle in perspective the shares name the place that a ray through the cell meets.
void FlatTriangleTest::sharesAreThoseOfSpace() {
  const std::array<glm::vec3, 3> p{
      {{-20.0f, -12.0f, 60.0f}, {25.0f, 0.0f, 200.0f}, {0.0f, 30.0f, 90.0f}}};
  constexpr float scale = 100.0f;
  const auto flat = [&](const glm::vec3& at) { return scale * glm::vec2(at) / at.z; };
  const FlatTriangle seen({flat(p[0]), flat(p[1]), flat(p[2])},
                          1.0f / glm::vec3(p[0].z, p[1].z, p[2].z));
  const glm::vec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
  int cells = 0;
  seen.forEachCell({-100, -100, 200, 200}, [&](int x, int y, const glm::vec3& shares) {
    ++cells;
    QVERIFY(std::abs(shares.x + shares.y + shares.z - 1.0f) < 1e-5f);
    const glm::vec3 w = seen.inSpace(shares);
    const glm::vec3 place = w.x * p[0] + w.y * p[1] + w.z * p[2];
    const glm::vec3 ray((float(x) + 0.5f) / scale, (float(y) + 0.5f) / scale, 1.0f);
    const glm::vec3 met = glm::dot(normal, p[0]) / glm::dot(normal, ray) * ray;
    QVERIFY2(glm::distance(place, met) < 1e-2f, qPrintable(QString::number(double(place.z))));
  });
  QVERIFY2(cells > 500, qPrintable(QString::number(cells)));
}

void FlatTriangleTest::endsAtItsArea() {
  const FlatTriangle large({{{-1e7f, -1e7f}, {1e7f, -1e7f}, {0.0f, 2e7f}}}, even);
  const PixelRect area{3, -5, 4, 2};
  int cells = 0;
  large.forEachCell(area, [&](int x, int y, const glm::vec3&) {
    ++cells;
    QVERIFY(x >= 3 && x < 7 && y >= -5 && y < -3);
  });
  QCOMPARE(cells, 8);
  QVERIFY(FlatTriangle({{{0.0f, 0.0f}, {0.4f, 0.0f}, {0.0f, 0.4f}}}, even).box(area).empty());
  QVERIFY(large.box({0, 0, 0, 5}).empty());
}

void FlatTriangleTest::triangleOfNoNumbers_data() {
  QTest::addColumn<float>("x");
  QTest::newRow("no number") << std::numeric_limits<float>::quiet_NaN();
  QTest::newRow("without end") << std::numeric_limits<float>::infinity();
  QTest::newRow("seen on edge") << 0.0f;
}

void FlatTriangleTest::triangleOfNoNumbers() {
  QFETCH(float, x);
  int cells = 0;
  FlatTriangle({{{x, 0.0f}, {x, 9.0f}, {x, 5.0f}}}, even)
      .forEachCell({-10, -10, 20, 20}, [&](int, int, const glm::vec3&) { ++cells; });
  QCOMPARE(cells, 0);
}

SLINE_TEST(FlatTriangleTest)
#include "flat_triangle_test.moc"
