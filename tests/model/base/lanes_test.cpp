// SPDX-License-Identifier: Apache-2.0
// Tests that four numbers at once give what they give one by one, to the last bit.
#include "model/base/lanes.h"

#include <QtTest>
#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>

#include "tests/support/suite.h"

using namespace sline;

namespace {
/// Four points whose coordinates have either sign, and one at the origin.
std::array<glm::vec3, laneCount> fourPoints(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> any(-3.0f, 3.0f);
  std::array<glm::vec3, laneCount> points;
  for (glm::vec3& p : points)
    p = {any(random), any(random), any(random)};
  points[seed % laneCount] = glm::vec3(0.0f, -0.0f, 0.0f);
  return points;
}

Vector<Lanes> lanesOf(const std::array<glm::vec3, laneCount>& p) {
  return {Lanes{p[0].x, p[1].x, p[2].x, p[3].x}, Lanes{p[0].y, p[1].y, p[2].y, p[3].y},
          Lanes{p[0].z, p[1].z, p[2].z, p[3].z}};
}
}  // namespace

class LanesTest : public QObject {
  Q_OBJECT
 private slots:
  void vectors() {
    for (unsigned seed = 0; seed < 50; ++seed) {
      const auto a = fourPoints(seed);
      const auto b = fourPoints(seed + 1);
      const Lanes dots = dot(lanesOf(a), lanesOf(b));
      const Vector<Lanes> crosses = cross(lanesOf(a), lanesOf(b));
      const Lanes lengths = squareRoot(dot(lanesOf(a), lanesOf(a)));
      for (std::size_t lane = 0; lane < laneCount; ++lane) {
        QVERIFY(dots[lane] == glm::dot(a[lane], b[lane]));
        QVERIFY(lengths[lane] == glm::length(a[lane]));
        QVERIFY(glm::vec3(crosses.x[lane], crosses.y[lane], crosses.z[lane]) ==
                glm::cross(a[lane], b[lane]));
      }
    }
  }

  void signs() {
    const Lanes signs = signOf(Lanes{2.0f, -0.5f, 0.0f, -0.0f});
    for (std::size_t lane = 0; lane < laneCount; ++lane)
      QCOMPARE(signs[lane], lane % 2 == 0 ? 1.0f : -1.0f);
    QCOMPARE(signOf(-0.0f), -1.0f);
  }

  void comparisons() {
    const Lanes a{1.0f, -2.0f, 3.0f, 0.5f};
    const Lanes b{0.0f, -1.0f, 3.0f, 0.25f};
    QCOMPARE(bitsOf(a > b), 0b1001u);
    QCOMPARE(bitsOf(a >= b), 0b1101u);
    QCOMPARE(bitsOf(a != a), 0u);
    for (std::size_t lane = 0; lane < laneCount; ++lane) {
      QCOMPARE(larger(a, b)[lane], std::max(a[lane], b[lane]));
      QCOMPARE(smaller(a, b)[lane], std::min(a[lane], b[lane]));
    }
  }

  void rowsBecomeColumns() {
    std::array<Lanes, laneCount> rows;
    for (std::size_t row = 0; row < laneCount; ++row)
      for (std::size_t column = 0; column < laneCount; ++column)
        rows[row][column] = float(10 * row + column);
    const std::array<Lanes, laneCount> columns = transposed(rows);
    for (std::size_t row = 0; row < laneCount; ++row)
      for (std::size_t column = 0; column < laneCount; ++column)
        QCOMPARE(columns[column][row], rows[row][column]);
  }
};

SLINE_TEST(LanesTest)
#include "lanes_test.moc"
