// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/nearest_point.h"

#include <QtTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

class NearestPointTest : public QObject {
  Q_OBJECT
 private slots:
  void ofOneTriangle_data();
  void ofOneTriangle();
  void ofASphere();
  void ofNothing();
};

void NearestPointTest::ofOneTriangle_data() {
  QTest::addColumn<float>("x");
  QTest::addColumn<float>("y");
  QTest::addColumn<float>("nearX");
  QTest::addColumn<float>("nearY");
  QTest::newRow("inside") << 1.0f << 1.0f << 1.0f << 1.0f;
  QTest::newRow("first corner") << -1.0f << -2.0f << 0.0f << 0.0f;
  QTest::newRow("second corner") << 9.0f << -1.0f << 4.0f << 0.0f;
  QTest::newRow("third corner") << -1.0f << 9.0f << 0.0f << 4.0f;
  QTest::newRow("first side") << 2.0f << -3.0f << 2.0f << 0.0f;
  QTest::newRow("long side") << 4.0f << 4.0f << 2.0f << 2.0f;
  QTest::newRow("third side") << -3.0f << 1.0f << 0.0f << 1.0f;
}

void NearestPointTest::ofOneTriangle() {
  QFETCH(float, x);
  QFETCH(float, y);
  QFETCH(float, nearX);
  QFETCH(float, nearY);
  const auto mesh = Mesh::create({{0, 0, 5}, {4, 0, 5}, {0, 4, 5}}, {{0, 1, 2}});
  QVERIFY(mesh.ok());
  for (const float z : {5.0f, -7.0f}) {
    const auto found = nearestPoint(*mesh, {x, y, z});
    QVERIFY(found);
    QVERIFY(glm::length(found->place - glm::vec3(nearX, nearY, 5)) < 1e-5f);
    QVERIFY(std::abs(4 * found->weights[0] - nearX) < 1e-5f);
    QVERIFY(std::abs(4 * found->weights[1] - nearY) < 1e-5f);
  }
}

void NearestPointTest::ofASphere() {
  const MeshPtr mesh = test::sphere(10, 4);
  for (const glm::vec3 direction : {glm::vec3(1, 2, 3), glm::vec3(-4, 0, 1), glm::vec3(0, 0, -1)}) {
    const glm::vec3 out = glm::normalize(direction);
    for (const float distance : {3.0f, 25.0f}) {
      const auto found = nearestPoint(*mesh, distance * out);
      QVERIFY(found);
      const float away = glm::length(found->place - distance * out);
      QVERIFY(std::abs(away - std::abs(distance - 10.0f)) < 0.05f);
      QVERIFY(std::abs(glm::length(found->place) - 10.0f) < 0.05f);
      for (const glm::vec3& vertex : mesh->positions())
        QVERIFY(glm::length(vertex - distance * out) > away - 1e-4f);
    }
  }
}

void NearestPointTest::ofNothing() {
  const auto none = Mesh::create({{0, 0, 0}}, {});
  QVERIFY(none.ok() && !nearestPoint(*none, {1, 2, 3}));
  const auto line = Mesh::create({{0, 0, 0}, {4, 0, 0}, {8, 0, 0}}, {{0, 1, 2}});
  const auto found = nearestPoint(*line, {6, 1, 0});
  QVERIFY(found && glm::length(found->place - glm::vec3(6, 0, 0)) < 1e-5f);
}

SLINE_TEST(NearestPointTest)
#include "nearest_point_test.moc"
