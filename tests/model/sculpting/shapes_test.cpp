// SPDX-License-Identifier: Apache-2.0
// Tests the shapes from which anatomy is built: their sizes, and that their distances are
// distances.
#include <QtTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "model/sculpting/implicit.h"
#include "model/sculpting/lamina.h"
#include "tests/support/suite.h"

using namespace sline;
using model::Field;

namespace {
glm::vec3 gradient(const Field& field, const glm::vec3& p) {
  constexpr float h = 0.05f;
  return glm::vec3(field(p + glm::vec3(h, 0, 0)) - field(p - glm::vec3(h, 0, 0)),
                   field(p + glm::vec3(0, h, 0)) - field(p - glm::vec3(0, h, 0)),
                   field(p + glm::vec3(0, 0, h)) - field(p - glm::vec3(0, 0, h))) /
         (2.0f * h);
}

/// Returns a quarter of a circle of that radius about the origin, in the plane z = 0.
template <class Point, class Make>
std::vector<Point> quarter(float radius, const Make& make) {
  std::vector<Point> points;
  for (int i = 0; i <= 6; ++i) {
    const float angle = glm::radians(15.0f * float(i));
    points.push_back(make(radius * glm::vec3(std::cos(angle), std::sin(angle), 0.0f)));
  }
  return points;
}
}  // namespace

class ShapesTest : public QObject {
  Q_OBJECT
 private slots:
  // On a bent tube the distance changes as if the bend were round, without facets.
  void bentTubeHasNoFacets() {
    const auto points = quarter<model::TubePoint>(30.0f, [](const glm::vec3& p) {
      return model::TubePoint{p, 5.0f};
    });
    const model::Tube tube(points, 4.0f);
    for (float angle = 20.0f; angle < 70.0f; angle += 0.37f)
      for (const float radius : {24.0f, 36.0f}) {
        const float a = glm::radians(angle);
        const glm::vec3 p = radius * glm::vec3(std::cos(a), std::sin(a), 0.0f);
        QVERIFY(std::abs(tube.distance(p) - 1.0f) < 0.03f);
        const glm::vec3 outward = (radius > 30.0f ? 1.0f : -1.0f) * p / radius;
        const glm::vec3 g = gradient([&](const glm::vec3& q) { return tube.distance(q); }, p);
        QVERIFY(glm::dot(glm::normalize(g), outward) > 0.9995f);
      }
  }

  void bandHasWidthAndThickness() {
    const model::Band band{{{0, 0, 0}, 10.0f, 2.0f, {0, 1, 0}},
                           {{30, 0, 0}, 10.0f, 2.0f, {0, 1, 0}}};
    QVERIFY(std::abs(band.distance({15, 12, 0}) - 2.0f) < 1e-3f);
    QVERIFY(std::abs(band.distance({15, 0, 2.5f}) - 0.5f) < 0.02f);
    QVERIFY(std::abs(band.distance({32.5f, 0, 0}) - 0.5f) < 0.02f);
    QVERIFY(band.distance({15, 9, 0.5f}) < 0.0f);
  }

  // The band makes a quarter turn from one end to the other.
  void bandTwists() {
    const model::Band band{{{0, 0, 0}, 8.0f, 2.0f, {0, 1, 0}},
                           {{20, 0, 0}, 8.0f, 2.0f, {0, 1, 1}},
                           {{40, 0, 0}, 8.0f, 2.0f, {0, 0, 1}}};
    QVERIFY(band.distance({1, 7, 0}) < 0.0f && band.distance({1, 0, 7}) > 3.0f);
    QVERIFY(band.distance({20, 5, 5}) < 0.0f && band.distance({20, 5, -5}) > 3.0f);
    QVERIFY(band.distance({39, 0, 7}) < 0.0f && band.distance({39, 7, 0}) > 3.0f);
  }

  void flatLamina() {
    const model::Lamina lamina({{{0, 0, 0}, 2.0f},
                                {{20, 0, 0}, 2.0f},
                                {{40, 0, 0}, 2.0f},
                                {{0, 30, 0}, 2.0f},
                                {{20, 30, 0}, 2.0f},
                                {{40, 30, 0}, 2.0f}},
                               3);
    QVERIFY(std::abs(lamina.distance({13, 17, 5}) - 3.0f) < 1e-3f);
    QVERIFY(std::abs(lamina.distance({13, 17, -5}) - 3.0f) < 1e-3f);
    QVERIFY(std::abs(lamina.distance({46, 12, 0}) - 4.0f) < 1e-3f);
    QVERIFY(std::abs(lamina.distance({43, 34, 0}) - 3.0f) < 1e-3f);  // a corner
    QVERIFY(std::abs(lamina.distance({7, -6, 0}) - 4.0f) < 1e-3f);
  }

  // The lamina is part of a cylinder about z, with no facets on either side.
  void bentLaminaHasNoFacets() {
    std::vector<model::LaminaPoint> points;
    for (const float z : {0.0f, 15.0f, 30.0f}) {
      const auto row = quarter<model::LaminaPoint>(40.0f, [z](const glm::vec3& p) {
        return model::LaminaPoint{p + glm::vec3(0, 0, z), 3.0f};
      });
      points.insert(points.end(), row.begin(), row.end());
    }
    const model::Lamina lamina(points, 7);
    for (float angle = 20.0f; angle < 70.0f; angle += 0.37f)
      for (const float radius : {36.0f, 44.0f}) {
        const float a = glm::radians(angle);
        const glm::vec3 p = glm::vec3(radius * std::cos(a), radius * std::sin(a), 12.0f);
        QVERIFY(std::abs(lamina.distance(p) - 1.0f) < 0.03f);
        const glm::vec3 outward =
            (radius > 40.0f ? 1.0f : -1.0f) * glm::vec3(p.x, p.y, 0.0f) / radius;
        const glm::vec3 g = gradient([&](const glm::vec3& q) { return lamina.distance(q); }, p);
        QVERIFY(glm::dot(glm::normalize(g), outward) > 0.999f);
      }
  }

  void blobTurns() {
    const model::Blob blob({5, 0, 0}, {10, 2, 3}, {0, 0, 90});
    QVERIFY(std::abs(blob.distance({5, 11, 0}) - 1.0f) < 1e-3f);
    QVERIFY(std::abs(blob.distance({8, 0, 0}) - 1.0f) < 1e-3f);
    QVERIFY(std::abs(blob.bounds().size().y - 20.0f) < 1e-3f);
    QVERIFY(std::abs(blob.bounds().size().x - 4.0f) < 1e-3f);
  }

  void mirrorImage() {
    const Field field = [](const glm::vec3& p) { return glm::distance(p, {10, 1, 2}) - 3.0f; };
    QVERIFY(std::abs(model::mirrored(field, 4.0f)({-2, 1, 2}) + 3.0f) < 1e-5f);
    const model::Box box = model::mirrored(model::Box{{0, 1, 2}, {6, 7, 8}}, 4.0f);
    QVERIFY(box == (model::Box{{2, 1, 2}, {8, 7, 8}}));
  }

  void wavesStayWithinOne() {
    float low = 1.0f;
    float high = -1.0f;
    for (int i = 0; i < 4000; ++i) {
      const float w =
          model::wave({0.37f * float(i), 0.11f * float(i % 97), -0.23f * float(i)}, 20.0f, 1.0f);
      low = std::min(low, w);
      high = std::max(high, w);
    }
    QVERIFY(low >= -1.0f && high <= 1.0f);
    QVERIFY(low < -0.5f && high > 0.5f);
  }
};

SLINE_TEST(ShapesTest)
#include "shapes_test.moc"
