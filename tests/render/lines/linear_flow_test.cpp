// SPDX-License-Identifier: Apache-2.0
// Compares the closed form of streamlines in a triangle with known solutions and with Runge and
// Kutta's steps.
#include "render/lines/streamlines/linear_flow.h"

#include <QtTest>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "tests/support/suite.h"

using sline::render::exitWithin;
using sline::render::LinearFlow;

namespace {

/// Returns the field a·(α, β) + e with the matrix given row by row.
LinearFlow flowOf(const std::array<double, 4>& a, const glm::dvec2& e) {
  return {e, e + glm::dvec2(a[0], a[2]), e + glm::dvec2(a[1], a[3])};
}

glm::dvec2 rungeKutta(const LinearFlow& flow, glm::dvec2 at, double t, int steps) {
  const double h = t / steps;
  for (int i = 0; i < steps; ++i) {
    const glm::dvec2 k1 = flow.velocity(at);
    const glm::dvec2 k2 = flow.velocity(at + 0.5 * h * k1);
    const glm::dvec2 k3 = flow.velocity(at + 0.5 * h * k2);
    const glm::dvec2 k4 = flow.velocity(at + h * k3);
    at += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return at;
}

}  // namespace

class LinearFlowTest : public QObject {
  Q_OBJECT
 private slots:
  // Rotation, saddle, node, shears and uniform fields about a centre at which they vanish (where
  // they do): their streamlines are known.
  void isExact_data() {
    QTest::addColumn<double>("a");
    QTest::addColumn<double>("b");
    QTest::addColumn<double>("c");
    QTest::addColumn<double>("d");
    QTest::newRow("rotation") << 0.0 << -1.0 << 1.0 << 0.0;
    QTest::newRow("saddle") << 1.0 << 0.0 << 0.0 << -1.0;
    QTest::newRow("node") << -1.0 << 0.0 << 0.0 << -2.5;
    QTest::newRow("star") << 1.5 << 0.0 << 0.0 << 1.5;
    QTest::newRow("spiral") << -0.4 << -2.0 << 2.0 << -0.4;
    QTest::newRow("degenerate node") << 1.0 << 1.0 << 0.0 << 1.0;
    QTest::newRow("shear") << 0.0 << 1.0 << 0.0 << 0.0;
    QTest::newRow("one way") << 2.0 << 0.0 << 0.0 << 0.0;
    QTest::newRow("all but a star") << 1.0 << 1e-7 << 1e-7 << 1.0 + 1e-9;
  }
  void isExact() {
    QFETCH(double, a);
    QFETCH(double, b);
    QFETCH(double, c);
    QFETCH(double, d);
    const glm::dvec2 centre(0.3, 0.4);
    const std::array<double, 4> m{a, b, c, d};
    const LinearFlow flow =
        flowOf(m, {-(a * centre.x + b * centre.y), -(c * centre.x + d * centre.y)});
    const glm::dvec2 from(0.25, 0.6);
    const glm::dvec2 x = from - centre;
    for (const double t : {-3.0, -0.3, -1e-4, 0.0, 1e-9, 1e-3, 0.2, 0.49, 0.51, 1.0, 4.0}) {
      glm::dvec2 expected(0.0);
      if (a == d && b == -c && b != 0.0) {
        const double grown = std::exp(a * t);
        expected = grown * glm::dvec2(std::cos(c * t) * x.x - std::sin(c * t) * x.y,
                                      std::sin(c * t) * x.x + std::cos(c * t) * x.y);
      } else if (b == 0.0 || c == 0.0) {
        expected = {std::exp(a * t) * x.x, std::exp(d * t) * x.y};
        expected.x += b * t * std::exp(a * t) * x.y;  // where b is not zero, a = d
      } else {
        // A symmetric matrix: along both axes that b turns.
        const double turn = 0.5 * std::atan2(2.0 * b, a - d);
        const glm::dvec2 u(std::cos(turn), std::sin(turn));
        const glm::dvec2 v(-u.y, u.x);
        const double apart = std::hypot(0.5 * (a - d), b);
        const double mean = 0.5 * (a + d);
        expected = std::exp((mean + apart) * t) * glm::dot(u, x) * u +
                   std::exp((mean - apart) * t) * glm::dot(v, x) * v;
      }
      const glm::dvec2 found = flow.at(from, t) - centre;
      const double error = glm::length(found - expected);
      QVERIFY2(error <= 1e-9 * std::max(glm::length(expected), glm::length(x)),
               qPrintable(QString("at %1: %2").arg(t).arg(error)));
    }
  }

  void uniformFieldsAreStraight() {
    const LinearFlow flow({0.5, -2.0}, {0.5, -2.0}, {0.5, -2.0});
    QVERIFY(glm::length(flow.at({0.1, 0.9}, 0.4) - glm::dvec2(0.3, 0.1)) < 1e-15);
  }

  /// Any matrices, singular ones among them, against small steps over the same time.
  void agreesWithRungeAndKutta() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-3.0, 3.0);
    for (int i = 0; i < 400; ++i) {
      std::array<double, 4> a{number(random), number(random), number(random), number(random)};
      if (i % 4 == 1)
        a[3] = a[1] * a[2] / a[0];
      if (i % 4 == 2)
        a = {a[0], a[1], 0.0, a[0] + 1e-6 * a[2]};
      const LinearFlow flow = flowOf(a, {number(random), number(random)});
      const glm::dvec2 from(0.2, 0.3);
      const glm::dvec2 stepped = rungeKutta(flow, from, 0.8, 4000);
      const glm::dvec2 found = flow.at(from, 0.8);
      QVERIFY(glm::length(found - stepped) <= 1e-9 * (1.0 + glm::length(stepped)));
    }
  }

  /// The place where a line leaves lies on the side that is named, and it was inside before.
  void exitsAreOnTheirSide() {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    int exits = 0;
    for (int i = 0; i < 2000; ++i) {
      const LinearFlow flow =
          flowOf({number(random), number(random), number(random), number(random)},
                 {number(random), number(random)});
      const glm::dvec2 from(0.3, 0.35);
      const auto exit = exitWithin(flow, from, 0.6);
      if (!exit) {
        for (const double c : sline::render::barycentric(flow.at(from, 0.6)))
          QVERIFY(c >= 0.0);
        continue;
      }
      ++exits;
      const auto at = sline::render::barycentric(exit->at);
      QVERIFY(std::abs(at[std::size_t(exit->side)]) < 1e-12);
      for (const double c : at)
        QVERIFY(c > -1e-12);
      for (const double c : sline::render::barycentric(flow.at(from, 0.999 * exit->time)))
        QVERIFY(c > 0.0);
      QVERIFY(glm::length(exit->at - rungeKutta(flow, from, exit->time, 1000)) < 1e-9);
    }
    QVERIFY(exits > 500 && exits < 1900);
  }
};

SLINE_TEST(LinearFlowTest)
#include "linear_flow_test.moc"
