// SPDX-License-Identifier: Apache-2.0
#include "model/sculpting/sculpture.h"

#include <QtTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/sculpting/sampled_field.h"
#include "tests/support/suite.h"

using namespace sline;

namespace {
float ball(const glm::vec3& p, float radius) {
  return glm::length(p) - radius;
}

model::SampledField sampledBall(float radius, model::SampledField::Fineness fineness) {
  const auto near = [radius](const glm::vec3&, float) -> model::Field {
    return [radius](const glm::vec3& p) { return ball(p, radius); };
  };
  return {near, {glm::vec3(-radius - 10.0f), glm::vec3(radius + 10.0f)}, fineness};
}

/// Returns where the field vanishes on the ray from the origin.
float radiusAlong(const model::Field& field, const glm::vec3& direction) {
  float inside = 0.0f;
  float outside = 40.0f;
  for (int i = 0; i < 30; ++i) {
    const float middle = 0.5f * (inside + outside);
    (field(middle * direction) < 0.0f ? inside : outside) = middle;
  }
  return inside;
}
}  // namespace

class SculptureTest : public QObject {
  Q_OBJECT
 private slots:
  void sampledBallKeepsItsRadius_data() {
    QTest::addColumn<float>("spacing");
    QTest::addColumn<float>("smoothing");
    QTest::newRow("fine") << 1.0f << 0.6f;
    QTest::newRow("coarse") << 2.0f << 1.2f;
    QTest::newRow("smoothed") << 1.5f << 2.5f;
  }
  // A Gaussian of variance s² moves the surface of a ball of radius r inwards by s²/r: the field's
  // Laplacian there is 2/r, and smoothing adds s²/2 times that.
  void sampledBallKeepsItsRadius() {
    QFETCH(float, spacing);
    QFETCH(float, smoothing);
    const model::SampledField field = sampledBall(20.0f, {spacing, smoothing});
    const auto distance = [&field](const glm::vec3& p) { return field.distance(p); };
    for (const glm::vec3 d :
         {glm::vec3(1, 0, 0), glm::vec3(0.6f, 0.8f, 0), glm::normalize(glm::vec3(-1, 2, 0.3f))}) {
      const float expected = 20.0f - smoothing * smoothing / 20.0f;
      QVERIFY(std::abs(radiusAlong(distance, d) - expected) < 0.05f);
    }
  }

  void farAwayIsALowerBoundOfTheSameSign() {
    const model::SampledField field = sampledBall(20.0f, {1.5f, 1.0f});
    for (float x = -60.0f; x <= 60.0f; x += 1.7f) {
      const glm::vec3 p(x, 0.3f * x, 4.0f);
      const float exact = ball(p, 20.0f);
      if (std::abs(exact) < 1.0f)
        continue;
      QVERIFY(field.distance(p) * exact > 0.0f);
      QVERIFY(std::abs(field.distance(p)) < std::abs(exact) + 1.0f);
    }
  }

  // Sampling looks only at the shapes that matter nearby; the result must not show it.
  void sampledAgreesWithItself() {
    model::Sculpture shape(0.0f);
    shape.addPlate(
        {{{{-20, -20, 0}, 3.0f}, {{20, -20, 2}, 4.0f}, {{-20, 20, 4}, 3.0f}, {{20, 20, 0}, 3.0f}},
         2},
        1.0f);
    shape.addTubePair({{{15, 0, -12}, 5.0f}, {{18, 0, 14}, 4.0f}}, 6.0f);
    shape.carveTube({{{0, 0, -10}, 6.0f}, {{0, 0, 10}, 6.0f}}, 3.0f);
    shape.cut({0, 17, 0}, {0, 1, 0}, 2.0f);
    const model::Field sampled = shape.sampled({0.8f, 0.46f});
    for (float x = -24.0f; x <= 24.0f; x += 2.3f)
      for (float y = -24.0f; y <= 22.0f; y += 2.3f)
        for (float z = -14.0f; z <= 16.0f; z += 2.3f) {
          const float exact = shape.distance({x, y, z});
          if (std::abs(exact) < 2.0f)
            QVERIFY(std::abs(sampled({x, y, z}) - exact) < 0.3f);
          else
            QVERIFY(sampled({x, y, z}) * exact > 0.0f);
        }
  }

  void pairsMirrorAndCutsRemove() {
    model::Sculpture shape(2.0f);
    shape.addTubePair({{{10, 0, 0}, 3.0f}, {{10, 0, 20}, 3.0f}}, 1.0f);
    QVERIFY(shape.distance({10, 0, 10}) < 0.0f);
    QVERIFY(shape.distance({-6, 0, 10}) < 0.0f);
    QVERIFY(std::abs(shape.distance({12, 1, 7}) - shape.distance({-8, 1, 7})) < 1e-4f);
    QVERIFY(shape.bounds().low.x <= -9.0f && shape.bounds().high.x >= 13.0f);
    shape.cut({0, 0, 15}, {0, 0, 1}, 1.0f);
    QVERIFY(shape.distance({10, 0, 18}) > 0.0f);
    QVERIFY(shape.distance({10, 0, 13}) < 0.0f);
  }
};

SLINE_TEST(SculptureTest)
#include "sculpture_test.moc"
