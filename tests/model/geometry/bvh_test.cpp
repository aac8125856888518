// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/bvh.h"

#include <QtTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "model/geometry/spatial_order.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;

namespace {
/// Returns the nearest hit by trying every triangle, in double precision.
std::optional<double> nearestByForce(const model::Mesh& mesh, const model::Ray& ray) {
  std::optional<double> best;
  const glm::dvec3 o = ray.origin;
  const glm::dvec3 d = ray.direction;
  for (const auto& [i, j, k] : mesh.triangles()) {
    const glm::dvec3 a = mesh.positions()[i];
    const glm::dvec3 b = mesh.positions()[j];
    const glm::dvec3 c = mesh.positions()[k];
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const double t = glm::dot(a - o, n) / glm::dot(d, n);
    const glm::dvec3 p = o + t * d;
    const bool inside = glm::dot(glm::cross(b - a, p - a), n) >= 0 &&
                        glm::dot(glm::cross(c - b, p - b), n) >= 0 &&
                        glm::dot(glm::cross(a - c, p - c), n) >= 0;
    if (inside && t >= double(ray.nearest) && t <= double(ray.farthest) && (!best || t < *best))
      best = t;
  }
  return best;
}
}  // namespace

class BvhTest : public QObject {
  Q_OBJECT
 private slots:
  void agreesWithForce() {
    const auto mesh = test::torus(10, 3, 60, 30);
    const model::Bvh bvh(mesh, model::spatialOrder(*mesh));
    std::mt19937 random(11);
    std::uniform_real_distribution<float> at(-20.0f, 20.0f);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
      model::Ray ray{.origin = {at(random), at(random), at(random)},
                     .direction = {at(random), at(random), at(random)}};
      if (i % 3 == 0)
        ray.nearest = 0.3f;
      if (i % 4 == 0)
        ray.farthest = 1.2f;
      const auto expected = nearestByForce(*mesh, ray);
      const auto hit = bvh.nearest(ray);
      QCOMPARE(hit.has_value(), expected.has_value());
      QCOMPARE(bvh.blocked(ray), expected.has_value());
      if (hit) {
        ++hits;
        QVERIFY(std::abs(double(hit->t) - *expected) < 1e-4);
        const auto& [a, b, c] = mesh->triangles()[hit->triangle];
        const auto p = mesh->positions();
        const glm::vec3 point = (1 - hit->u - hit->v) * p[a] + hit->u * p[b] + hit->v * p[c];
        QVERIFY(glm::distance(point, ray.origin + hit->t * ray.direction) < 1e-3f);
      }
    }
    QVERIFY(hits > 200);
  }

  void axisParallelRays() {
    const auto mesh = test::sphere(5, 3);
    const model::Bvh bvh(mesh, model::spatialOrder(*mesh));
    for (const glm::vec3 axis : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, -1)}) {
      const auto hit = bvh.nearest({.origin = -20.0f * axis + 0.01f, .direction = axis});
      QVERIFY(hit.has_value());
      QVERIFY(std::abs(hit->t - 15.0f) < 0.1f);
    }
  }

  void nothingToHit() {
    const auto empty =
        std::make_shared<const model::Mesh>(std::move(model::Mesh::create({}, {})).value());
    const model::Bvh bvh(empty, {});
    QVERIFY(!bvh.nearest({}).has_value());
    QVERIFY(!bvh.blocked({.direction = glm::vec3(0.0f)}));
    QVERIFY(std::isinf(bvh.closest({1, 2, 3}).distance));
    QVERIFY(!bvh.isWithin({1, 2, 3}, 1e9f));
  }

  // Also where whole boxes are near, and from right on the surface.
  void withinIsNearerThan() {
    const auto mesh = test::torus(10, 3, 60, 30);
    const model::Bvh bvh(mesh, model::spatialOrder(*mesh));
    std::mt19937 random(7);
    std::uniform_real_distribution<float> at(-20.0f, 20.0f);
    int near = 0;
    for (int i = 0; i < 1000; ++i) {
      const glm::vec3 point(at(random), at(random), 0.5f * at(random));
      const float distance = bvh.closest(point).distance;
      QVERIFY(!bvh.isWithin(point, distance));
      QVERIFY(bvh.isWithin(point, 1.001f * distance));
      const float some = std::abs(at(random));
      QCOMPARE(bvh.isWithin(point, some), distance < some);
      near += distance < some;
    }
    QVERIFY(near > 200 && near < 900);
    QVERIFY(bvh.isWithin(mesh->positions()[7], 1e-6f));
    QVERIFY(!bvh.isWithin(mesh->positions()[7], 0.0f));
  }

  void closestOnSphere() {
    // Seen from the centre's side and from outside, the foot is in a face, on an edge or on a
    // corner.
    const auto mesh = test::sphere(10, 4);
    const model::Bvh bvh(mesh, model::spatialOrder(*mesh));
    std::mt19937 random(5);
    std::uniform_real_distribution<float> at(-20.0f, 20.0f);
    for (int i = 0; i < 500; ++i) {
      const glm::vec3 point(at(random), at(random), at(random));
      const model::Closest closest = bvh.closest(point);
      QVERIFY(std::abs(closest.distance - std::abs(glm::length(point) - 10.0f)) < 0.03f);
      const auto& [a, b, c] = mesh->triangles()[closest.triangle];
      const glm::vec3 middle =
          (mesh->positions()[a] + mesh->positions()[b] + mesh->positions()[c]) / 3.0f;
      QVERIFY(glm::distance(glm::normalize(middle), glm::normalize(point)) < 0.1f ||
              glm::length(point) < 2.0f);
    }
    const model::Closest corner = bvh.closest(1.5f * mesh->positions()[7]);
    QVERIFY(std::abs(corner.distance - 5.0f) < 1e-4f);
  }
};

SLINE_TEST(BvhTest)
#include "bvh_test.moc"
