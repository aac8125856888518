// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/bounding_sphere.h"

#include <QtTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "tests/support/suite.h"

using namespace sline::model;

class BoundingSphereTest : public QObject {
  Q_OBJECT
 private slots:
  void known_data() {
    QTest::addColumn<std::vector<glm::vec3>>("points");
    QTest::addColumn<float>("radius");
    using Points = std::vector<glm::vec3>;
    QTest::newRow("none") << Points{} << 0.0f;
    QTest::newRow("one") << Points{{3, 4, 5}} << 0.0f;
    QTest::newRow("two") << Points{{-2, 0, 0}, {2, 0, 0}} << 2.0f;
    QTest::newRow("same twice") << Points{{1, 1, 1}, {1, 1, 1}} << 0.0f;
    QTest::newRow("right triangle") << Points{{0, 0, 0}, {6, 0, 0}, {0, 8, 0}} << 5.0f;
    QTest::newRow("obtuse triangle") << Points{{-5, 0, 0}, {5, 0, 0}, {0, 1, 0}} << 5.0f;
    QTest::newRow("cube") << Points{{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                                    {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}}
                          << std::sqrt(3.0f);
    QTest::newRow("tetrahedron") << Points{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}
                                 << std::sqrt(3.0f);
  }
  void known() {
    QFETCH(std::vector<glm::vec3>, points);
    QFETCH(float, radius);
    QVERIFY(std::abs(smallestBoundingSphere(points).radius - radius) <= 1e-5f * radius + 1e-6f);
  }

  // For points inside a ball and a few on its surface that hold it fixed, the ball itself is the
  // answer.
  void heldBall() {
    std::mt19937 random(7);
    std::normal_distribution<float> normal;
    for (int round = 0; round < 20; ++round) {
      const glm::vec3 centre(100.0f * normal(random), normal(random), 0.0f);
      std::vector<glm::vec3> points;
      for (int i = 0; i < 500; ++i) {
        const glm::vec3 d =
            glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
        points.push_back(centre + 12.0f * d);
        points.push_back(centre - 12.0f * d);
        points.push_back(centre + 5.0f * d);
      }
      const Sphere ball = smallestBoundingSphere(points);
      QVERIFY(std::abs(ball.radius - 12.0f) < 2e-4f);
      QVERIFY(glm::distance(ball.centre, centre) < 2e-3f);
    }
  }
};

SLINE_TEST(BoundingSphereTest)
#include "bounding_sphere_test.moc"
