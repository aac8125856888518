// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/bezier_fit.h"

#include <QtTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/render/vectors/path_points.h"
#include "tests/support/suite.h"

using namespace sline;

namespace {

std::vector<glm::vec2> sampled(int count, const std::function<glm::vec2(float)>& at) {
  std::vector<glm::vec2> points;
  for (int i = 0; i <= count; ++i)
    points.push_back(at(float(i) / float(count)));
  return points;
}

float distanceTo(const std::vector<glm::vec2>& curve, const glm::vec2& p) {
  float nearest = 1e9f;
  for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
    const glm::vec2 d = curve[i + 1] - curve[i];
    const float t =
        std::clamp(glm::dot(p - curve[i], d) / std::max(glm::dot(d, d), 1e-20f), 0.0f, 1.0f);
    nearest = std::min(nearest, glm::distance(p, curve[i] + t * d));
  }
  return nearest;
}

}  // namespace

class BezierFitTest : public QObject {
  Q_OBJECT
 private slots:
  void staysWithinTolerance_data() {
    QTest::addColumn<int>("shape");
    QTest::addColumn<float>("tolerance");
    QTest::addColumn<int>("mostPieces");
    QTest::newRow("arc") << 0 << 0.2f << 3;
    QTest::newRow("arc, exact") << 0 << 0.02f << 6;
    QTest::newRow("wave") << 1 << 0.2f << 14;
    QTest::newRow("straight") << 2 << 0.05f << 1;
    QTest::newRow("spiral") << 3 << 0.2f << 24;
  }
  void staysWithinTolerance() {
    QFETCH(int, shape);
    QFETCH(float, tolerance);
    QFETCH(int, mostPieces);
    const auto points = sampled(400, [shape](float t) -> glm::vec2 {
      switch (shape) {
        case 0:
          return 100.0f * glm::vec2(std::cos(3.0f * t), std::sin(3.0f * t));
        case 1:
          return {200.0f * t, 20.0f * std::sin(20.0f * t)};
        case 2:
          return {200.0f * t, 30.0f * t};
        default:
          return 100.0f * t * glm::vec2(std::cos(18.0f * t), std::sin(18.0f * t));
      }
    });
    const render::Curve curve = render::fittedCurve(points, {.tolerance = tolerance});
    QVERIFY(!curve.closed);
    QVERIFY2(curve.pieces.size() <= std::size_t(mostPieces),
             qPrintable(QString::number(curve.pieces.size())));
    QCOMPARE(curve.start, points.front());
    QCOMPARE(curve.pieces.back().end, points.back());
    const std::vector<glm::vec2> on = test::pointsOn(curve, 64);
    for (const glm::vec2& p : points)
      QVERIFY2(distanceTo(on, p) <= 1.05f * tolerance,
               qPrintable(QString::number(distanceTo(on, p))));
    // The curve does not swing out between the points either.
    for (const glm::vec2& p : on)
      QVERIFY(distanceTo(points, p) <= 2.0f * tolerance);
  }

  void cornersStaySharp() {
    std::vector<glm::vec2> points;
    for (int i = 0; i <= 30; ++i)
      points.emplace_back(float(i), 0.0f);
    for (int i = 1; i <= 30; ++i)
      points.emplace_back(30.0f, float(i));
    const render::Curve curve = render::fittedCurve(points, {.tolerance = 0.3f});
    QCOMPARE(curve.pieces.size(), std::size_t(2));
    QCOMPARE(curve.pieces.front().end, glm::vec2(30.0f, 0.0f));
  }

  void loopsAreSmoothAndClosed() {
    auto points = sampled(200, [](float t) {
      return 50.0f * glm::vec2(std::cos(6.2831853f * t), std::sin(6.2831853f * t));
    });
    points.pop_back();
    const render::Curve curve = render::fittedLoop(points, 0.2f);
    QVERIFY(curve.closed);
    QVERIFY(curve.pieces.size() <= 8);
    QVERIFY(glm::distance(curve.start, curve.pieces.back().end) < 1e-4f);
    for (const glm::vec2& p : test::pointsOn(curve))
      QVERIFY(std::abs(glm::length(p) - 50.0f) < 0.35f);
    const glm::vec2 out = curve.pieces.front().control1 - curve.start;
    const glm::vec2 in = curve.start - curve.pieces.back().control2;
    QVERIFY(glm::dot(glm::normalize(out), glm::normalize(in)) > 0.99f);
  }

  void pointsThatSayNothing() {
    QVERIFY(render::fittedCurve({}, {}).pieces.empty());
    const std::vector<glm::vec2> same(5, glm::vec2(3.0f, 4.0f));
    QVERIFY(render::fittedCurve(same, {}).pieces.empty());
    QCOMPARE(render::fittedCurve(same, {}).start, glm::vec2(3.0f, 4.0f));
    QVERIFY(render::fittedLoop(same, 0.1f).pieces.empty());
  }
};

SLINE_TEST(BezierFitTest)
#include "bezier_fit_test.moc"
