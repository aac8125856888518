// SPDX-License-Identifier: Apache-2.0
#include "render/strokes/polyline_filter.h"

#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "tests/support/suite.h"

namespace sline::render {

class PolylineFilterTest : public QObject {
  Q_OBJECT

  static std::vector<glm::vec2> wave(float length, float amplitude) {
    std::vector<glm::vec2> points;
    for (int i = 0; i <= 400; ++i)
      points.emplace_back(
          float(i), amplitude * std::sin(2.0f * std::numbers::pi_v<float> * float(i) / length));
    return points;
  }
  PolylineFilter m_filter;

  static float amplitude(const std::vector<glm::vec2>& points) {
    float most = 0.0f;
    for (std::size_t i = 100; i < 300; ++i)
      most = std::max(most, std::abs(points[i].y));
    return most;
  }

 private slots:
  void averagesAsAGaussian() {
    for (const float length : {12.0f, 30.0f, 80.0f}) {
      std::vector<glm::vec2> points = wave(length, 5.0f);
      m_filter.blur(points, 6.0f, false);
      const float k = 2.0f * std::numbers::pi_v<float> * 6.0f / length;
      const float expected = 5.0f * std::exp(-0.5f * k * k);
      QVERIFY2(
          std::abs(amplitude(points) - expected) < 0.45f,
          qPrintable(QString("%1: %2, not %3").arg(length).arg(amplitude(points)).arg(expected)));
    }
  }
  void endsStay() {
    std::vector<glm::vec2> points = wave(37.0f, 5.0f);
    const glm::vec2 first = points.front();
    const glm::vec2 last = points.back();
    m_filter.blur(points, 9.0f, false);
    QVERIFY(glm::distance(points.front(), first) < 1e-3f);
    QVERIFY(glm::distance(points.back(), last) < 1e-3f);
  }
  void ringsHaveNoEnds() {
    std::vector<glm::vec2> ring;
    for (int i = 0; i < 90; ++i) {
      const float a = 2.0f * std::numbers::pi_v<float> * float(i) / 90.0f;
      ring.push_back(20.0f * glm::vec2(std::cos(a), std::sin(a)));
    }
    m_filter.blur(ring, 4.0f, true);
    for (const glm::vec2& p : ring)
      QVERIFY(std::abs(glm::length(p) - glm::length(ring.front())) < 1e-3f);
  }
  void softMinimumIsNowhereMore() {
    std::vector<float> values(60, 1.0f);
    values[20] = 0.3f;
    values[50] = 0.0f;
    for (const bool closed : {false, true}) {
      std::vector<float> soft = values;
      m_filter.softMinimum(soft, 5, closed);
      for (std::size_t i = 0; i < values.size(); ++i) {
        QVERIFY(soft[i] <= values[i] + 1e-6f);
        if (i > 0)
          QVERIFY(std::abs(soft[i] - soft[i - 1]) < 0.11f);
      }
      QCOMPARE(soft[35], 1.0f);
    }
  }
  void cornersAreFound() {
    std::vector<glm::vec2> bent;
    for (int i = 0; i <= 40; ++i)
      bent.emplace_back(float(i), 0.0f);
    for (int i = 1; i <= 40; ++i)
      bent.emplace_back(40.0f, float(i));
    QCOMPARE(m_filter.corners(bent, 8, false), std::vector<std::size_t>{40});
    std::vector<glm::vec2> slight;
    for (int i = 0; i <= 40; ++i)
      slight.emplace_back(float(i), 0.0f);
    for (int i = 1; i <= 40; ++i)
      slight.emplace_back(40.0f + 0.77f * float(i), 0.64f * float(i));  // 40°
    QVERIFY(m_filter.corners(slight, 8, false).empty());
  }
};

}  // namespace sline::render

SLINE_TEST(sline::render::PolylineFilterTest)
#include "polyline_filter_test.moc"
